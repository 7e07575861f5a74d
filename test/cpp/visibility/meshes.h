#pragma once
#include <vector>

#include "visibility/drawn_mesh.h"
#include "visibility/sample_grid.h"

/// Small meshes in code, in clip space: x and y from -1 to 1 over the window, z from -1 (near) to 1.
namespace telar::test {

struct Triangles {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

/// Two triangles that share a diagonal, counter-clockwise.
inline Triangles rectangle(const glm::vec2& low, const glm::vec2& high, float z) {
  return {{{low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z}}, {0, 1, 2, 0, 2, 3}};
}

/// A mesh after its vertex stage, with what it points to.
struct Placed {
  std::vector<float> floats;  ///< x, y, z, 1 of each vertex, and three more that vectors of four read
  visibility::PlacedMesh mesh;
};

/// @param mesh  outlives it
inline Placed placed(const Triangles& mesh, visibility::Faces faces = visibility::Faces::kBoth) {
  Placed out;
  for (const glm::vec3& p : mesh.positions) out.floats.insert(out.floats.end(), {p.x, p.y, p.z, 1});
  out.floats.resize(out.floats.size() + 3);
  out.mesh = {{out.floats.data(), 0}, mesh.positions.size(), mesh.indices, faces};
  return out;
}

/// A square window with the places of samples that llvmpipe has.
inline visibility::SampleGrid gridOf(int size) {
  return {size, size, {{{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}}}};
}

}  // namespace telar::test
