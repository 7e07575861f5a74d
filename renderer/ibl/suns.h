#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::ibl {

/// The light of an equirectangular map that prefiltered cubes do not hold well, as directional lights. What hides the
/// environment from a surface hides them (shaders/light/one_light.glsl).
/// js/three/suns.mjs is the same in the browser.
struct Suns {
  struct Sun {
    glm::dvec3 direction;   ///< to it, as the map has it, unit
    glm::dvec3 irradiance;  ///< on a surface that faces it, linear Rec.709
  };

  static constexpr std::size_t MOST = 8;

  std::vector<Sun> list;  ///< at most MOST: texels that are close together make one
  double share = 0;       ///< of the luminance of the whole map, 0..1
};

/// The light above the largest half float: cubes, three.js's and ours, hold half floats, which clamp a texel to 65504.
/// @param map  linear Rec.709, as EnvironmentRange::kFull gives it
Suns sunsOf(const ImageF& map);

/// The same, and small lights of any radiance before it: a texel far brighter than the mean of the map is dimmed, and
/// the rest of its light is a sun's. Prefiltered, a sun of half a degree would be as wide as a texel of the cube, and
/// as the samples that it was made of lie apart. Where there is more than a few such lights, all stay in the map.
/// @param map  loses the light that the suns have, but what halves do not hold
Suns takeSuns(ImageF& map);

}  // namespace telar::ibl
