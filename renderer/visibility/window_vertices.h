#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "visibility/sample_grid.h"

namespace telar::visibility {

/// A vertex in the window: x, y in pixels from the lower left corner, z in 0..1 of the depth buffer.
struct WindowVertex {
  float x, y, z;
  std::uint32_t outside;  ///< bits of Outside
};

enum Outside : std::uint32_t {
  LEFT = 1,
  RIGHT = 2,
  BELOW = 4,
  ABOVE = 8,
  FAR_OFF = 15,      ///< any of those above: more than a pixel beyond that border of the window
  CLIPPED = 16,      ///< outside the window, or almost on the near plane: the GL may cut its triangles
  UNPROJECTED = 32,  ///< before the near or behind the far plane, or behind the camera: no place in the window
};

/// By how many pixels a place that is CLIPPED may be off. Where it could be more it is UNPROJECTED.
constexpr float CLIPPED_SLACK = 1.0f / 16;

/// Of place(): pixels from which on a place is none, so that the product of two in steps of 1/256 is below 2^52.
constexpr float MOST_PLACE = 1e5f;

/// A mesh's vertices as the vertex stage places them, in floats and in its order of products, and how far the GL's may
/// be off.
struct WindowVertices {
  std::vector<WindowVertex> vertices;
  std::vector<float> overW;         ///< of place(): 1 / w of each
  float slack = 0;                  ///< px, in x and y each, of those within: rounding of the transform and of the grid
  float depthSlack = 0;             ///< of z, of those within: rounding of the transform
  float low[2] = {}, high[2] = {};  ///< px, of those that are projected and not clipped; none where low is above high

  /// Another mesh's in place of these, where the GL puts them.
  /// @param clip  four floats a vertex    @param stride  floats from one vertex to the next    @param moved  px, after
  /// the projection
  void place(const float* clip, std::size_t stride, std::size_t count, const glm::vec2& size, const glm::vec2& moved);

  /// Another mesh's in place of these.
  void project(std::span<const glm::vec3> positions, const glm::mat4& modelView, const glm::mat4& projection,
               const SampleGrid& grid);
};

}  // namespace telar::visibility
