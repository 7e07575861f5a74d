#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "shader/layer_features.inc"
#include "shader/library.h"
#include "telar/shading.h"
#include "telar/shot/tone_mapping.inc"

namespace telar::shader {

using shot::ToneMapping;

// One row a feature of surface.vert/.frag: GLSL define, member, name in info.features. Those of layers are in
// js/material/table.mjs.
#define TELAR_SURFACE_FEATURES(F)                                           \
  F(UNLIT, unlit, "unlit")                                                  \
  F(FLAT_SHADED, flatShaded, "flat-shading")                                \
  F(DOUBLE_SIDED, doubleSided, "double-sided")                              \
  F(FLIP_SIDED, flipSided, "back-faces-first")                              \
  F(ALPHA_MASK, alphaMask, "alpha-mask")                                    \
  F(ALPHA_OPAQUE, alphaOpaque, "")                                          \
  F(VERTEX_COLOR, vertexColor, "vertex-color")                              \
  F(INSTANCING, instancing, "instancing")                                   \
  F(INSTANCE_COLOR, instanceColor, "instance-color")                        \
  F(TANGENT, tangent, "tangents")                                           \
  F(BASE_COLOR_MAP, baseColorMap, "base-color-map")                         \
  F(METALLIC_ROUGHNESS_MAP, metallicRoughnessMap, "metallic-roughness-map") \
  F(NORMAL_MAP, normalMap, "normal-map")                                    \
  F(OCCLUSION_MAP, occlusionMap, "occlusion-map")                           \
  F(OCCLUSION_WITH_ROUGHNESS, occlusionWithRoughness, "")                   \
  F(EMISSIVE, emissive, "emissive")                                         \
  F(EMISSIVE_MAP, emissiveMap, "emissive-map")                              \
  F(BASE_COLOR_UV1, baseColorUv1, "")                                       \
  F(METALLIC_ROUGHNESS_UV1, metallicRoughnessUv1, "")                       \
  F(NORMAL_UV1, normalUv1, "")                                              \
  F(OCCLUSION_UV1, occlusionUv1, "")                                        \
  F(EMISSIVE_UV1, emissiveUv1, "")                                          \
  F(TANGENT_FRAME_UV0, tangentFrameUv0, "")                                 \
  TELAR_LAYER_FEATURES(F)                                                   \
  F(AMBIENT_VISIBILITY, ambientVisibility, "ambient-visibility")            \
  F(AMBIENT_VISIBILITY_BACK, ambientVisibilityBack, "")                     \
  F(NORMAL_VARIANCE, normalVariance, "normal-variance")                     \
  F(NORMAL_FACETS, normalFacets, "normal-facets")                           \
  F(ALPHA_TO_COVERAGE, alphaToCoverage, "alpha-to-coverage")                \
  F(ALPHA_MEANS, alphaMeans, "")                                            \
  F(NORMAL_HOLES, normalHoles, "")                                          \
  F(METAL_MEANS, metalMeans, "metal-means")                                 \
  F(METAL_YARNS, metalYarns, "")                                            \
  F(YARN_RELIEF, yarnRelief, "yarn-relief")                                 \
  F(AMBIENT, ambient, "ambient-light")                                      \
  F(ENVIRONMENT, environment, "environment")                                \
  F(ORTHOGRAPHIC, orthographic, "orthographic")                             \
  F(POINTS, points, "points")                                               \
  F(VISIBILITY_BUFFER, visibilityBuffer, "")                                \
  F(DEBUG_OUTPUT, debugOutput, "debug-output")                              \
  F(OUTPUT_LINEAR, outputLinear, "linear-output")

/// The lights that lit surfaces of a frame see, by kind.
struct LightCounts {
  std::uint16_t point = 0, spot = 0, directional = 0, hemisphere = 0, rect = 0, disk = 0;
  std::uint16_t suns = 0;  ///< of the directional ones, the last: small lights of the environment
  std::uint16_t pointShadows = 0, spotShadows = 0, directionalShadows = 0;  ///< the first lights of each kind cast one

  int area() const { return rect + disk; }
  int shadows() const { return pointShadows + spotShadows + directionalShadows; }

  auto operator<=>(const LightCounts&) const = default;
};

/// What one surface program has compiled in. The key is the cache key: no hashes.
struct VariantKey {
#define TELAR_FEATURE_MEMBER(define, member, name) bool member = false;
  TELAR_SURFACE_FEATURES(TELAR_FEATURE_MEMBER)
#undef TELAR_FEATURE_MEMBER
  LightCounts lights;
  ShadingModel shading = ShadingModel::kThree;
  ShadingTerms terms;              ///< of a principled shading, else as made
  ThreeTerms three;                ///< of kThree, and of what an unlit material takes of a release
  bool fullDetail = false;         ///< maps are read at level 0: the passes over a picture filter them
  bool ownPlaces = false;          ///< each pixel has places of its own where passes read the maps
  std::vector<std::uint8_t> uvOf;  ///< of each of its maps the first one with the same coordinates; empty: own ones
  bool captured = false;           ///< its vertex stage alone, for VISIBILITY_BUFFER
  bool layers = false;             ///< draws layers/layers.frag in place of the colour
  std::uint16_t environmentSamples = 0;  ///< directions of the environment a pass; 0 = prefiltered
  ToneMapping toneMapping = ToneMapping::kNone;

  /// Most directions of the environment's bright part, a pass.
  int brightDirections() const { return std::clamp(environmentSamples / 4, 1, 32); }

  auto operator<=>(const VariantKey&) const = default;

  Defines defines() const;
  /// Names for info.features, in a fixed order.
  std::vector<std::string> features() const;
};

}  // namespace telar::shader
