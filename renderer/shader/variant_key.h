#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "shader/library.h"
#include "telar/shading.h"
#include "telar/shot/tone_mapping.inc"

namespace telar::shader {

using shot::ToneMapping;

// One row a feature of surface.vert/.frag: GLSL define, member, name in info.features.
#define TELAR_SURFACE_FEATURES(F)                                                                  \
  F(UNLIT, unlit, "unlit")                                                                         \
  F(FLAT_SHADED, flatShaded, "flat-shading")                                                       \
  F(DOUBLE_SIDED, doubleSided, "double-sided")                                                     \
  F(FLIP_SIDED, flipSided, "back-faces-first")                                                     \
  F(ALPHA_MASK, alphaMask, "alpha-mask")                                                           \
  F(ALPHA_OPAQUE, alphaOpaque, "")                                                                 \
  F(VERTEX_COLOR, vertexColor, "vertex-color")                                                     \
  F(INSTANCING, instancing, "instancing")                                                          \
  F(INSTANCE_COLOR, instanceColor, "instance-color")                                               \
  F(TANGENT, tangent, "tangents")                                                                  \
  F(BASE_COLOR_MAP, baseColorMap, "base-color-map")                                                \
  F(METALLIC_ROUGHNESS_MAP, metallicRoughnessMap, "metallic-roughness-map")                        \
  F(NORMAL_MAP, normalMap, "normal-map")                                                           \
  F(OCCLUSION_MAP, occlusionMap, "occlusion-map")                                                  \
  F(EMISSIVE, emissive, "emissive")                                                                \
  F(EMISSIVE_MAP, emissiveMap, "emissive-map")                                                     \
  F(BASE_COLOR_UV1, baseColorUv1, "")                                                              \
  F(METALLIC_ROUGHNESS_UV1, metallicRoughnessUv1, "")                                              \
  F(NORMAL_UV1, normalUv1, "")                                                                     \
  F(OCCLUSION_UV1, occlusionUv1, "")                                                               \
  F(EMISSIVE_UV1, emissiveUv1, "")                                                                 \
  F(TANGENT_FRAME_UV0, tangentFrameUv0, "")                                                        \
  F(SPECULAR, specular, "specular")                                                                \
  F(SPECULAR_MAP, specularMap, "specular-map")                                                     \
  F(SPECULAR_UV1, specularUv1, "")                                                                 \
  F(SPECULAR_COLOR_MAP, specularColorMap, "specular-color-map")                                    \
  F(SPECULAR_COLOR_UV1, specularColorUv1, "")                                                      \
  F(CLEARCOAT, clearcoat, "clearcoat")                                                             \
  F(CLEARCOAT_MAP, clearcoatMap, "clearcoat-map")                                                  \
  F(CLEARCOAT_UV1, clearcoatUv1, "")                                                               \
  F(CLEARCOAT_ROUGHNESS_MAP, clearcoatRoughnessMap, "clearcoat-roughness-map")                     \
  F(CLEARCOAT_ROUGHNESS_UV1, clearcoatRoughnessUv1, "")                                            \
  F(CLEARCOAT_NORMAL_MAP, clearcoatNormalMap, "clearcoat-normal-map")                              \
  F(CLEARCOAT_NORMAL_UV1, clearcoatNormalUv1, "")                                                  \
  F(SHEEN, sheen, "sheen")                                                                         \
  F(SHEEN_COLOR_MAP, sheenColorMap, "sheen-color-map")                                             \
  F(SHEEN_COLOR_UV1, sheenColorUv1, "")                                                            \
  F(SHEEN_ROUGHNESS_MAP, sheenRoughnessMap, "sheen-roughness-map")                                 \
  F(SHEEN_ROUGHNESS_UV1, sheenRoughnessUv1, "")                                                    \
  F(ANISOTROPY, anisotropy, "anisotropy")                                                          \
  F(ANISOTROPY_MAP, anisotropyMap, "anisotropy-map")                                               \
  F(ANISOTROPY_UV1, anisotropyUv1, "")                                                             \
  F(IRIDESCENCE, iridescence, "iridescence")                                                       \
  F(IRIDESCENCE_MAP, iridescenceMap, "iridescence-map")                                            \
  F(IRIDESCENCE_UV1, iridescenceUv1, "")                                                           \
  F(IRIDESCENCE_THICKNESS_MAP, iridescenceThicknessMap, "iridescence-thickness-map")               \
  F(IRIDESCENCE_THICKNESS_UV1, iridescenceThicknessUv1, "")                                        \
  F(DIFFUSE_ROUGHNESS, diffuseRoughness, "diffuse-roughness")                                      \
  F(DIFFUSE_ROUGHNESS_MAP, diffuseRoughnessMap, "diffuse-roughness-map")                           \
  F(DIFFUSE_ROUGHNESS_UV1, diffuseRoughnessUv1, "")                                                \
  F(TRANSMISSION, transmission, "transmission")                                                    \
  F(TRANSMISSION_MAP, transmissionMap, "transmission-map")                                         \
  F(TRANSMISSION_UV1, transmissionUv1, "")                                                         \
  F(VOLUME, volume, "volume")                                                                      \
  F(THICKNESS_MAP, thicknessMap, "thickness-map")                                                  \
  F(THICKNESS_UV1, thicknessUv1, "")                                                               \
  F(ATTENUATION, attenuation, "attenuation")                                                       \
  F(DISPERSION, dispersion, "dispersion")                                                          \
  F(DIFFUSE_TRANSMISSION, diffuseTransmission, "diffuse-transmission")                             \
  F(DIFFUSE_TRANSMISSION_MAP, diffuseTransmissionMap, "diffuse-transmission-map")                  \
  F(DIFFUSE_TRANSMISSION_UV1, diffuseTransmissionUv1, "")                                          \
  F(DIFFUSE_TRANSMISSION_COLOR_MAP, diffuseTransmissionColorMap, "diffuse-transmission-color-map") \
  F(DIFFUSE_TRANSMISSION_COLOR_UV1, diffuseTransmissionColorUv1, "")                               \
  F(FLATNESS, flatness, "flatness")                                                                \
  F(WEAVE, weave, "weave")                                                                         \
  F(WEAVE_MAP, weaveMap, "weave-map")                                                              \
  F(WEAVE_UV1, weaveUv1, "")                                                                       \
  F(BACK, back, "back-side")                                                                       \
  F(BACK_COLOR_MAP, backColorMap, "back-color-map")                                                \
  F(BACK_COLOR_UV1, backColorUv1, "")                                                              \
  F(NORMAL_VARIANCE, normalVariance, "normal-variance")                                            \
  F(ALPHA_TO_COVERAGE, alphaToCoverage, "alpha-to-coverage")                                       \
  F(AMBIENT, ambient, "ambient-light")                                                             \
  F(ENVIRONMENT, environment, "environment")                                                       \
  F(ORTHOGRAPHIC, orthographic, "orthographic")                                                    \
  F(POINTS, points, "points")                                                                      \
  F(DEBUG_OUTPUT, debugOutput, "debug-output")                                                     \
  F(OUTPUT_LINEAR, outputLinear, "linear-output")

/// The lights that lit surfaces of a frame see, by kind.
struct LightCounts {
  std::uint8_t point = 0, spot = 0, directional = 0, hemisphere = 0, rect = 0, disk = 0;
  std::uint8_t pointShadows = 0, spotShadows = 0, directionalShadows = 0;  ///< the first lights of each kind cast one

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
  ShadingTerms terms;                    ///< of a principled shading, else as made
  bool fullDetail = false;               ///< maps are read at level 0: the passes over a picture filter them
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
