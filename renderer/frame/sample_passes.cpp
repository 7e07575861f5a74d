#include "frame/sample_passes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/random.h"
#include "frame/pixel_mean.h"

namespace telar::frame {
namespace {

/// Up to here each pass has a cell of a grid, and a place in it by chance: so each part of the pixel is seen, and the threads of a
/// knit do not beat with the grid. With more passes scattered points are nearer.
constexpr int MOST_OF_A_GRID = 16;
/// What the first 16 points miss shows in the next 16, which lie between them.
constexpr int FEW = 64;
constexpr unsigned FEWEST_OF_FEW = 32;
/// The error that denoising leaves is told as if the guide were right. After fewer passes pixels settle that are still off
/// where it is wrong.
constexpr unsigned FEWEST_DENOISED = 256;

}  // namespace

glm::dvec2 SamplePasses::shift(int pass) const {
  if (count == 1) return glm::dvec2(0);
  if (haveCells()) return (glm::dvec2(cell(pass)) + 0.5) / double(cellsAcross()) - 0.5 + shiftInCell(pass);
  return glm::dvec2(Random(0, 0, static_cast<std::uint32_t>(pass)).uniform2()) - 0.5;
}

bool SamplePasses::haveCells() const { return count > 1 && count <= MOST_OF_A_GRID; }

int SamplePasses::cellsAcross() const { return static_cast<int>(std::lround(std::sqrt(count))); }

glm::ivec2 SamplePasses::cell(int pass) const {
  // The first 4 are a grid too, the first 8 the black squares of one.
  glm::ivec2 at(0);
  for (int half = cellsAcross() / 2; half != 0; pass >>= 2, half /= 2)
    at += half * glm::ivec2(pass & 1, (pass ^ (pass >> 1)) & 1);
  return at;
}

glm::dvec2 SamplePasses::shiftInCell(int pass) const {
  // Each second one lies across from the one before: so the mean of their places is the pixel's middle.
  const glm::dvec2 place(Random(1, 0, static_cast<std::uint32_t>(pass / 2)).uniform2());
  return (pass % 2 == 0 ? 1.0 : -1.0) * (place - 0.5) / double(cellsAcross());
}

unsigned SamplePasses::fewest() const {
  if (count <= FEW) return FEWEST_OF_FEW;
  return denoised ? FEWEST_DENOISED : PixelMean::FEWEST;
}

SamplePasses samplePassesOf(const Shot& shot) {
  if (shot.samples <= Shot::SAMPLES_OF_A_PASS) return {1, shot.samples, false};
  return {shot.samples, 1, shot.denoise};
}

Shot guideOf(Shot shot) {
  shot.samples = Shot::SAMPLES_OF_A_PASS;
  shot.noise = 0;
  shot.environmentSamples = 0;
  shot.mergeQuads = true;
  shot.denoise = false;
  shot.layers.clear();
  return shot;
}

glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * shift / glm::dvec2(width, height), 0)) * projection;
}

}  // namespace telar::frame
