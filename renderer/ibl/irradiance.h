#pragma once
#include "ibl/octahedral_map.h"

namespace telar::ibl {

/// Mean radiance that a surface sees of an equirectangular map, weighted with the cosine, by the direction that it
/// faces: its irradiance / PI. Integrated over the map's own light with 2 degrees or less between what is taken
/// together.
/// @param map  linear Rec.709; the light of its alpha is not looked at
/// @return size 64, one level
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
OctahedralMap irradianceMap(const gl::Context& context, const ImageF& map, const CancelToken& cancel);

}  // namespace telar::ibl
