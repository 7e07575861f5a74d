#pragma once
#include <glm/glm.hpp>

#include "telar/scene.h"

namespace telar::asset {

/// Bounding sphere as three.js builds it (math/Sphere.js): draws are sorted by its centre, so it must be the same one.
struct Sphere {
  glm::dvec3 center{0};
  double radius = -1;  ///< below 0 = empty

  static Sphere around(const Bounds& bounds);
  /// Grows just so far that the point lies inside.
  void add(const glm::dvec3& point);
  void add(const Sphere& other);
  Sphere transformed(const glm::dmat4& matrix) const;
};

}  // namespace telar::asset
