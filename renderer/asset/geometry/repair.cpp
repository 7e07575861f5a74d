#include "asset/geometry/repair.h"

#include <algorithm>
#include <cmath>

#include "telar/half.h"

namespace telar::asset {
namespace {

constexpr double LENGTH_MIN = 1e-6, LENGTH_MAX = 1e6;  // their squares are far inside fp32

enum class Direction { kGood, kScaled, kBad };

/// Brings a direction's length into a range that fp32 can square.
Direction settle(glm::vec3& direction) {
  if (!isFinite(direction)) return Direction::kBad;
  const glm::dvec3 exact(direction);
  const double length = glm::length(exact);
  if (length == 0) return Direction::kBad;
  if (length >= LENGTH_MIN && length <= LENGTH_MAX) return Direction::kGood;
  direction = glm::vec3(exact / length);
  return Direction::kScaled;
}

/// Unit normal of a vertex from its triangles, weighted by area.
std::vector<glm::dvec3> faceNormals(const Primitive& primitive) {
  std::vector<glm::dvec3> sums(primitive.positions.size(), glm::dvec3(0));
  if (primitive.topology != Topology::kTriangles) return sums;
  const auto& indices = primitive.indices;
  const std::size_t corners = indices.empty() ? primitive.positions.size() : indices.size();
  const auto at = [&](std::size_t i) { return indices.empty() ? i : std::size_t{indices[i]}; };
  for (std::size_t i = 0; i + 2 < corners; i += 3) {
    const glm::dvec3 a(primitive.positions[at(i)]), b(primitive.positions[at(i + 1)]),
        c(primitive.positions[at(i + 2)]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (std::size_t k = 0; k < 3; ++k) sums[at(i + k)] += normal;
  }
  return sums;
}

template <typename Color>
std::size_t clampColors(std::vector<Color>& colors) {
  std::size_t changed = 0;
  for (Color& color : colors) {
    const Color before = color;
    for (int i = 0; i < Color::length(); ++i) {
      color[i] = std::isfinite(color[i]) ? std::clamp(color[i], 0.0f, HALF_MAX) : 1.0f;
    }
    changed += color != before;  // true for NaN too
  }
  return changed;
}

}  // namespace

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isDrawable(const glm::vec3& p) {
  // NaN fails every comparison.
  return std::abs(p.x) <= COORDINATE_MAX && std::abs(p.y) <= COORDINATE_MAX && std::abs(p.z) <= COORDINATE_MAX;
}

std::vector<bool> findBadVertices(std::vector<glm::vec3>& positions) {
  std::vector<bool> bad;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (isDrawable(positions[i])) continue;
    if (bad.empty()) bad.resize(positions.size(), false);
    bad[i] = true;
    positions[i] = glm::vec3(0);
  }
  return bad;
}

std::size_t repairNormals(Primitive& primitive) {
  std::size_t changed = 0;
  std::vector<glm::dvec3> faces;
  for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
    const Direction state = settle(primitive.normals[i]);
    if (state == Direction::kGood) continue;
    ++changed;
    if (state == Direction::kScaled) continue;
    if (faces.empty()) faces = faceNormals(primitive);
    const double length = glm::length(faces[i]);
    const bool usable = length > 0 && std::isfinite(length);
    primitive.normals[i] = usable ? glm::vec3(faces[i] / length) : glm::vec3(0, 0, 1);
  }
  return changed;
}

std::size_t repairTangents(Primitive& primitive) {
  std::size_t changed = 0;
  for (glm::vec4& tangent : primitive.tangents) {
    glm::vec3 direction(tangent);
    const Direction state = settle(direction);
    if (state == Direction::kBad) direction = glm::vec3(0);
    changed += state != Direction::kGood;
    tangent = glm::vec4(direction, tangent.w < 0 ? -1.0f : 1.0f);
  }
  return changed;
}

std::size_t repairUvs(std::vector<glm::vec2>& uvs) {
  std::size_t changed = 0;
  for (glm::vec2& uv : uvs) {
    if (isDrawable(glm::vec3(uv, 0))) continue;
    uv = glm::vec2(0);
    ++changed;
  }
  return changed;
}

std::size_t repairVisibility(std::vector<glm::vec4>& visibility) {
  std::size_t changed = 0;
  for (glm::vec4& v : visibility) {
    const glm::vec4 before = v;
    // Directions are of length 1 at most; what is far from that is no number of a direction.
    const glm::vec3 direction(v);
    if (!isFinite(direction) || glm::dot(direction, direction) > 4.0f) v = glm::vec4(0, 0, 0, v.w);
    v.w = std::isfinite(v.w) ? std::clamp(v.w, 0.0f, 1.0f) : 1.0f;
    changed += v != before;  // true for NaN too
  }
  return changed;
}

std::size_t repairColors(std::vector<glm::vec4>& colors) { return clampColors(colors); }
std::size_t repairColors(std::vector<glm::vec3>& colors) { return clampColors(colors); }

}  // namespace telar::asset
