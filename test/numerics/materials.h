#pragma once
#include <string>

#include "seeded.h"
#include "telar/scene.h"

namespace telar::numerics {

/// Layers that a material may have; each compiles shader text of its own.
struct Layers {
  bool specular = false, clearcoat = false, sheen = false, anisotropy = false, iridescence = false,
       diffuseRoughness = false, transmission = false, volume = false, dispersion = false;
  bool weave = false, thin = false, flat = false, back = false;  ///< of FabricLayers

  static Layers random(Seeded& random);
};

/// A material with any values that the loader lets through for these layers, extremes included; no textures.
Material randomMaterial(Seeded& random, const Layers& layers);

/// White cloth of any mix of lobes: what a white furnace is held against.
Material whiteCloth(Seeded& random);

/// The values of a material that differ from its defaults, for messages.
std::string describe(const Material& material);

}  // namespace telar::numerics
