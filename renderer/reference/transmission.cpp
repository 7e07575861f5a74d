#include "reference/transmission.h"

namespace telar::reference {
namespace {

/// A direction of the rough lobe about `direction`. Its width is 0 at an index of refraction of 1 and that of the
/// reflection from 1.5 on, as in the raster.
glm::vec3 sampleRough(const glm::vec3& direction, const brdf_f::SurfaceInfo& s, float ior, Random& random) {
  const float roughness = s.perceptualRoughness * glm::clamp(ior * 2 - 2, 0.0f, 1.0f);
  const float alpha = roughness * roughness;
  if (alpha < 1e-4f) return direction;
  const glm::mat3 frame = brdf_f::basisAbout(s.n);
  const glm::vec3 v = glm::transpose(frame) * -direction;
  if (v.z <= 0) return direction;
  // A rough thin sheet: the reflection, mirrored to the other side.
  const glm::vec3 l = brdf_f::sampleReflection(v, glm::vec2(alpha), random.uniform2());
  return l.z > 0 ? frame * glm::vec3(l.x, l.y, -l.z) : direction;
}

}  // namespace

TransmissionSample sampleTransmission(const Surface& surface, Random& random) {
  const brdf_f::SurfaceInfo& s = surface.info;
  const Glass& glass = surface.glass;
  float ior = glass.ior;
  glm::vec3 channel(1);
  if (glass.dispersion > 0) {
    // Each channel refracts by its own index: one of the three is drawn, and stands for all.
    const int c = glm::min(static_cast<int>(random.uniform() * 3), 2);
    ior = brdf_f::dispersedIor(glass.ior, glass.dispersion)[c];
    channel = glm::vec3(0);
    channel[c] = 3;
  }
  TransmissionSample sample;
  if (glass.thickness != glm::vec3(0)) sample.path = brdf_f::refractedDirection(s.n, s.v, ior) * glass.thickness;
  sample.direction = sampleRough(-s.v, s, ior, random);
  const glm::vec3 interface = 1.0f - (s.f0 * s.dfg.x + s.f90 * s.dfg.y);
  sample.share = s.diffuse * interface * channel;
  if (glass.attenuates) {
    sample.share *=
        brdf_f::volumeTransmittance(glm::length(sample.path), glass.attenuationColor, glass.attenuationDistance);
  }
  return sample;
}

}  // namespace telar::reference
