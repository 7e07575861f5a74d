#pragma once
#include <glm/glm.hpp>

#include "telar/shot.h"

namespace telar::frame {

/// How the samples of a pixel are spread over passes over the model.
struct SamplePasses {
  int count = 1;    ///< a power of 4
  int samples = 1;  ///< of a pass: multisampling
  bool denoised = false;

  /// How far the picture of a pass is moved, pixels in [-0.5, 0.5): the first 2^k passes fill the pixel evenly, for any
  /// k, so that their mean is that of a box filter. Where passes have no cells they are independent of the directions that the
  /// passes draw.
  glm::dvec2 shift(int pass) const;

  /// Whether each pass has a cell of a grid.
  bool haveCells() const;
  /// Cells in a row of the grid.
  int cellsAcross() const;
  /// Column and row of a pass.
  glm::ivec2 cell(int pass) const;
  /// Part of shift() that moves a pass within its cell, from the cell's middle, pixels.
  glm::dvec2 shiftInCell(int pass) const;

  /// Passes of which the two halves tell how far their mean is off: PixelMean.
  unsigned fewest() const;
};

/// One pass for up to Shot::SAMPLES_OF_A_PASS samples, and one a sample for more: a pass shades a pixel once.
SamplePasses samplePassesOf(const Shot& shot);

/// The guide of a shot whose passes are denoised: one pass with the samples that it takes, so that seams and edges are
/// smooth, prefiltered light, filtered maps.
Shot guideOf(Shot shot);

/// Projection of a picture that is moved by a part of a pixel. @param shift  pixels, x right and y up
glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height);

}  // namespace telar::frame
