#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mikk_topology.h"

namespace telar::mikk {

/// What the texture coordinates say about one triangle that has an area in space.
struct Triangle {
  glm::vec3 tangent{0};    ///< direction in which u grows, unit, or 0
  glm::vec3 bitangent{0};  ///< direction in which v grows, unit, or 0
  bool preserves = false;  ///< UVs run the same way round as the positions
  bool flexible = true;    ///< UVs give no direction: joins the groups around it, whatever their orientation
};

/// @param corners  vertex of each corner, 3 a triangle
std::vector<Triangle> describeTriangles(const VertexStreams& vertices, std::span<const std::uint32_t> corners);

/// Corners around one vertex that share a tangent space.
struct Group {
  std::uint32_t vertex;  ///< welded
  bool preserves;
  std::uint32_t begin, end;  ///< range in Groups::corners, ascending there
};

struct Groups {
  std::vector<Group> groups;
  std::vector<std::uint32_t> corners;  ///< 3 f + i
};

/// Collects around each vertex the triangles that are reached over shared edges without a change of orientation.
/// Settles `preserves` of flexible triangles on the way.
/// @param across  neighbours(corners)
Groups buildGroups(std::vector<Triangle>& triangles, std::span<const std::uint32_t> corners,
                   std::span<const std::uint32_t> across);

}  // namespace telar::mikk
