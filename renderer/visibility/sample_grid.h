#pragma once
#include <array>
#include <glm/glm.hpp>

namespace telar::visibility {

constexpr int SAMPLES = 4;

/// Where a target with four samples a pixel takes them.
struct SampleGrid {
  int width = 0, height = 0;                ///< px
  std::array<glm::vec2, SAMPLES> places{};  ///< in a pixel, from its lower left corner, 0..1
  /// The rasterizer puts corners on a grid of this step in pixels, whichever way it rounds: llvmpipe's fixed point has
  /// 8 bits below 1.
  float step = 1.0f / 256;
};

}  // namespace telar::visibility
