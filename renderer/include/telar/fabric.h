#pragma once
#include "telar/texture_ref.h"

namespace telar {

/// One set of parallel yarns of a cloth. Colours are linear Rec.709, all numbers 0..1.
struct Yarn {
#include "telar/yarn.inc"
};

/// What cloth has beyond glTF's layers: KHR_materials_diffuse_transmission and TELAR_materials_fabric
/// (js/docs/fabric.md). Factors are linear Rec.709; the defaults change nothing.
struct FabricLayers {
#include "telar/fabric_layers.inc"

  bool weave = false;  ///< the yarns below are given; coverages sum to above 0, at most 1
  Yarn warp, weft;     ///< warp runs along Y of the tangent space (v upwards), weft along X (u)
  /// Yarns that one unit of u crosses (warp) and of v (weft), in the coordinates of weaveTexture after its transform;
  /// 0 = not known.
  glm::vec2 threadsPerUv{0.0f};
  /// linear: RG = (cos, sin) / 2 + 1/2 of the angle by which the yarn is turned counter-clockwise out of its own axis,
  /// B = sin / 2 + 1/2 of how steeply it rises along it, A = 0 weft .. 1 warp on top.
  TextureRef weaveTexture;

  bool back = false;                 ///< the back side looks different: these in place of the front's
  bool backHasColor = false;         ///< its colour is its own; else it is the front's, also where that is dyed
  glm::vec3 backColorFactor{1.0f};   ///< base colour
  TextureRef backColorTexture;       ///< sRGB
  float backRoughnessFactor = 1.0f;  ///< perceptual, without the front's texture
};

}  // namespace telar
