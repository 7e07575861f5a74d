#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace telar::reference {

/// A unit direction, all as likely. @param u  [0, 1)^2
inline glm::vec3 sampleSphere(const glm::vec2& u) {
  constexpr float TWO_PI = 6.2831853f;
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = TWO_PI * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}
constexpr float PDF_SPHERE = 0.079577472f;  ///< 1 / (4 pi), per steradian

}  // namespace telar::reference
