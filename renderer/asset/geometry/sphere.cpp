#include "asset/geometry/sphere.h"

#include <algorithm>

namespace telar::asset {

Sphere Sphere::around(const Bounds& bounds) { return {bounds.middle(), bounds.diagonal() / 2}; }

void Sphere::add(const glm::dvec3& point) {
  if (radius < 0) {
    center = point;
    radius = 0;
    return;
  }
  const glm::dvec3 way = point - center;
  const double distance = glm::length(way);
  if (!(distance > radius)) return;
  const double growth = (distance - radius) * 0.5;
  center += way * (growth / distance);
  radius += growth;
}

void Sphere::add(const Sphere& other) {
  if (other.radius < 0) return;
  if (radius < 0) {
    *this = other;
  } else if (center == other.center) {
    radius = std::max(radius, other.radius);
  } else {
    const glm::dvec3 reach = glm::normalize(other.center - center) * other.radius;
    add(other.center + reach);
    add(other.center - reach);
  }
}

Sphere Sphere::transformed(const glm::dmat4& m) const {
  const double scale =
      std::max({glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))});
  return {glm::dvec3(m * glm::dvec4(center, 1.0)), radius * scale};
}

}  // namespace telar::asset
