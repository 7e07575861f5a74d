#pragma once
#include <vector>

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

/// A square window with the places of samples that llvmpipe has.
inline visibility::SampleGrid gridOf(int size) {
  return {size, size, {{{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}}}};
}

}  // namespace telar::test
