#pragma once
#include "ibl/cube.h"

namespace telar::ibl {

/// An equirectangular map as a cube with all its levels, each texel the mean of those of the level before.
/// @return face size max(256, largest power of two <= width / 4)
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
CubeMap radianceCube(const gl::Context& context, const ImageF& map, const CancelToken& cancel);

/// Prefilters an equirectangular map into a GGX chain exactly as three.js 0.187's PMREMGenerator does.
/// @param map  linear Rec.709, finite, [0, 65504]
/// @return cube of face size max(256, largest power of two <= width / 4); level k of 0..maxLod = log2(faceSize) - 3
///         holds perceptual roughness 1 - sqrt(1 - k / maxLod); the last level (8 px) is also the irradiance / PI.
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
CubeMap prefilterEquirect(const gl::Context& context, const ImageF& map, const CancelToken& cancel);

/// Roughest level of a prefiltered cube.
int maxLodOf(const CubeMap& cube);

}  // namespace telar::ibl
