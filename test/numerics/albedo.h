#pragma once
#include "evaluate.h"

namespace telar::numerics {

/// What a surface sends to its viewer of direct light from everywhere, radiance 1: the green channel, by a quadrature
/// that knows the lobes of every shading.
/// @param points  of each lobe
double directAlbedo(const Shaded<double>& shaded, int points);

}  // namespace telar::numerics
