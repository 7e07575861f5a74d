#include "pass/sample_passes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace telar::pass {
namespace {

/// Van der Corput sequence in base 2, [0, 1).
double radicalInverse(unsigned i) {
  double sum = 0;
  for (double part = 0.5; i > 0; i >>= 1, part /= 2) sum += (i & 1) * part;
  return sum;
}

}  // namespace

glm::dvec2 SamplePasses::shift(int pass) const {
  // Hammersley's points have one in every cell of any division of the pixel into `count` cells.
  const glm::dvec2 point(static_cast<double>(pass) / count, radicalInverse(static_cast<unsigned>(pass)));
  return point + 0.5 / count - 0.5;
}

SamplePasses samplePassesOf(const Shot& shot) {
  if (shot.samples <= Shot::SAMPLES_OF_A_PASS) return {1, shot.samples};
  return {shot.samples, 1};
}

glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * shift / glm::dvec2(width, height), 0)) * projection;
}

}  // namespace telar::pass
