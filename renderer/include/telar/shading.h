#pragma once
#include <cstdint>

namespace telar {

/// How light and cloth meet: the key `shading` of a shot.
enum class ShadingModel : std::uint8_t {
  kThree,       ///< what three.js 0.187 shows
  kThreeR115,   ///< what three.js r115 showed, as the thesis lists it
  kDisney2012,  ///< Burley 2012, "Physically-Based Shading at Disney"
  kFabric,      ///< telar's model of cloth
};

}  // namespace telar
