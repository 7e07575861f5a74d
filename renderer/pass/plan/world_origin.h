#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "telar/scene.h"

namespace telar::pass {

/// How many diagonals of a model are far. js/shot/shadow.mjs has the same number.
constexpr double FAR_OUT = 1000;

/// Whether a point of the world is so far from a model that single precision cannot hold both.
inline bool isFarFrom(const Bounds& bounds, const glm::dvec3& point) {
  if (bounds.empty()) return false;
  const glm::dvec3 away = glm::abs(point - bounds.middle());
  return glm::max(away.x, glm::max(away.y, away.z)) > FAR_OUT * bounds.diagonal();
}

/// The origin of the world coordinates in shaders: the centre of a model that is far out, else the world's origin as in
/// three.js.
inline glm::dvec3 worldOrigin(const Bounds& bounds) {
  return isFarFrom(bounds, glm::dvec3(0)) ? bounds.middle() : glm::dvec3(0);
}

/// A matrix to the world, counted from `origin`; without one it keeps every bit.
inline glm::dmat4 fromOrigin(const glm::dmat4& toWorld, const glm::dvec3& origin) {
  return origin == glm::dvec3(0) ? toWorld : glm::translate(glm::dmat4(1.0), -origin) * toWorld;
}

/// A matrix from the world, for coordinates that are counted from `origin`.
inline glm::dmat4 toOrigin(const glm::dmat4& fromWorld, const glm::dvec3& origin) {
  return origin == glm::dvec3(0) ? fromWorld : glm::translate(fromWorld, origin);
}

}  // namespace telar::pass
