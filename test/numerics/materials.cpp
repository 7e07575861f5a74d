#include "materials.h"

#include <numbers>
#include <sstream>

namespace telar::numerics {
namespace {

float unitEdged(Seeded& r) { return static_cast<float>(r.edged(0, 1, {0, 1e-6, 0.02, 0.04, 0.5, 1})); }
float roughness(Seeded& r) { return static_cast<float>(r.edged(0, 1, {0, 0.01, 0.045, 0.089, 0.2, 0.5, 0.8, 1})); }

glm::vec3 color(Seeded& r, double high = 1) {
  if (r.chance(1.0 / 8)) return glm::vec3(static_cast<float>(r.chance(0.5) ? 0 : high));
  const auto channel = [&] { return static_cast<float>(r.edged(0, 1, {0, 1e-6, 1}) * high); };
  const float red = channel(), green = channel();
  return {red, green, channel()};
}

void addFilm(Seeded& r, PhysicalLayers& l) {
  l.iridescenceFactor = std::max(unitEdged(r), 1e-6f);
  l.iridescenceIor = static_cast<float>(r.edged(1, 2.5, {1, 1.3, 1000}));
  l.iridescenceThicknessMinimum = static_cast<float>(r.edged(0, 1200, {0, 1e-3, 1e6}));
  l.iridescenceThicknessMaximum = static_cast<float>(r.edged(0, 1200, {0, 1e-3, 1e6}));
}

void addTransmission(Seeded& r, const Layers& layers, PhysicalLayers& l) {
  l.transmissionFactor = std::max(unitEdged(r), 1e-6f);
  if (layers.volume) {
    l.thicknessFactor = static_cast<float>(r.edged(1e-6, 1, {1e-6, 1e12}));
    l.attenuationColor = glm::min(color(r), glm::vec3(1, 1, 0.999f));
    l.attenuationDistance = static_cast<float>(r.edged(1e-3, 10, {1e-12, 1e12}));
  }
  if (layers.dispersion) l.dispersion = static_cast<float>(r.edged(1e-6, 5, {1e-6, 40}));
}

Yarn yarn(Seeded& r, float coverage) { return {coverage, roughness(r), unitEdged(r), color(r)}; }

void addFabric(Seeded& r, const Layers& layers, FabricLayers& f) {
  if (layers.thin) {
    f.diffuseTransmissionFactor = std::max(unitEdged(r), 1e-6f);
    f.diffuseTransmissionColorFactor = color(r);
  }
  if (layers.flat) f.flatness = std::max(unitEdged(r), 1e-6f);
  if (layers.weave) {
    const float warp = unitEdged(r);
    f.warp = yarn(r, warp);
    f.weft = yarn(r, (1 - warp) * unitEdged(r));
    f.weave = f.warp.coverage + f.weft.coverage > 0;
    f.threadsPerUv = glm::vec2(static_cast<float>(r.edged(0, 400, {0, 1e-3, 1e6})),
                               static_cast<float>(r.edged(0, 400, {0, 1e-3, 1e6})));
  }
  if (layers.back) {
    f.back = true;
    f.backColorFactor = color(r);
    f.backRoughnessFactor = roughness(r);
  }
}

}  // namespace

Layers Layers::random(Seeded& r) {
  const auto one = [&] { return r.chance(0.4); };
  Layers l;
  for (bool Layers::*layer :
       {&Layers::specular, &Layers::clearcoat, &Layers::sheen, &Layers::anisotropy, &Layers::iridescence,
        &Layers::diffuseRoughness, &Layers::weave, &Layers::thin, &Layers::flat, &Layers::back})
    l.*layer = one();
  l.transmission = r.chance(0.1);
  l.volume = l.transmission && one();
  l.dispersion = l.transmission && one();
  return l;
}

Material randomMaterial(Seeded& r, const Layers& layers) {
  Material m;
  m.baseColorFactor = {color(r), 1};
  m.metallicFactor = r.chance(0.4) ? static_cast<float>(r.chance(0.5)) : unitEdged(r);
  m.roughnessFactor = roughness(r);
  m.physical = true;
  PhysicalLayers& l = m.layers;
  if (layers.specular) {
    // As the loader has them: 0 has become 1000.
    l.ior = static_cast<float>(r.edged(1, 2.5, {1, 1.5, 5.83, 1000}));
    l.specularFactor = unitEdged(r);
    l.specularColorFactor = color(r, r.chance(1.0 / 16) ? 65504 : 1);
  }
  if (layers.clearcoat) {
    l.clearcoatFactor = std::max(unitEdged(r), 1e-6f);
    l.clearcoatRoughnessFactor = roughness(r);
  }
  if (layers.sheen) {
    l.sheenColorFactor = glm::max(color(r), glm::vec3(1e-6f));
    l.sheenRoughnessFactor = static_cast<float>(r.edged(0, 1, {0, 0.04, 0.07, 0.1, 0.3, 0.5, 1}));
  }
  if (layers.anisotropy) {
    l.anisotropyStrength = std::max(unitEdged(r), 1e-6f);
    l.anisotropyRotation =
        static_cast<float>(r.edged(-std::numbers::pi, std::numbers::pi, {0, std::numbers::pi / 2, std::numbers::pi}));
  }
  if (layers.iridescence) addFilm(r, l);
  if (layers.diffuseRoughness) l.diffuseRoughnessFactor = std::max(unitEdged(r), 1e-6f);
  if (layers.transmission) addTransmission(r, layers, l);
  addFabric(r, layers, m.fabric);
  return m;
}

Material whiteCloth(Seeded& r) {
  Layers layers = Layers::random(r);
  layers.specular = layers.iridescence = layers.transmission = false;  // they take away what is not white
  Material m = randomMaterial(r, layers);
  m.baseColorFactor = glm::vec4(1);
  if (layers.sheen) m.layers.sheenColorFactor = glm::vec3(static_cast<float>(r.edged(0.01, 1, {1})));
  FabricLayers& f = m.fabric;
  f.diffuseTransmissionFactor = 0;  // what goes through does not come back
  f.diffuseTransmissionColorFactor = f.warp.specularColorFactor = f.weft.specularColorFactor = f.backColorFactor =
      glm::vec3(1);
  return m;
}

std::string describe(const Material& m) {
  std::ostringstream out;
  out.precision(9);
  const auto vec = [&](const char* name, const glm::vec3& v) {
    out << " " << name << " (" << v.x << " " << v.y << " " << v.z << ")";
  };
  vec("base", glm::vec3(m.baseColorFactor));
  out << " metallic " << m.metallicFactor << " roughness " << m.roughnessFactor;
  const PhysicalLayers& l = m.layers;
  if (l.ior != 1.5f || l.specularFactor != 1) out << " ior " << l.ior << " specular " << l.specularFactor;
  if (l.specularColorFactor != glm::vec3(1)) vec("specularColor", l.specularColorFactor);
  if (l.clearcoatFactor > 0) out << " coat " << l.clearcoatFactor << " rough " << l.clearcoatRoughnessFactor;
  if (l.sheenColorFactor != glm::vec3(0)) vec("sheen", l.sheenColorFactor), out << " rough " << l.sheenRoughnessFactor;
  if (l.anisotropyStrength > 0) out << " anisotropy " << l.anisotropyStrength << " turned " << l.anisotropyRotation;
  if (l.iridescenceFactor > 0)
    out << " film " << l.iridescenceFactor << " ior " << l.iridescenceIor << " nm " << l.iridescenceThicknessMaximum;
  if (l.diffuseRoughnessFactor > 0) out << " diffuseRoughness " << l.diffuseRoughnessFactor;
  if (l.transmissionFactor > 0) out << " transmission " << l.transmissionFactor << " thickness " << l.thicknessFactor;
  const FabricLayers& f = m.fabric;
  if (f.weave) {
    out << " warp " << f.warp.coverage << " rough " << f.warp.roughnessFactor << " stretched "
        << f.warp.anisotropyStrength << " weft " << f.weft.coverage << " rough " << f.weft.roughnessFactor
        << " stretched " << f.weft.anisotropyStrength << " threads " << f.threadsPerUv.x << " " << f.threadsPerUv.y;
  }
  if (f.diffuseTransmissionFactor > 0) out << " through " << f.diffuseTransmissionFactor;
  if (f.flatness > 0) out << " flatness " << f.flatness;
  return out.str().substr(1);
}

}  // namespace telar::numerics
