#pragma once
#include "brdf/brdf.h"
#include "telar/shading.h"

/// How the lobes of one surface add up, compiled from the text that the fragment shader runs (shaders/shading), with
/// every layer on: a layer of weight 0 changes nothing. In float and in double, as brdf.h.
#include "brdf/shading_layers_on.inl"
#define float Real

namespace telar::brdf_f {
#include "brdf/shading_declarations.inl"
}  // namespace telar::brdf_f

namespace telar::brdf_d {
#include "brdf/shading_declarations.inl"
}  // namespace telar::brdf_d

#undef float
#include "brdf/shading_layers_off.inl"
