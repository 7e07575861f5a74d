#pragma once
#include "brdf/release_factors.h"
#include "brdf/shading.h"
#include "telar/scene.h"

namespace telar {

/// What materialInputs() of shaders/material/material_inputs.glsl gathers, of a material of the loader: factors times
/// texels.
/// @tparam Inputs   brdf_f::MaterialInputs or brdf_d::MaterialInputs
/// @param baseColor its factor times texel and vertex colour, linear Rec.709
/// @param three     the release, of the shading kThree
/// @param read      texel of a texture, (const TextureRef&, bool srgb) -> vec4; white where there is none
template <class Inputs, class Read>
Inputs materialInputs(const Material& material, const glm::vec3& baseColor, const ThreeTerms& three, const Read& read) {
  using Real = decltype(Inputs::roughness);
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Vec4 = glm::vec<4, Real>;
  const auto texel = [&](const TextureRef& texture, bool srgb) { return Vec4(read(texture, srgb)); };
  /// Between two factors as a texel says, the second without one.
  const auto within = [&](const glm::vec2& range, const TextureRef& texture, Real Vec4::*channel) {
    const Real low = range.x, high = range.y;
    return texture ? (high - low) * (texel(texture, false).*channel) + low : high;
  };
  const Vec4 metallicRoughness = texel(material.metallicRoughnessTexture, false);
  Inputs m{};
  m.baseColor = Vec3(baseColor);
  m.metallic = material.metallicFactor * metallicRoughness.b;
  m.roughness = material.roughnessFactor * metallicRoughness.g;
#include "brdf/layer_inputs.inc"
  m.three = three;
  const PhysicalLayers& l = material.layers;
  m.ior = iorOf(l, three);
  m.sheenRoughness = sheenRoughnessOf(l, three) * texel(l.sheenRoughnessTexture, false).a;
  return m;
}

}  // namespace telar
