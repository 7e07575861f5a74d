#include "visibility/triangle_fans.h"

namespace telar::visibility {

void TriangleFans::read(std::span<const std::uint32_t> indices, std::size_t vertices) {
  indices_ = indices;
  if (indices.empty()) return;
  begins_.assign(vertices + 1, 0);
  for (const std::uint32_t vertex : indices) ++begins_[vertex];
  std::uint32_t sum = 0;
  for (std::uint32_t& end : begins_) end = sum += end;
  corners_.resize(indices.size());
  // Filled from its end on, so that each ends at where it began.
  for (std::size_t i = indices.size(); i-- > 0;) corners_[--begins_[indices[i]]] = static_cast<std::uint32_t>(i);
}

std::optional<std::uint32_t> TriangleFans::withEdge(std::uint32_t from, std::uint32_t to, std::int64_t& steps) const {
  if (indices_.empty()) return std::nullopt;
  // A disc has all its triangles at one end of an edge, and two at the other.
  const bool forward = sizeOf(from) <= sizeOf(to);
  const std::uint32_t vertex = forward ? from : to, other = forward ? to : from;
  if (sizeOf(vertex) > LARGEST) return std::nullopt;
  const std::uint32_t ahead = forward ? 1 : 2;
  for (std::uint32_t i = begins_[vertex]; i < begins_[vertex + 1]; ++i) {
    ++steps;
    const std::uint32_t corner = corners_[i], first = corner / 3 * 3;
    if (indices_[first + (corner - first + ahead) % 3] == other) return corner / 3;
  }
  return std::nullopt;
}

}  // namespace telar::visibility
