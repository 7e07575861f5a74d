#include <cmath>

#include "brdf/brdf.h"

namespace telar::brdf_d {
namespace {
#include "brdf/runtime.inl"
}  // namespace
#define float Real
#include "brdf/definitions.inl"
#undef float
}  // namespace telar::brdf_d
