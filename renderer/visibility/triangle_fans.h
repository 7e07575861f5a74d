#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "visibility/memory.h"

namespace telar::visibility {

/// The triangles at each vertex of a mesh, by its indices.
class TriangleFans {
 public:
  /// Another mesh in place of this one.
  /// @param indices  outlive it, each below `vertices`; empty = it knows of no triangle
  void read(std::span<const std::uint32_t> indices, std::size_t vertices);

  /// The first triangle with this edge, in its own winding. None where both its vertices have more than LARGEST
  /// triangles.
  /// @param[in,out] steps  increased by the triangles that it looked at
  std::optional<std::uint32_t> withEdge(std::uint32_t from, std::uint32_t to, std::int64_t& steps) const;

  std::size_t memory() const { return bytesOf(begins_) + bytesOf(corners_); }

  /// Even the rim of a disc has no more at one end. Without it, an edge that many triangles share would cost the square
  /// of their number.
  static constexpr std::uint32_t LARGEST = 64;

 private:
  std::uint32_t sizeOf(std::uint32_t vertex) const { return begins_[vertex + 1] - begins_[vertex]; }

  std::span<const std::uint32_t> indices_;
  std::vector<std::uint32_t> begins_;   ///< of each vertex in corners_, and the end
  std::vector<std::uint32_t> corners_;  ///< places in indices_
};

}  // namespace telar::visibility
