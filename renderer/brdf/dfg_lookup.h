#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "telar/shading.h"

namespace telar::brdf {

/// (A, B) of the split sum as halfs, a square of texels; x (fastest) = perceptualRoughness, y = NoV.
struct DfgTable {
  int size;  ///< texels on a side
  const std::uint16_t* halfs;
};

/// The table that a release of three.js reads; of one that has none, that of 0.187.
DfgTable dfgTableOf(const ThreeTerms& three);

/// (A, B) of the split sum by perceptual roughness and NoV, each [0, 1].
using DfgLookup = glm::vec2 (*)(float perceptualRoughness, float NoV);

/// As a shader reads the table of three.js 0.187: bilinear, clamped at the edges.
glm::vec2 dfgLookup(float perceptualRoughness, float NoV);

/// As a release of three.js has it, by a table or by a fit.
DfgLookup dfgOf(const ThreeTerms& three);

}  // namespace telar::brdf
