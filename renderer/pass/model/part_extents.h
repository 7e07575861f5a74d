#pragma once
#include <vector>

#include "telar/scene.h"

namespace telar::pass {

/// Parts of a primitive as they are drawn (triangles, line segments, points), and where their corners stand among its
/// indices, or its vertices where it has none.
struct PartLayout {
  std::size_t parts = 0;
  std::size_t step = 1;  ///< corners from the begin of one part to that of the next
  std::size_t more = 0;  ///< corners of the last part beyond those

  explicit PartLayout(const Primitive& primitive);
  std::size_t corners() const { return step + more; }
};

/// Position of a corner of one of a primitive's parts.
inline const glm::vec3& cornerOf(const Primitive& p, const PartLayout& layout, std::size_t part, std::size_t corner) {
  std::size_t i = part * layout.step + corner;
  const std::size_t count = p.indices.empty() ? p.positions.size() : p.indices.size();
  if (i == count) i = 0;  // a loop ends where it began
  return p.positions[p.indices.empty() ? i : p.indices[i]];
}

/// Extent of some parts together, mesh space.
struct Extent {
  std::size_t parts = 0;
  double area = 0;       ///< square metres
  double diameters = 0;  ///< metres
};

/// The extents of blocks of parts of a primitive and of all its parts. They bound the pixels that the parts cover
/// without a look at the vertices.
struct PartExtents {
  static constexpr std::size_t BLOCK = 256;

  explicit PartExtents(const Primitive& primitive);

  std::vector<Extent> blocks;
  Extent all;
};

}  // namespace telar::pass
