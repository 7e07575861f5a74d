#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "core/uv_metres.h"
#include "telar/dress.h"

namespace telar {
namespace {

constexpr std::size_t TRIANGLES_PER_CANCEL_CHECK = 1 << 14;

struct Weighted {
  double metres, area;
};

/// The value that half of the area has at most. Reorders them.
double median(std::vector<Weighted>& values) {
  const auto areaOf = [](auto from, auto to) {
    return std::accumulate(from, to, 0.0, [](double sum, const Weighted& value) { return sum + value.area; });
  };
  const auto isLess = [](const Weighted& a, const Weighted& b) { return a.metres < b.metres; };
  const double total = areaOf(values.begin(), values.end());
  // Halves the range that it lies in, in linear time: a sort would take most of what it takes to dress a model.
  auto first = values.begin(), last = values.end();
  double below = 0;
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, isLess);
    const double lower = areaOf(first, middle);
    if ((below + lower) * 2 >= total) {
      last = middle;
    } else {
      below += lower;
      first = middle;
    }
  }
  return first->metres;
}

/// Of the triangles of one mesh.
struct MeshScale {
  glm::dvec2 metres;
  double area;
};

std::optional<MeshScale> scaleOf(const Primitive& primitive, const glm::dmat3& world, const CancelToken& cancel) {
  const auto& uvs = primitive.uvs[0];
  if (uvs.empty() || primitive.topology != Topology::kTriangles) return std::nullopt;
  std::vector<Weighted> u, v;
  double total = 0;
  const bool indexed = !primitive.indices.empty();
  const std::size_t count = indexed ? primitive.indices.size() : primitive.positions.size();
  for (std::size_t i = 0; i + 2 < count; i += 3) {
    if (i / 3 % TRIANGLES_PER_CANCEL_CHECK == 0) cancel.check();
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
    if (!(metres.x > 0 && metres.y > 0)) continue;
    u.push_back({metres.x, area}), v.push_back({metres.y, area});
    total += area;
  }
  if (u.empty()) return std::nullopt;
  return MeshScale{{median(u), median(v)}, total};
}

/// What a primitive wears in the file, with and without a variant, each once.
std::set<int> materialsOf(const Primitive& primitive) {
  std::set<int> out{primitive.material};
  for (const auto& [variant, material] : primitive.variantMaterials) out.insert(material);
  return out;
}

}  // namespace

std::vector<std::optional<glm::dvec2>> metresPerUv(const Scene& scene, const std::vector<bool>& wanted,
                                                   const CancelToken& cancel) {
  const auto isWanted = [&wanted](int i) {
    return i >= 0 && static_cast<std::size_t>(i) < wanted.size() && wanted[static_cast<std::size_t>(i)];
  };
  std::vector<std::vector<MeshScale>> scales(wanted.size());
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    // Instances of one mesh differ in size as a rule; the first stands for all.
    const bool instanced = node.instances && !node.instances->matrices.empty();
    const glm::dmat3 world(instanced ? node.world * glm::dmat4(node.instances->matrices[0]) : node.world);
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      std::set<int> worn = materialsOf(primitive);
      std::erase_if(worn, [&isWanted](int i) { return !isWanted(i); });
      if (worn.empty()) continue;
      const auto scale = scaleOf(primitive, world, cancel);
      if (!scale) continue;
      for (const int material : worn) scales[static_cast<std::size_t>(material)].push_back(*scale);
    }
  }
  std::vector<std::optional<glm::dvec2>> out(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (scales[i].empty()) continue;
    std::vector<Weighted> u, v;
    for (const MeshScale& scale : scales[i]) {
      u.push_back({scale.metres.x, scale.area}), v.push_back({scale.metres.y, scale.area});
    }
    out[i] = glm::dvec2(median(u), median(v));
  }
  return out;
}

}  // namespace telar
