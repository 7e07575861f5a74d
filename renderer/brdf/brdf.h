#pragma once
#include <glm/glm.hpp>

#include "telar/shot/tone_mapping.inc"

/// The shading terms of shaders/brdf/*.glsl as C++ functions, compiled from the very same text: telar::brdf_f in float,
/// step for step what the shader does, and telar::brdf_d in double, the reference for both.
/// Shapes, units, ranges and sources stand beside each function in its .glsl file.
// The shared text says `float` for its scalar, hence the macro; it does not outlive this header.
#define float Real

namespace telar::brdf_f {
using Real = decltype(0.0f);
#include "brdf/declarations.inl"
}  // namespace telar::brdf_f

namespace telar::brdf_d {
using Real = double;
#include "brdf/declarations.inl"
}  // namespace telar::brdf_d

#undef float
