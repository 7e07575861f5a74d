#include "reference/lobe_sampler.h"

#include <initializer_list>

#include "reference/sampling.h"

namespace telar::reference {

LobeSampler::LobeSampler(const brdf_f::SurfaceInfo& s) : cosineFrame_(basisAbout(s.n)) {
  base_.frame = glm::mat3(s.t, s.b, s.n);
  // A frame that leans (its axes come from texture coordinates) is set upright: any square frame samples correctly.
  const glm::vec3 t = s.t - s.n * glm::dot(s.n, s.t);
  base_.frame =
      glm::dot(t, t) > 1e-12f ? glm::mat3(glm::normalize(t), glm::cross(s.n, glm::normalize(t)), s.n) : cosineFrame_;
  base_.alpha = {glm::max(s.alphaT, s.alpha), s.alpha};
  base_.v = glm::transpose(base_.frame) * s.v;
  coat_.frame = basisAbout(s.coatNormal);
  coat_.alpha = glm::vec2(brdf_f::alphaFromRoughness(s.clearcoatRoughness));
  coat_.v = glm::transpose(coat_.frame) * s.v;

  // In proportion to what each lobe reflects about this view; a floor keeps every lobe alive.
  const float diffuse = brdf_f::max3(s.diffuse) + brdf_f::max3(s.sheenColor);
  const float specular = base_.v.z > 0 ? brdf_f::max3(brdf_f::F_Schlick(s.f0, s.f90, s.NoV)) : 0.0f;
  const float coat =
      coat_.v.z > 0 ? s.clearcoat * brdf_f::F_Schlick(glm::vec3(brdf_f::F0_DIELECTRIC), 1, s.clearcoatNoV).x : 0.0f;
  const float through = s.diffuseTransmission > 0 ? glm::max(brdf_f::max3(s.diffuse) * s.diffuseTransmission, 0.1f) : 0;
  const float whole = glm::max(diffuse, 0.1f) + through + (specular > 0 ? glm::max(specular, 0.1f) : 0.0f) + coat;
  base_.share = specular > 0 ? glm::max(specular, 0.1f) / whole : 0.0f;
  coat_.share = coat / whole;
  throughShare_ = through / whole;
  cosineShare_ = 1.0f - base_.share - coat_.share - throughShare_;
}

LobeSampler::Sample LobeSampler::sample(Random& random) const {
  const float choice = random.uniform();
  const glm::vec2 u = random.uniform2();
  glm::vec3 l;
  if (choice < cosineShare_) {
    l = cosineFrame_ * sampleCosine(u);
  } else if (choice < cosineShare_ + throughShare_) {
    l = cosineFrame_ * -sampleCosine(u);
  } else {
    const Gloss& gloss = choice < cosineShare_ + throughShare_ + base_.share || coat_.share == 0 ? base_ : coat_;
    const glm::vec3 h = sampleVisibleNormal(gloss.v, gloss.alpha, u);
    l = gloss.frame * (2.0f * glm::dot(gloss.v, h) * h - gloss.v);
  }
  return {l, pdf(l)};
}

float LobeSampler::pdf(const glm::vec3& l) const {
  const float cosine = glm::dot(cosineFrame_[2], l);
  float sum = cosineShare_ * pdfCosine(cosine) + throughShare_ * pdfCosine(-cosine);
  for (const Gloss* gloss : {&base_, &coat_}) {
    if (gloss->share > 0) sum += gloss->share * pdfReflection(gloss->v, glm::transpose(gloss->frame) * l, gloss->alpha);
  }
  return sum;
}

}  // namespace telar::reference
