#include "lobes/material_surface.h"

#include <algorithm>
#include <cmath>

#include "brdf/dfg_lookup.h"

namespace telar::lobes {
namespace {

using brdf_d::SurfaceInfo;

glm::dvec2 dfg(double perceptualRoughness, double NoV) {
  return glm::dvec2(brdf::dfgLookup(static_cast<float>(perceptualRoughness), static_cast<float>(NoV)));
}

/// A principled shading takes roughness as authored.
double roughnessOf(double authored, bool principled) {
  return principled ? authored : brdf_d::shadedRoughness(authored, 0);
}

void readBase(SurfaceInfo& s, const Material& m, bool principled) {
  const PhysicalLayers& l = m.layers;
  s.baseColor = glm::dvec3(m.baseColorFactor);
  s.metallic = m.metallicFactor;
  s.diffuse = brdf_d::diffuseAlbedo(s.baseColor, s.metallic);
  s.f0Dielectric = glm::dvec3(brdf_d::F0_DIELECTRIC);
  s.f90 = 1;
  if (m.physical) {
    const double factor = l.specularFactor, ratio = (l.ior - 1.0) / (l.ior + 1.0);
    s.f90 = glm::mix(factor, 1.0, s.metallic);
    s.f0Dielectric = glm::min(ratio * ratio * glm::dvec3(l.specularColorFactor), glm::dvec3(1)) * factor;
  }
  s.f0 = glm::mix(s.f0Dielectric, s.baseColor, s.metallic);
  s.perceptualRoughness = roughnessOf(m.roughnessFactor, principled);
  s.alpha = brdf_d::alphaFromRoughness(s.perceptualRoughness);
  s.dfg = dfg(s.perceptualRoughness, s.NoV);
}

void readAnisotropy(SurfaceInfo& s, const PhysicalLayers& l) {
  s.anisotropyStrength = brdf_d::saturate(l.anisotropyStrength);
  s.alphaT = brdf_d::alphaAlongTangent(s.perceptualRoughness, s.anisotropyStrength);
  const double cos = std::cos(l.anisotropyRotation), sin = std::sin(l.anisotropyRotation);
  s.t = {cos, sin, 0};
  s.b = {-sin, cos, 0};
}

void readFilm(SurfaceInfo& s, const PhysicalLayers& l) {
  const double thickness = l.iridescenceThicknessMaximum;
  s.iridescence = thickness == 0 ? 0 : brdf_d::saturate(l.iridescenceFactor);
  if (s.iridescence == 0) return;
  const glm::dvec3 dielectric = brdf_d::F_Iridescence(l.iridescenceIor, thickness, s.NoV, s.f0Dielectric);
  const glm::dvec3 metal = brdf_d::F_Iridescence(l.iridescenceIor, thickness, s.NoV, s.baseColor);
  s.filmFresnel = glm::mix(dielectric, metal, s.metallic);
  s.filmF0Dielectric = brdf_d::f0FromSchlick(dielectric, s.NoV);
  s.filmF0Metal = brdf_d::f0FromSchlick(metal, s.NoV);
}

void readLayers(SurfaceInfo& s, const PhysicalLayers& l, bool principled) {
  s.diffuseRoughness = brdf_d::saturate(l.diffuseRoughnessFactor);
  readAnisotropy(s, l);
  readFilm(s, l);
  s.sheenColor = l.sheen ? glm::dvec3(l.sheenColorFactor) : glm::dvec3(0);
  s.sheenRoughness = std::max(std::min<double>(l.sheenRoughnessFactor, 1), double{brdf_d::SHEEN_ROUGHNESS_MIN});
  s.coatNormal = s.n;
  s.clearcoat = brdf_d::saturate(l.clearcoatFactor);
  s.clearcoatRoughness = roughnessOf(l.clearcoatRoughnessFactor, principled);
  s.clearcoatNoV = s.NoV;
  s.coatDfg = dfg(s.clearcoatRoughness, s.NoV);
}

/// The layers of TELAR_materials_fabric. The weft lies along the tangent, the warp across it.
void readCloth(SurfaceInfo& s, const FabricLayers& f, bool woven) {
  s.geometricNormal = s.n;
  s.slopeVariance = 0;
  s.flatness = f.flatness;
  s.diffuseTransmission = brdf_d::saturate(f.diffuseTransmissionFactor);
  s.transmittedColor = glm::dvec3(f.diffuseTransmissionColorFactor);
  if (!woven || !f.weave) return;
  const auto yarn = [&](const Yarn& y, const glm::dvec3& axis, const glm::dvec3& aside) {
    return brdf_d::fabric::yarnLobe(s.n, axis, aside, glm::dvec2(1, 0), 0, y.coverage, roughnessOf(y.roughness, false),
                                    y.anisotropy, glm::dvec3(y.specularColor));
  };
  s.t = {1, 0, 0};
  s.b = {0, 1, 0};
  s.warp = yarn(f.warp, s.b, -s.t);
  s.weft = yarn(f.weft, s.t, s.b);
}

}  // namespace

brdf_d::SurfaceInfo surfaceOf(const Material& material, const Shot& shot, const glm::dvec3& v) {
  const bool principled = isPrincipled(shot.shading);
  SurfaceInfo s{};
  s.n = {0, 0, 1};
  s.v = v;
  s.NoV = brdf_d::saturate(v.z);
  if (principled) s.terms = shot.terms;
  readBase(s, material, principled);
  readLayers(s, material.layers, principled);
  readCloth(s, material.fabric, shot.shading == ShadingModel::kFabric);
  s.transmittedColor = glm::dvec3(material.fabric.diffuseTransmissionColorFactor);
  return s;
}

}  // namespace telar::lobes
