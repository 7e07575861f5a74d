#include "asset/scene/outline.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "asset/geometry/drawn_points.h"

namespace telar::asset {
namespace {

constexpr int GRID = 2;  // directions end on the surface of the integer cube [-GRID, GRID]^3

template <std::size_t COUNT>
std::array<glm::dvec3, COUNT> directions() {
  std::array<glm::dvec3, COUNT> list;
  std::size_t count = 0;
  for (int x = -GRID; x <= GRID; ++x) {
    for (int y = -GRID; y <= GRID; ++y) {
      for (int z = -GRID; z <= GRID; ++z) {
        const bool onSurface = std::max({std::abs(x), std::abs(y), std::abs(z)}) == GRID;
        const bool half = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
        if (onSurface && half) list[count++] = glm::dvec3(x, y, z);
      }
    }
  }
  return list;
}

}  // namespace

Outline::Outline() : axes_(directions<AXES>()) {
  low_.fill(std::numeric_limits<double>::infinity()), high_.fill(-std::numeric_limits<double>::infinity());
}

void Outline::add(const glm::dvec3& p) {
  for (std::size_t i = 0; i < AXES; ++i) {
    const double along = p.x * axes_[i].x + p.y * axes_[i].y + p.z * axes_[i].z;
    if (along > high_[i]) high_[i] = along, highest_[i] = p;
    if (along < low_[i]) low_[i] = along, lowest_[i] = p;
  }
}

std::vector<glm::dvec3> Outline::points() const {
  std::vector<glm::dvec3> out;
  const auto keep = [&out](const glm::dvec3& p) {
    if (std::find(out.begin(), out.end(), p) == out.end()) out.push_back(p);
  };
  for (std::size_t i = 0; i < AXES; ++i) {
    if (high_[i] < low_[i]) return {};
    keep(highest_[i]), keep(lowest_[i]);
  }
  return out;
}

std::vector<glm::dvec3> outlineOf(const Scene& scene, const CancelToken& cancel) {
  Outline outline;
  DrawnPoints points(cancel);
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      points.visit(node, primitive, [&](const glm::dvec3& p) { outline.add(p); });
    }
  }
  return outline.points();
}

}  // namespace telar::asset
