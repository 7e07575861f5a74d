#pragma once
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "shader/library.h"

namespace telar::shader {

enum class ToneMapping : std::uint8_t { kNone, kLinear, kReinhard, kCineon, kAces, kAgx, kNeutral };

/// Position in the list of tone mappings that the shot names. @throws Error{E_SHOT}
ToneMapping toneMappingByName(const std::string& name);

// One row a feature of surface.vert/.frag: GLSL define, member, name in info.features.
#define TELAR_SURFACE_FEATURES(F)                                       \
  F(UNLIT, unlit, "unlit")                                              \
  F(FLAT_SHADED, flatShaded, "flat-shading")                            \
  F(DOUBLE_SIDED, doubleSided, "double-sided")                          \
  F(FLIP_SIDED, flipSided, "back-faces-first")                          \
  F(ALPHA_MASK, alphaMask, "alpha-mask")                                \
  F(ALPHA_OPAQUE, alphaOpaque, "")                                      \
  F(VERTEX_COLOR, vertexColor, "vertex-color")                          \
  F(TANGENT, tangent, "tangents")                                       \
  F(BASE_COLOR_MAP, baseColorMap, "base-color-map")                     \
  F(METALLIC_ROUGHNESS_MAP, metallicRoughnessMap, "metallic-roughness-map") \
  F(NORMAL_MAP, normalMap, "normal-map")                                \
  F(OCCLUSION_MAP, occlusionMap, "occlusion-map")                       \
  F(EMISSIVE, emissive, "emissive")                                     \
  F(EMISSIVE_MAP, emissiveMap, "emissive-map")                          \
  F(BASE_COLOR_UV1, baseColorUv1, "")                                   \
  F(METALLIC_ROUGHNESS_UV1, metallicRoughnessUv1, "")                   \
  F(NORMAL_UV1, normalUv1, "")                                          \
  F(OCCLUSION_UV1, occlusionUv1, "")                                    \
  F(EMISSIVE_UV1, emissiveUv1, "")                                      \
  F(AMBIENT, ambient, "ambient-light")                                  \
  F(ENVIRONMENT, environment, "environment")                            \
  F(ORTHOGRAPHIC, orthographic, "orthographic")                         \
  F(POINTS, points, "points")                                           \
  F(OUTPUT_LINEAR, outputLinear, "linear-output")

/// What one surface program has compiled in. The key is the cache key: no hashes.
struct VariantKey {
#define TELAR_FEATURE_MEMBER(define, member, name) bool member = false;
  TELAR_SURFACE_FEATURES(TELAR_FEATURE_MEMBER)
#undef TELAR_FEATURE_MEMBER
  std::uint8_t pointLights = 0, spotLights = 0, directionalLights = 0, hemisphereLights = 0;
  ToneMapping toneMapping = ToneMapping::kNone;

  auto operator<=>(const VariantKey&) const = default;

  Defines defines() const;
  /// Names for info.features, in a fixed order.
  std::vector<std::string> features() const;
};

}  // namespace telar::shader
