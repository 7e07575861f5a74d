#pragma once
#include "brdf/shading.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::lobes {

/// The surface that the raster's shaders read from a material's factors, in the tangent frame of telar/lobes.h, not yet
/// prepared.
/// @param v  unit, to the viewer
brdf_d::SurfaceInfo surfaceOf(const Material& material, const Shot& shot, const glm::dvec3& v);

}  // namespace telar::lobes
