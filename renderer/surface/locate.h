#pragma once
#include "surface/surface.h"

namespace telar::surface {

/// A point on the surface.
struct Place {
  std::uint32_t face = NONE;
  glm::dvec3 weights{1, 0, 0};  ///< barycentric, of the face's corners: 0..1, sum 1
  glm::dvec3 position{0};       ///< metres, world space
  double distance = 0;          ///< metres from where it was asked for
};

/// The point of the surface that is nearest to p. The surface has faces.
/// @throws Error{X_CANCELLED}
Place nearestPlace(const Surface& surface, const glm::dvec3& p, const CancelToken& cancel);
/// Of these faces alone. Its distance is infinite where there are none.
Place nearestOf(const Surface& surface, const glm::dvec3& p, std::span<const std::uint32_t> faces);

Place placeAt(const Surface& surface, std::uint32_t face, const glm::dvec3& weights);

/// Barycentric weights of the point of a triangle that is nearest to p, a flat one too (Ericson 2005, "Real-Time
/// Collision Detection", section 5.1.5).
glm::dvec3 nearestWeights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace telar::surface
