#include "reference/visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "brdf/shading.h"
#include "core/on_threads.h"
#include "reference/placed_scene.h"

namespace telar::reference {
namespace {

constexpr std::size_t ROW_VERTICES = 256;  ///< vertices that a thread takes at once

/// The van der Corput sequence in base 2, 0..1.
float radicalInverse(std::uint32_t i) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit, i >>= 1) reversed = reversed << 1 | (i & 1);
  return static_cast<float>(reversed >> 8) * 0x1p-24f;
}

/// Hammersley's points by the cosine about +z (Malley's method). All vertices take the same ones: what they do not see
/// then differs from vertex to vertex as smoothly as the surface does.
std::vector<glm::vec3> hemisphere(int count) {
  std::vector<glm::vec3> out;
  for (int i = 0; i < count; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float r = std::sqrt(u), phi = glm::two_pi<float>() * radicalInverse(static_cast<std::uint32_t>(i));
    out.emplace_back(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u));
  }
  return out;
}

/// Of the vertices, world, unit: the file's, else by area of the triangles about each. 0 where there is none.
std::vector<glm::vec3> normalsOf(const PlacedMesh& mesh) {
  std::vector<glm::vec3> out(mesh.positions.size(), glm::vec3(0));
  const auto& own = mesh.primitive->normals;
  for (std::size_t i = 0; i < own.size(); ++i) out[i] = mesh.normalMatrix * own[i];
  if (own.empty()) {
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 n =
          glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
      for (int k = 0; k < 3; ++k) out[t[k]] += mesh.mirrored ? -n : n;
    }
  }
  for (glm::vec3& n : out) n = brdf_f::safeNormalize(n, glm::vec3(0));
  return out;
}

/// What one side of one vertex sees, in the space of its normals.
class VertexRays {
 public:
  VertexRays(const PlacedScene& placed, const PlacedMesh& mesh, const std::vector<glm::vec3>& hemisphere)
      : placed_(placed),
        mesh_(mesh),
        hemisphere_(hemisphere),
        toMesh_(glm::transpose(mesh.linear)),
        directions_(hemisphere.size()),
        hidden_(new bool[hemisphere.size()]) {}

  /// @param normal  world, unit
  glm::vec4 from(const glm::vec3& position, const glm::vec3& normal) {
    const glm::mat3 frame = brdf_f::basisAbout(normal);
    for (std::size_t i = 0; i < directions_.size(); ++i) directions_[i] = frame * hemisphere_[i];
    Rays rays = placed_.raysFrom(position, normal, normal);
    rays.directions = directions_;
    placed_.geometry.findHidden(rays, {hidden_.get(), directions_.size()});
    glm::vec3 sum(0);
    int open = 0;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      if (hidden_[i]) continue;
      sum += directions_[i];
      ++open;
    }
    const glm::vec3 direction = mesh_.primitive->deformers ? glm::vec3(0) : toMesh_ * sum;
    return {brdf_f::safeNormalize(direction, glm::vec3(0)),
            static_cast<float>(open) / static_cast<float>(directions_.size())};
  }

 private:
  const PlacedScene& placed_;
  const PlacedMesh& mesh_;
  const std::vector<glm::vec3>& hemisphere_;
  glm::mat3 toMesh_;  ///< the inverse of how normals turn, but for lengths
  std::vector<glm::vec3> directions_;
  std::unique_ptr<bool[]> hidden_;
};

void addPlace(const PlacedScene& placed, const PlacedMesh& mesh, const std::vector<glm::vec3>& rays,
              VisibilityJob::Sides& sums, VisibilityJob& job) {
  const std::vector<glm::vec3> normals = normalsOf(mesh);
  const std::size_t vertices = normals.size(), rows = (vertices + ROW_VERTICES - 1) / ROW_VERTICES;
  const std::size_t count = seenFromBehind(*mesh.material) ? 2 : 1;
  for (std::size_t side = 0; side < count; ++side) sums[side].resize(vertices, glm::vec4(0));
  onThreads(rows, static_cast<std::size_t>(std::max(job.threads, 1)), [&](std::size_t row) {
    job.cancel.check();
    VertexRays vertex(placed, mesh, rays);
    const std::size_t first = row * ROW_VERTICES;
    for (std::size_t i = first; i < std::min(first + ROW_VERTICES, vertices); ++i) {
      const glm::vec3& normal = normals[i];
      for (std::size_t side = 0; side < count; ++side) {
        sums[side][i] += normal == glm::vec3(0) ? glm::vec4(0, 0, 0, 1)
                                                : vertex.from(mesh.positions[i], side == 0 ? normal : -normal);
      }
    }
  });
}

/// What a vertex sees that lies within another part of the model is nothing, yet its triangle may come out beside it:
/// it takes the mean of its neighbours that see something.
constexpr float BURIED = 0.02f;
constexpr int REACH = 8;  ///< edges from what is seen

void fillBuried(std::vector<glm::vec4>& side, const std::vector<glm::uvec3>& triangles) {
  for (int round = 0; round < REACH; ++round) {
    std::map<std::uint32_t, glm::vec4> sums;
    std::map<std::uint32_t, float> counts;
    for (const glm::uvec3& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        if (side[t[k]].w >= BURIED) continue;
        for (const std::uint32_t other : {t[(k + 1) % 3], t[(k + 2) % 3]}) {
          if (side[other].w < BURIED) continue;
          sums[t[k]] += side[other];
          ++counts[t[k]];
        }
      }
    }
    if (sums.empty()) return;
    for (const auto& [vertex, sum] : sums) side[vertex] = sum / counts[vertex];
  }
}

}  // namespace

void findVisibility(VisibilityJob& job) {
  const PlacedScene placed(job.scene, job.shot, job.cancel);
  const std::vector<glm::vec3> rays = hemisphere(job.rays);
  std::map<const Primitive*, int> places;
  std::map<const Primitive*, const std::vector<glm::uvec3>*> triangles;
  for (const PlacedMesh& mesh : placed.meshes) {
    if (mesh.primitive->topology != Topology::kTriangles || places[mesh.primitive] == VISIBILITY_PLACES) continue;
    ++places[mesh.primitive];
    addPlace(placed, mesh, rays, job.sides[mesh.primitive], job);
    triangles[mesh.primitive] = &mesh.triangles;
  }
  for (auto& [primitive, sides] : job.sides) {
    for (auto& side : sides) {
      for (glm::vec4& v : side) v.w /= static_cast<float>(places[primitive]);
      if (!side.empty()) fillBuried(side, *triangles[primitive]);
      for (glm::vec4& v : side) v = glm::vec4(brdf_f::safeNormalize(glm::vec3(v), glm::vec3(0)), v.w);
    }
  }
}

}  // namespace telar::reference
