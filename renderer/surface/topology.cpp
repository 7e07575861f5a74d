#include <algorithm>
#include <numeric>

#include "surface/surface.h"

namespace telar::surface {
namespace {

struct Side {
  std::uint32_t a, b, face, k;
};

}  // namespace

void connect(Surface& surface, const CancelToken& cancel) {
  std::vector<Side> sides;
  sides.reserve(surface.faces.size() * 3);
  surface.pointFirst.assign(surface.points.size() + 1, 0);
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t p = surface.faces[f].points[k], q = surface.faces[f].points[(k + 1) % 3];
      sides.push_back({std::min(p, q), std::max(p, q), f, k});
      ++surface.pointFirst[p + 1];
    }
  }
  cancel.check();
  // Faces break ties, so that the order is the same with any library.
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::array{p.a, p.b, p.face} < std::array{q.a, q.b, q.face};
  });
  cancel.check();
  surface.edges.clear();
  surface.edgeFaces.clear();
  for (const Side& side : sides) {
    if (surface.edges.empty() || surface.edges.back().a != side.a || surface.edges.back().b != side.b) {
      surface.edges.push_back({side.a, side.b, static_cast<std::uint32_t>(surface.edgeFaces.size()), 0});
    }
    surface.edgeFaces.push_back(side.face);
    ++surface.edges.back().count;
    surface.faces[side.face].edges[side.k] = static_cast<std::uint32_t>(surface.edges.size() - 1);
  }
  std::partial_sum(surface.pointFirst.begin(), surface.pointFirst.end(), surface.pointFirst.begin());
  surface.pointFaces.resize(surface.pointFirst.back());
  std::vector<std::uint32_t> next(surface.pointFirst.begin(), surface.pointFirst.end() - 1);
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    for (const std::uint32_t p : surface.faces[f].points) surface.pointFaces[next[p]++] = f;
  }
}

std::vector<std::uint32_t> componentsOf(const Surface& surface) {
  std::vector<std::uint32_t> root(surface.points.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&root](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Edge& edge : surface.edges) {
    const std::uint32_t a = find(edge.a), b = find(edge.b);
    root[std::max(a, b)] = std::min(a, b);
  }
  for (std::uint32_t i = 0; i < root.size(); ++i) root[i] = find(i);
  return root;
}

}  // namespace telar::surface
