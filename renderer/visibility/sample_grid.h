#pragma once
#include <array>
#include <glm/glm.hpp>

namespace telar::visibility {

constexpr int SAMPLES = 4;

/// Where a target takes its samples: four in each cell, which is a pixel, or two by two pixels of one sample.
struct SampleGrid {
  int width = 0, height = 0;                ///< px
  std::array<glm::vec2, SAMPLES> places{};  ///< of a cell, from its lower left corner, px; less the offset
  int cell = 1;                             ///< px on a side
  /// llvmpipe moves a picture of one sample by half a pixel, so that the centres of its pixels are whole numbers.
  float offset = 0;
  /// The rasterizer puts corners on a grid of this step in pixels, whichever way it rounds: llvmpipe's fixed point has
  /// 8 bits below 1.
  float step = 1.0f / 256;

  static SampleGrid ofOneSample(int width, int height) {
    return {width, height, {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}, 2, 0.5f};
  }
};

}  // namespace telar::visibility
