#include <cmath>
#include <new>

#include "brdf/brdf.h"
#include "brdf/dfg_lookup.h"
#include "brdf/shading.h"

namespace telar::brdf_f {
namespace {
#include "brdf/runtime.inl"
}  // namespace
#define float Real
#include "brdf/definitions.inl"
// In this order.
// clang-format off
#include "brdf/shading_layers_on.inl"
#define TELAR_WITH_VARIANTS
#include "brdf/shading_definitions.inl"
#undef TELAR_WITH_VARIANTS
#include "brdf/shading_layers_off.inl"
// clang-format on
#undef float
}  // namespace telar::brdf_f
