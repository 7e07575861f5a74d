#include "reference/lobe_sampler.h"

#include <cmath>
#include <initializer_list>

#include "reference/sampling.h"

namespace telar::reference {

namespace {

constexpr float EVEN_SHARE = 0.2f;  ///< of the draws for diffuse and sheen
constexpr float PDF_HEMISPHERE = 2 * PDF_SPHERE;

/// The viewer in a lobe's frame. Interpolated and mapped normals turn away from viewers who see the surface: the
/// shading has them along it, and so has the sampler.
glm::vec3 viewerIn(const glm::mat3& frame, const glm::vec3& v) {
  constexpr float LEAST = 1e-3f;
  const glm::vec3 local = glm::transpose(frame) * v;
  return local.z >= LEAST ? local : glm::normalize(glm::vec3(local.x, local.y, 0) + glm::vec3(0, 0, LEAST));
}

}  // namespace

LobeSampler::LobeSampler(const brdf_f::SurfaceInfo& s) : cosineFrame_(basisAbout(s.n)) {
  base_.frame = glm::mat3(s.t, s.b, s.n);
  // A frame that leans (its axes come from texture coordinates) is set upright: any square frame samples correctly.
  const glm::vec3 t = s.t - s.n * glm::dot(s.n, s.t);
  base_.frame =
      glm::dot(t, t) > 1e-12f ? glm::mat3(glm::normalize(t), glm::cross(s.n, glm::normalize(t)), s.n) : cosineFrame_;
  base_.alpha = {glm::max(s.alphaT, s.alpha), s.alpha};
  base_.v = viewerIn(base_.frame, s.v);
  coat_.frame = basisAbout(s.coatNormal);
  coat_.alpha = glm::vec2(brdf_f::alphaFromRoughness(s.clearcoatRoughness));
  coat_.v = viewerIn(coat_.frame, s.v);

  // In proportion to what each lobe reflects about this view; a floor keeps every lobe alive.
  const float diffuse = brdf_f::max3(s.diffuse) + brdf_f::max3(s.sheenColor);
  const float specular = glm::max(brdf_f::max3(brdf_f::F_Schlick(s.f0, s.f90, s.NoV)), 0.1f);
  const float coat = s.clearcoat * brdf_f::F_Schlick(glm::vec3(brdf_f::F0_DIELECTRIC), 1, s.clearcoatNoV).x;
  const float through = s.diffuseTransmission > 0 ? glm::max(brdf_f::max3(s.diffuse) * s.diffuseTransmission, 0.1f) : 0;
  const float whole = glm::max(diffuse, 0.1f) + through + specular + coat;
  base_.share = specular / whole;
  coat_.share = coat / whole;
  throughShare_ = through / whole;
  const float wide = 1.0f - base_.share - coat_.share - throughShare_;
  evenShare_ = wide * EVEN_SHARE;
  cosineShare_ = wide - evenShare_;
}

LobeSampler::Sample LobeSampler::sample(Random& random) const {
  const float choice = random.uniform();
  const glm::vec2 u = random.uniform2();
  glm::vec3 l;
  const float even = cosineShare_ + evenShare_, through = even + throughShare_, base = through + base_.share;
  if (choice < cosineShare_) {
    l = cosineFrame_ * sampleCosine(u);
  } else if (choice < even) {
    const glm::vec3 any = sampleSphere(u);
    l = cosineFrame_ * glm::vec3(any.x, any.y, std::abs(any.z));
  } else if (choice < through) {
    l = cosineFrame_ * -sampleCosine(u);
  } else {
    const Gloss& gloss = choice < base || coat_.share == 0 ? base_ : coat_;
    const glm::vec3 h = sampleVisibleNormal(gloss.v, gloss.alpha, u);
    l = gloss.frame * (2.0f * glm::dot(gloss.v, h) * h - gloss.v);
  }
  return {l, pdf(l)};
}

float LobeSampler::pdf(const glm::vec3& l) const {
  const float cosine = glm::dot(cosineFrame_[2], l);
  float sum = cosineShare_ * pdfCosine(cosine) + throughShare_ * pdfCosine(-cosine);
  if (cosine >= 0) sum += evenShare_ * PDF_HEMISPHERE;
  for (const Gloss* gloss : {&base_, &coat_}) {
    if (gloss->share > 0) sum += gloss->share * pdfReflection(gloss->v, glm::transpose(gloss->frame) * l, gloss->alpha);
  }
  return sum;
}

}  // namespace telar::reference
