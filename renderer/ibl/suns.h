#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::ibl {

/// Light of an equirectangular map that half floats do not hold: prefiltered cubes, three.js's and ours, are made of
/// halves, so a texel above 65504 counts as 65504 in them. What it has above that is a light of its own.
/// js/three/suns.mjs is the same in the browser.
struct Suns {
  struct Sun {
    glm::dvec3 direction;   ///< to it, as the map has it, unit
    glm::dvec3 irradiance;  ///< on a surface that faces it, linear Rec.709
  };

  static constexpr std::size_t MOST = 8;

  std::vector<Sun> list;  ///< at most MOST: what lies close together is one
  double share = 0;       ///< of the luminance of the whole map, 0..1
};

/// @param map  linear Rec.709, as EnvironmentRange::kFull gives it
Suns sunsOf(const ImageF& map);

}  // namespace telar::ibl
