#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/uv_metres.h"
#include "telar/dress.h"
#include "telar/variant_material.h"

namespace telar {
namespace {

constexpr std::size_t TRIANGLES_PER_CANCEL_CHECK = 1 << 14;

struct Weighted {
  double metres, area;
};

/// The value that half of the area has at most.
double median(std::vector<Weighted>& values) {
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.metres < b.metres; });
  double total = 0, sum = 0;
  for (const Weighted& value : values) total += value.area;
  for (const Weighted& value : values) {
    sum += value.area;
    if (sum * 2 >= total) return value.metres;
  }
  return values.back().metres;
}

class UvScale {
 public:
  explicit UvScale(const CancelToken& cancel) : cancel_(cancel) {}

  void add(const Primitive& primitive, const glm::dmat3& world) {
    const auto& uvs = primitive.uvs[0];
    if (uvs.empty() || primitive.topology != Topology::kTriangles) return;
    const bool indexed = !primitive.indices.empty();
    const std::size_t count = indexed ? primitive.indices.size() : primitive.positions.size();
    for (std::size_t i = 0; i + 2 < count; i += 3) {
      if (i / 3 % TRIANGLES_PER_CANCEL_CHECK == 0) cancel_.check();
      std::array<std::size_t, 3> at{};
      for (std::size_t k = 0; k < 3; ++k) at[k] = indexed ? primitive.indices[i + k] : i + k;
      const glm::dvec3 origin(primitive.positions[at[0]]);
      const glm::dvec3 p = world * (glm::dvec3(primitive.positions[at[1]]) - origin);
      const glm::dvec3 q = world * (glm::dvec3(primitive.positions[at[2]]) - origin);
      const glm::dvec2 zero(uvs[at[0]]);
      const glm::dvec2 metres = uvMetres(p, q, glm::dvec2(uvs[at[1]]) - zero, glm::dvec2(uvs[at[2]]) - zero);
      const double area = glm::length(glm::cross(p, q)) / 2;
      // A triangle without area in the texture says nothing of its size.
      if (!std::isfinite(metres.x) || !std::isfinite(metres.y) || !(area > 0)) continue;
      if (metres.x > 0 && metres.y > 0) u_.push_back({metres.x, area}), v_.push_back({metres.y, area});
    }
  }

  std::optional<glm::dvec2> medians() {
    if (u_.empty()) return std::nullopt;
    return glm::dvec2(median(u_), median(v_));
  }

 private:
  const CancelToken& cancel_;
  std::vector<Weighted> u_, v_;
};

bool wears(const Primitive& primitive, int material) {
  const auto same = [material](const auto& mapped) { return mapped.second == material; };
  return primitive.material == material ||
         std::any_of(primitive.variantMaterials.begin(), primitive.variantMaterials.end(), same);
}

}  // namespace

std::optional<glm::dvec2> metresPerUv(const Scene& scene, int material, const CancelToken& cancel) {
  UvScale scale(cancel);
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    // Instances of one mesh differ in size as a rule; the first stands for all.
    const bool instanced = node.instances && !node.instances->matrices.empty();
    const glm::dmat3 world(instanced ? node.world * glm::dmat4(node.instances->matrices[0]) : node.world);
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (wears(primitive, material)) scale.add(primitive, world);
    }
  }
  return scale.medians();
}

}  // namespace telar
