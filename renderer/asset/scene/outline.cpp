#include "asset/scene/outline.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "asset/geometry/drawn_points.h"
#include "core/unaligned.h"

namespace telar::asset {
namespace {

using Two = double __attribute__((vector_size(16)));

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

Outline::Outline() {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const std::array<glm::dvec3, AXES> axes = directions<AXES>();
  for (std::size_t i = 0; i < AXES; ++i) {
    x_[i] = axes[i].x, y_[i] = axes[i].y, z_[i] = axes[i].z;
    low_[i] = INFINITE, high_[i] = -INFINITE;
  }
}

void Outline::add(const glm::dvec3& p) {
  Along along;
  Two above{0, 0}, below{0, 0};
  for (std::size_t i = 0; i < along.size(); i += 2) {
    const Two value =
        p.x * loadUnaligned<Two>(&x_[i]) + p.y * loadUnaligned<Two>(&y_[i]) + p.z * loadUnaligned<Two>(&z_[i]);
    std::memcpy(&along[i], &value, sizeof value);
    // What is no number is not larger.
    const Two overHigh = value - loadUnaligned<Two>(&high_[i]), underLow = loadUnaligned<Two>(&low_[i]) - value;
    above = overHigh > above ? overHigh : above;
    below = underLow > below ? underLow : below;
  }
  if (std::max({above[0], above[1], below[0], below[1]}) > 0) widen(p, along);
}

void Outline::widen(const glm::dvec3& p, const Along& along) {
  for (std::size_t i = 0; i < AXES; ++i) {
    if (along[i] > high_[i]) high_[i] = along[i], highest_[i] = p;
    if (along[i] < low_[i]) low_[i] = along[i], lowest_[i] = p;
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
