#pragma once
#include "telar/texture_ref.h"

namespace telar {

/// One set of parallel yarns of a cloth. Colours are linear Rec.709.
struct Yarn {
  float coverage = 0.5f;          ///< share of the surface that shows it, 0..1
  float roughness = 0.5f;         ///< perceptual, across the yarn
  float anisotropy = 0.0f;        ///< 0..1, how much rougher along it than across, as KHR_materials_anisotropy has it
  glm::vec3 specularColor{1.0f};  ///< factor on its normal reflectance
};

/// What cloth has beyond glTF's layers: KHR_materials_diffuse_transmission and TELAR_materials_fabric. Factors are
/// linear Rec.709; the defaults change nothing.
struct FabricLayers {
  float diffuseTransmissionFactor = 0.0f;  ///< share of the diffuse light that goes through to the other side
  TextureRef diffuseTransmissionTexture;   ///< linear: A
  glm::vec3 diffuseTransmissionColorFactor{1.0f};
  TextureRef diffuseTransmissionColorTexture;  ///< sRGB
  float flatness = 0.0f;                       ///< 0..1, from Lambert's diffuse to that of a thin scattering sheet

  bool weave = false;            ///< the yarns below are given; coverages sum to at most 1
  Yarn warp, weft;               ///< warp runs along v, weft along u of `weaveTexture`'s UV set
  glm::vec2 threadsPerUv{0.0f};  ///< yarns that one unit of u crosses (warp) and of v (weft); 0 = not known
  TextureRef weaveTexture;       ///< linear: RG in-plane direction of the yarn, B its tilt, A 0 weft .. 1 warp

  bool back = false;                 ///< the back side looks different
  glm::vec3 backColorFactor{1.0f};   ///< base colour of the back
  TextureRef backColorTexture;       ///< sRGB
  float backRoughnessFactor = 1.0f;  ///< perceptual
};

}  // namespace telar
