#include "reference/sampling.h"

#include <algorithm>
#include <cmath>

#include "brdf/brdf.h"

namespace telar::reference {

glm::vec3 sampleSphere(const glm::vec2& u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = 2 * brdf_f::PI * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

}  // namespace telar::reference
