#include "frame/sample_passes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "core/random.h"

namespace telar::frame {

glm::dvec2 SamplePasses::shift(int pass) const {
  if (count == 1) return glm::dvec2(0);
  return glm::dvec2(Random(0, 0, static_cast<std::uint32_t>(pass)).uniform2()) - 0.5;
}

SamplePasses samplePassesOf(const Shot& shot) {
  if (shot.samples <= Shot::SAMPLES_OF_A_PASS) return {1, shot.samples};
  return {shot.samples, 1};
}

glm::dmat4 shifted(const glm::dmat4& projection, const glm::dvec2& shift, int width, int height) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(2.0 * shift / glm::dvec2(width, height), 0)) * projection;
}

}  // namespace telar::frame
