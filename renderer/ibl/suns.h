#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::ibl {

/// The light of an equirectangular map above the largest half float. Prefiltered cubes, three.js's and ours, hold half
/// floats, which clamp a texel to 65504. What a texel has above that becomes a directional light.
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

/// @param map  linear Rec.709, as EnvironmentRange::kFull gives it
Suns sunsOf(const ImageF& map);

}  // namespace telar::ibl
