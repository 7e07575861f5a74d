#include "reference/transmission.h"

namespace telar::reference {
namespace {

/// The width of the lobe: none at an index of refraction of 1, the reflection's from 1.5 on, as the raster blurs.
glm::vec3 blurred(const glm::vec3& direction, const brdf_f::SurfaceInfo& s, float ior, Random& random) {
  const float roughness = s.perceptualRoughness * glm::clamp(ior * 2 - 2, 0.0f, 1.0f);
  const float alpha = roughness * roughness;
  if (alpha < 1e-4f) return direction;
  const glm::mat3 frame = brdf_f::basisAbout(s.n);
  const glm::vec3 v = glm::transpose(frame) * -direction;
  if (v.z <= 0) return direction;
  // A rough sheet of two parallel sides: the reflection of a rough surface, mirrored to the other side.
  const glm::vec3 h = brdf_f::sampleVisibleNormal(v, glm::vec2(alpha), random.uniform2());
  const glm::vec3 l = 2 * glm::dot(v, h) * h - v;
  return l.z > 0 ? frame * glm::vec3(l.x, l.y, -l.z) : direction;
}

}  // namespace

Passage drawPassage(const Surface& surface, Random& random) {
  const brdf_f::SurfaceInfo& s = surface.info;
  const Glass& glass = surface.glass;
  float ior = glass.ior;
  glm::vec3 channel(1);
  if (glass.dispersion > 0) {
    // Each colour has a way of its own: one of the three is followed and stands for all.
    const int c = glm::min(static_cast<int>(random.uniform() * 3), 2);
    ior = brdf_f::dispersedIor(glass.ior, glass.dispersion)[c];
    channel = glm::vec3(0);
    channel[c] = 3;
  }
  Passage passage;
  if (glass.thickness != glm::vec3(0)) passage.path = brdf_f::refractedDirection(s.n, s.v, ior) * glass.thickness;
  passage.direction = blurred(-s.v, s, ior, random);
  const glm::vec3 interface = 1.0f - (s.f0 * s.dfg.x + s.f90 * s.dfg.y);
  passage.share = s.diffuse * interface * channel;
  if (glass.attenuates) {
    passage.share *=
        brdf_f::volumeTransmittance(glm::length(passage.path), glass.attenuationColor, glass.attenuationDistance);
  }
  return passage;
}

}  // namespace telar::reference
