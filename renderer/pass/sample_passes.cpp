#include "pass/sample_passes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace telar::pass {
glm::dvec2 SamplePasses::shift(int pass) const {
  // src: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2: the first passes fill the pixel
  // evenly however many follow, and share no structure with the directions that they draw.
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  return glm::fract(0.5 + step * static_cast<double>(pass)) - 0.5;
}

SamplePasses samplePassesOf(const Shot& shot) {
  if (shot.samples <= Shot::SAMPLES_OF_A_PASS) return {1, shot.samples};
  return {shot.samples, 1};
}

glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * shift / glm::dvec2(width, height), 0)) * projection;
}

}  // namespace telar::pass
