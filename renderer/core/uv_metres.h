#pragma once
#include <glm/glm.hpp>

namespace telar {

/// Metres that one unit of u and one of v cover on a triangle: over it a point is a linear function of (u, v), whose
/// derivatives have these lengths. Not finite where it has no area in the texture.
/// @param p, q  its edges from one corner, metres
/// @param a, b  the same edges in texture coordinates
inline glm::dvec2 uvMetres(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec2& a, const glm::dvec2& b) {
  const double determinant = a.x * b.y - a.y * b.x;
  return {glm::length((b.y * p - a.y * q) / determinant), glm::length((a.x * q - b.x * p) / determinant)};
}

}  // namespace telar
