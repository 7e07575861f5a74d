#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "visibility/window_triangle.h"

namespace telar::visibility {

using Corners = std::array<std::uint32_t, 3>;

/// A mesh of triangles as one draw shows it.
struct DrawnMesh {
  std::span<const glm::vec3> positions;
  std::span<const std::uint32_t> indices;  ///< empty = the vertices in their order
  glm::mat4 modelView{1}, projection{1};   ///< as the GL has them
  Faces faces = Faces::kBoth;
  bool hides = true;  ///< each of its fragments is opaque and has depth
  std::size_t vertices() const { return positions.size(); }
};

/// What the vertex stage gave for each vertex: its place in clip space, then its varyings.
struct VertexOutputs {
  const float* floats = nullptr;  ///< may be read three floats beyond the last vertex
  std::size_t varyings = 0;       ///< floats a vertex, after four of its place
  std::size_t stride() const { return 4 + varyings; }
  const float* of(std::uint32_t vertex) const { return floats + vertex * stride(); }
};

/// The same after its vertex stage. All of it is opaque and has depth.
struct PlacedMesh {
  VertexOutputs outputs;
  std::size_t count = 0;                   ///< vertices
  std::span<const std::uint32_t> indices;  ///< empty = the vertices in their order
  Faces faces = Faces::kBoth;
  bool smooth = true;  ///< what vertices have runs on from triangle to triangle
  std::size_t vertices() const { return count; }
};

template <class Mesh>
std::size_t trianglesOf(const Mesh& mesh) {
  return (mesh.indices.empty() ? mesh.vertices() : mesh.indices.size()) / 3;
}

template <class Mesh>
Corners cornersOf(const Mesh& mesh, std::size_t triangle) {
  const std::size_t first = triangle * 3;
  if (!mesh.indices.empty()) return {mesh.indices[first], mesh.indices[first + 1], mesh.indices[first + 2]};
  const auto vertex = static_cast<std::uint32_t>(first);
  return {vertex, vertex + 1, vertex + 2};
}

}  // namespace telar::visibility
