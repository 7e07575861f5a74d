#include "frame/sample_passes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/random.h"
#include "frame/pixel_mean.h"

namespace telar::frame {
namespace {

/// Up to here each pass has a cell of a grid, and a place in it by chance: so each part of the pixel is seen, and the threads of a
/// knit do not beat with the grid. With more passes scattered points are as near.
constexpr int MOST_OF_A_GRID = 64;
/// What 16 points miss shows in the next 16, which lie between them.
constexpr unsigned FEWEST_OF_A_GRID = 32;
/// The error that denoising leaves is told as if the guide were right. After fewer passes pixels settle that are still off
/// where it is wrong.
constexpr unsigned FEWEST_DENOISED = 256;

/// Middle of a cell of the grid, [0, 1)^2. The first 4, 16 ... are grids too, the first 8, 32 ... the black squares of one.
glm::dvec2 cellMiddle(int pass, int count) {
  glm::dvec2 place(0.5 / std::sqrt(count));
  for (double half = 0.5; pass != 0; pass >>= 2, half /= 2)
    place += half * glm::dvec2(pass & 1, (pass ^ (pass >> 1)) & 1);
  return place;
}

}  // namespace

glm::dvec2 SamplePasses::shift(int pass) const {
  if (count == 1) return glm::dvec2(0);
  if (count <= MOST_OF_A_GRID) {
    // Each second one lies across from the one before: so the mean of their places is the pixel's middle.
    const glm::dvec2 place(Random(1, 0, static_cast<std::uint32_t>(pass / 2)).uniform2());
    return cellMiddle(pass, count) + (pass % 2 == 0 ? 1.0 : -1.0) * (place - 0.5) / std::sqrt(count) - 0.5;
  }
  return glm::dvec2(Random(0, 0, static_cast<std::uint32_t>(pass)).uniform2()) - 0.5;
}

unsigned SamplePasses::fewest() const {
  if (count <= MOST_OF_A_GRID) return FEWEST_OF_A_GRID;
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
