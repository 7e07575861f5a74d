#include "frame/sample_passes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/random.h"
#include "frame/pixel_mean.h"

namespace telar::frame {
namespace {

/// Up to here the shifts are a grid, which is nearer to the mean of a texture than as few scattered points. With more passes
/// it is not, and pixels seem settled too soon: what all points of a grid miss, its halves miss too.
constexpr int MOST_OF_A_GRID = 64;
/// What 16 points miss shows in the next 16, which lie between them.
constexpr unsigned FEWEST_OF_A_GRID = 32;

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
  if (count <= MOST_OF_A_GRID) return cellMiddle(pass, count) - 0.5;
  return glm::dvec2(Random(0, 0, static_cast<std::uint32_t>(pass)).uniform2()) - 0.5;
}

unsigned SamplePasses::fewest() const { return count <= MOST_OF_A_GRID ? FEWEST_OF_A_GRID : PixelMean::FEWEST; }

SamplePasses samplePassesOf(const Shot& shot) {
  if (shot.samples <= Shot::SAMPLES_OF_A_PASS) return {1, shot.samples};
  return {shot.samples, 1};
}

glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * shift / glm::dvec2(width, height), 0)) * projection;
}

}  // namespace telar::frame
