#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

/// The parts of MikkTSpace that only look at which vertices and edges are shared.
namespace telar::mikk {

constexpr std::uint32_t NONE = UINT32_MAX;

/// Position, normal and texture coordinate of each vertex; all spans of one length, finite.
struct VertexStreams {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec2> uvs;
};

/// For each vertex the first vertex with the same position, normal and UV (by value: -0 equals 0).
std::vector<std::uint32_t> weld(const VertexStreams& vertices);

/// For each corner 3 f + i of the triangles the triangle on the other side of its edge (i, i + 1), or NONE.
/// Two triangles are neighbours when they run along the edge in opposite directions. On an edge of more than two, the
/// k-th of one direction meets the k-th of the other.
/// @param corners  welded vertex of each corner, 3 a triangle; no triangle names a vertex twice
std::vector<std::uint32_t> neighbours(std::span<const std::uint32_t> corners);

}  // namespace telar::mikk
