#pragma once
#include "shadings.h"
#include "surface_point.h"

namespace telar::numerics {

/// Radiance, of light of irradiance 1, below which an error counts as absolute: a fortieth of the smallest step of
/// 8 bits.
constexpr double RADIANCE_FLOOR = 1e-4;

/// Largest relative error of the three channels.
double relativeError(const glm::vec3& actual, const glm::dvec3& expected);

/// What of the error of direct light the rounding of its directions does not explain: what is left when the parts of n,
/// v and l have moved by a few steps of single precision, which no arithmetic in single precision can tell apart. Terms
/// that are written in ways that lose digits (a distribution from a cosine) are judged by it where the error itself is
/// large.
double unexplainedError(ShadingModel model, const SurfacePoint& point, const glm::vec3& actual,
                        const glm::dvec3& expected);

/// How narrow the narrowest lobe of a point is.
enum class Width { kRough, kSmooth, kThinFuzz };

/// @return kSmooth below a perceptual roughness of 0.2; kThinFuzz for sheen below 0.07 of a stock shading, whose
///   distribution raises the rounding of a sine to a power that single precision has no digits for
Width widthOf(const ShadingPromise& shading, const SurfacePoint& point);

const char* nameOf(Width width);

/// Bar of the relative error.
double errorBar(const ShadingPromise& shading, Width width);

}  // namespace telar::numerics
