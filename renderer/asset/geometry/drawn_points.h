#pragma once
#include <algorithm>
#include <map>
#include <vector>

#include "asset/geometry/topology.h"
#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar::asset {

/// Above so many vertices over all instances of a primitive, the corners of each instance's box stand for its vertices.
/// The same number as in js/three/drawn_points.mjs, so that browser and server frame alike.
constexpr std::size_t INSTANCED_VERTICES_MAX = std::size_t{1} << 20;

/// The points, in world space, that bound what a scene draws: each drawn vertex, in each of its places.
class DrawnPoints {
 public:
  /// @param cancel  outlives it
  explicit DrawnPoints(const CancelToken& cancel) : cancel_(cancel) {}

  template <typename Visit>
  void visit(const Node& node, const Primitive& primitive, const Visit& visit) {
    const auto& used = usedOf(primitive);
    const std::size_t count = used.empty() ? primitive.positions.size() : used.size();
    if (!node.instances) return visitVertices(primitive, used, node.world, visit);
    const bool exact = count * node.instances->matrices.size() <= INSTANCED_VERTICES_MAX;
    for (const glm::mat4& matrix : node.instances->matrices) {
      const glm::dmat4 world = node.world * glm::dmat4(matrix);
      exact ? visitVertices(primitive, used, world, visit) : visitCorners(primitive.bounds, world, visit);
    }
  }

 private:
  void look() {
    constexpr std::size_t POINTS_PER_CANCEL_CHECK = 1 << 16;
    if (++seen_ % POINTS_PER_CANCEL_CHECK == 0) cancel_.check();
  }

  template <typename Visit>
  void visitVertices(const Primitive& primitive, const std::vector<std::uint32_t>& used, const glm::dmat4& world,
                     const Visit& visit) {
    const auto add = [&](const glm::vec3& p) {
      look();
      visit(glm::dvec3(world * glm::dvec4(glm::dvec3(p), 1.0)));
    };
    if (used.empty()) std::for_each(primitive.positions.begin(), primitive.positions.end(), add);
    for (const std::uint32_t index : used) add(primitive.positions[index]);
  }

  template <typename Visit>
  void visitCorners(const Bounds& bounds, const glm::dmat4& world, const Visit& visit) {
    look();
    if (bounds.empty()) return;
    for (const glm::dvec3& corner : bounds.corners()) visit(glm::dvec3(world * glm::dvec4(corner, 1.0)));
  }

  /// Empty where all vertices are drawn.
  const std::vector<std::uint32_t>& usedOf(const Primitive& primitive) {
    const auto found = used_.find(&primitive);
    if (found != used_.end()) return found->second;
    return used_.emplace(&primitive, usedVertices(primitive.positions.size(), primitive.indices)).first->second;
  }

  const CancelToken& cancel_;
  std::size_t seen_ = 0;
  std::map<const Primitive*, std::vector<std::uint32_t>> used_;
};

}  // namespace telar::asset
