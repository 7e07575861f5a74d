#pragma once
#include <cmath>

#include "brdf/shading.h"
#include "telar/scene.h"

namespace telar {

/// What materialInputs() of shaders/material/material_inputs.glsl gathers, of a material of the loader.
/// @tparam Inputs   brdf_f::MaterialInputs or brdf_d::MaterialInputs
/// @param baseColor its factor times texel and vertex colour, linear Rec.709
/// @param read      texel of a texture, (const TextureRef&, bool srgb) -> vec4; white where there is none
template <class Inputs, class Read>
Inputs materialInputs(const Material& material, const glm::vec3& baseColor, const Read& read) {
  using Real = decltype(Inputs::roughness);
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Vec4 = glm::vec<4, Real>;
  const PhysicalLayers& l = material.layers;
  const FabricLayers& f = material.fabric;
  const auto data = [&](const TextureRef& texture) { return Vec4(read(texture, false)); };
  const auto color = [&](const glm::vec3& factor, const TextureRef& texture) {
    return Vec3(factor) * Vec3(read(texture, true));
  };
  Inputs m{};
  m.baseColor = Vec3(baseColor);
  const Vec4 metallicRoughness = data(material.metallicRoughnessTexture);
  m.metallic = material.metallicFactor * metallicRoughness.b;
  m.roughness = material.roughnessFactor * metallicRoughness.g;
  m.ior = l.ior;
  m.specular = l.specularFactor * data(l.specularTexture).a;
  m.specularColor = color(l.specularColorFactor, l.specularColorTexture);
  m.clearcoat = l.clearcoatFactor * data(l.clearcoatTexture).r;
  m.clearcoatRoughness = l.clearcoatRoughnessFactor * data(l.clearcoatRoughnessTexture).g;
  m.sheenColor = color(l.sheenColorFactor, l.sheenColorTexture);
  m.sheenRoughness = l.sheenRoughnessFactor * data(l.sheenRoughnessTexture).a;
  const Real strength = l.anisotropyStrength, rotation = l.anisotropyRotation;
  m.anisotropyVector = strength * Vec2(std::cos(rotation), std::sin(rotation));
  m.anisotropyTexel = l.anisotropyTexture ? Vec3(data(l.anisotropyTexture)) : Vec3(Real(0.5), Real(0.5), 1);
  m.iridescence = l.iridescenceFactor * data(l.iridescenceTexture).r;
  m.iridescenceIor = l.iridescenceIor;
  const Real thin = l.iridescenceThicknessMinimum, thick = l.iridescenceThicknessMaximum;
  m.iridescenceThickness =
      l.iridescenceThicknessTexture ? (thick - thin) * data(l.iridescenceThicknessTexture).g + thin : thick;
  m.diffuseRoughness = l.diffuseRoughnessFactor * data(l.diffuseRoughnessTexture).r;
  m.diffuseTransmission = f.diffuseTransmissionFactor * data(f.diffuseTransmissionTexture).a;
  m.diffuseTransmissionColor = color(f.diffuseTransmissionColorFactor, f.diffuseTransmissionColorTexture);
  m.flatness = f.flatness;
  m.yarnCoverage = Vec2(f.warp.coverage, f.weft.coverage);
  m.yarnRoughness = Vec2(f.warp.roughness, f.weft.roughness) * metallicRoughness.g;
  m.yarnAnisotropy = Vec2(f.warp.anisotropy, f.weft.anisotropy);
  m.warpSpecularColor = Vec3(f.warp.specularColor);
  m.weftSpecularColor = Vec3(f.weft.specularColor);
  m.yarnTurn = Vec2(1, 0);
  m.yarnSlope = 0;
  return m;
}

}  // namespace telar
