#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace telar {

/// octahedronDirection() of shaders/octahedron.glsl, unit.
inline glm::vec3 octahedronDirection(const glm::vec2& place) {
  glm::vec3 d(place, 1 - std::abs(place.x) - std::abs(place.y));
  if (d.z < 0) d = {std::copysign(1 - std::abs(place.y), place.x), std::copysign(1 - std::abs(place.x), place.y), d.z};
  return glm::normalize(d);
}

}  // namespace telar
