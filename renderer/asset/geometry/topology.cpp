#include "asset/geometry/topology.h"

#include <algorithm>
#include <numeric>

namespace telar::asset {
namespace {

std::vector<std::uint32_t>& writtenOut(std::size_t vertices, Order& order) {
  if (!order) {
    order.emplace(vertices);
    std::iota(order->begin(), order->end(), 0u);
  }
  return *order;
}

/// The first corner of each triangle is GLTFLoader's: depth is rounded by it, and decides where triangles lie in one
/// plane.
std::vector<std::uint32_t> stripToTriangles(const std::vector<std::uint32_t>& strip) {
  std::vector<std::uint32_t> out;
  if (strip.size() < 3) return out;
  out.reserve((strip.size() - 2) * 3);
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    out.insert(out.end(), {strip[i + 2 * odd], strip[i + 1], strip[i + 2 - 2 * odd]});
  }
  return out;
}

std::vector<std::uint32_t> fanToTriangles(const std::vector<std::uint32_t>& fan) {
  std::vector<std::uint32_t> out;
  if (fan.size() < 3) return out;
  out.reserve((fan.size() - 2) * 3);
  for (std::size_t i = 1; i + 1 < fan.size(); ++i) out.insert(out.end(), {fan[0], fan[i], fan[i + 1]});
  return out;
}

std::size_t elementSize(Topology topology) {
  if (topology == Topology::kPoints) return 1;
  return topology == Topology::kTriangles ? 3 : 2;
}

void stripToLines(Topology& topology, std::vector<std::uint32_t>& indices) {
  if (topology != Topology::kLineLoop && topology != Topology::kLineStrip) return;
  if (topology == Topology::kLineLoop && !indices.empty()) indices.push_back(indices.front());
  topology = Topology::kLines;
  std::vector<std::uint32_t> lines;
  for (std::size_t i = 0; i + 1 < indices.size(); ++i) lines.insert(lines.end(), {indices[i], indices[i + 1]});
  indices = std::move(lines);
}

}  // namespace

Topology toTopology(int mode, std::size_t vertices, Order& order) {
  if (mode == MODE_STRIP || mode == MODE_FAN) {
    const auto& corners = writtenOut(vertices, order);
    order = mode == MODE_STRIP ? stripToTriangles(corners) : fanToTriangles(corners);
    return Topology::kTriangles;
  }
  constexpr Topology TOPOLOGIES[] = {Topology::kPoints, Topology::kLines, Topology::kLineLoop, Topology::kLineStrip,
                                     Topology::kTriangles};
  const Topology topology = TOPOLOGIES[mode];
  if (topology == Topology::kLines || topology == Topology::kTriangles) {
    const std::size_t size = elementSize(topology);
    if (!order && vertices % size != 0) writtenOut(vertices, order);
    if (order) order->resize(order->size() / size * size);
  }
  return topology;
}

std::size_t dropElements(Topology& topology, std::size_t vertices, const std::vector<bool>& bad, Order& order) {
  auto& indices = writtenOut(vertices, order);
  stripToLines(topology, indices);
  const std::size_t size = elementSize(topology);
  std::size_t kept = 0;
  for (std::size_t i = 0; i + size <= indices.size(); i += size) {
    const auto element = indices.begin() + static_cast<std::ptrdiff_t>(i);
    const auto isBad = [&](std::uint32_t vertex) { return bad[vertex]; };
    if (std::any_of(element, element + static_cast<std::ptrdiff_t>(size), isBad)) continue;
    std::copy_n(element, size, indices.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += size;
  }
  const std::size_t dropped = (indices.size() - kept) / size;
  indices.resize(kept);
  return dropped;
}

bool drawsNothing(Topology topology, std::size_t vertices, const Order& order) {
  return (order ? order->size() : vertices) < elementSize(topology);
}

std::vector<std::uint32_t> usedVertices(std::size_t vertices, const std::vector<std::uint32_t>& indices) {
  std::vector<std::uint32_t> out;
  if (indices.empty()) return out;
  std::vector<bool> used(vertices, false);
  std::size_t count = 0;
  for (const std::uint32_t index : indices) {
    if (used[index]) continue;
    used[index] = true;
    ++count;
  }
  if (count == vertices) return out;
  out.reserve(count);
  for (std::uint32_t i = 0; i < vertices; ++i) {
    if (used[i]) out.push_back(i);
  }
  return out;
}

Bounds drawnBounds(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& used) {
  Bounds out;
  if (used.empty()) {
    for (const auto& position : positions) out.add(glm::dvec3(position));
  }
  for (const std::uint32_t index : used) out.add(glm::dvec3(positions[index]));
  return out;
}

}  // namespace telar::asset
