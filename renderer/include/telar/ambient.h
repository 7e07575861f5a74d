#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "telar/cancel.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

/// A point of a surface, in world space.
struct SurfacePoint {
  glm::dvec3 position{0};  ///< metres
  glm::vec3 normal{0};     ///< geometric, unit, on the viewer's side
  glm::vec3 toViewer{0};   ///< unit: what is culled that way hides nothing
  /// Rays that it casts, and the number of the first: those of several points fill the hemisphere evenly together where
  /// each has a power of two of them, and starts at a multiple of it.
  std::uint32_t rays = 0, firstRay = 0;
};

/// Ambient occlusion of points: part of the hemisphere above each that is open to infinity, weighted by the cosine,
/// 0..1. By rays on threads of its own, through libtelar_reference.so, which alone links Embree.
/// @param shot  its variant and its shading
/// @throws Error{X_LIBRARY_MISSING, X_REFERENCE, X_MEMORY, X_CANCELLED, E_VARIANT}
std::vector<float> ambientOcclusion(const Scene& scene, const Shot& shot, std::span<const SurfacePoint> points,
                                    const CancelToken& cancel);

}  // namespace telar
