#pragma once
#include <algorithm>

#include "telar/scene.h"
#include "telar/shading.h"

namespace telar {

/// Index of refraction as a release of three.js has it, to which some give that of 0 as it stands. The loader writes
/// 1000 for it.
inline float iorOf(const PhysicalLayers& layers, const ThreeTerms& three) {
  constexpr float INFINITE = 1000;
  return three.ior0 == ThreeTerms::THREE_IOR0_ZERO && layers.ior == INFINITE ? 0.0f : layers.ior;
}

/// Factor of the sheen's roughness as a release of three.js has it: some do not go below 0.07 before the texture.
inline float sheenRoughnessOf(const PhysicalLayers& layers, const ThreeTerms& three) {
  constexpr float LEAST = 0.07f;
  const bool floored = three.sheenAlbedo == ThreeTerms::THREE_SHEEN_ALBEDO_TWO_RANGES;
  return floored ? std::max(layers.sheenRoughnessFactor, LEAST) : layers.sheenRoughnessFactor;
}

}  // namespace telar
