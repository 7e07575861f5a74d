#include "mesh/mikk_topology.h"

#include <algorithm>
#include <numeric>

namespace telar::mikk {
namespace {

struct Edge {
  std::uint64_t ends;  ///< lower vertex in the high half, so that a bucket of equal ends is one edge of the mesh
  std::uint32_t corner;
  bool forward;  ///< runs from the lower to the higher vertex
};

std::array<float, 8> key(const VertexStreams& vertices, std::uint32_t i) {
  const glm::vec3& p = vertices.positions[i];
  const glm::vec3& n = vertices.normals[i];
  const glm::vec2& uv = vertices.uvs[i];
  return {p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
}

std::vector<Edge> sortedEdges(std::span<const std::uint32_t> corners) {
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const std::uint64_t from = corners[corner], to = corners[corner % 3 == 2 ? corner - 2 : corner + 1];
    edges.push_back({std::min(from, to) << 32 | std::max(from, to), corner, from < to});
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner; });
  return edges;
}

}  // namespace

std::vector<std::uint32_t> weld(const VertexStreams& vertices) {
  // Sorted, not hashed: no input makes this slow.
  std::vector<std::uint32_t> order(vertices.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto ka = key(vertices, a), kb = key(vertices, b);
    return ka != kb ? ka < kb : a < b;
  });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && key(vertices, order[i]) == key(vertices, order[i - 1]);
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::vector<std::uint32_t> neighbours(std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> across(corners.size(), NONE);
  const std::vector<Edge> edges = sortedEdges(corners);
  std::vector<std::uint32_t> forward, backward;
  for (std::size_t i = 0; i < edges.size();) {
    forward.clear(), backward.clear();
    const std::uint64_t ends = edges[i].ends;
    for (; i < edges.size() && edges[i].ends == ends; ++i) {
      (edges[i].forward ? forward : backward).push_back(edges[i].corner);
    }
    for (std::size_t k = 0; k < std::min(forward.size(), backward.size()); ++k) {
      across[forward[k]] = backward[k] / 3;
      across[backward[k]] = forward[k] / 3;
    }
  }
  return across;
}

}  // namespace telar::mikk
