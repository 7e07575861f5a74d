#pragma once
#include "ibl/cube.h"
#include "telar/shot/raster_quality.inc"

namespace telar::ibl {

/// How a map is prefiltered: environmentSize and prefilterSamples of a quality. The defaults are what three.js does.
struct PrefilterSettings {
  int faceSize = shot::RasterQuality{}.environmentSize;  ///< px, a power of two, at least 64; 0 = that of the map
  int samples = shot::RasterQuality{}.prefilterSamples;  ///< a power of two

  bool operator==(const PrefilterSettings&) const = default;
};

/// Prefilters an equirectangular map into a GGX chain exactly as three.js 0.187's PMREMGenerator does, unless the
/// settings say otherwise.
/// @param map  linear Rec.709, finite, [0, 65504]
/// @return cube of the settings' face size, else max(256, largest power of two <= width / 4); level k of
///         0..maxLod = log2(faceSize) - 3 holds perceptual roughness 1 - sqrt(1 - k / maxLod); the last level (8 px) is
///         also the irradiance / PI.
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
CubeMap prefilterEquirect(const gl::Context& context, const ImageF& map, const CancelToken& cancel,
                          const PrefilterSettings& settings = {});

/// Roughest level of a prefiltered cube.
int maxLodOf(const CubeMap& cube);

}  // namespace telar::ibl
