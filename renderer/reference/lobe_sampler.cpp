#include "reference/lobe_sampler.h"

#include <cmath>
#include <initializer_list>

#include "reference/sampling.h"

namespace telar::reference {

namespace {

constexpr float EVEN_SHARE = 0.2f;  ///< of the draws for diffuse and sheen

/// The viewer in a lobe's frame. Interpolated and mapped normals turn away from viewers who see the surface: the
/// shading has them along it, and so has the sampler.
glm::vec3 viewerIn(const glm::mat3& frame, const glm::vec3& v) {
  constexpr float LEAST = 1e-3f;
  const glm::vec3 local = glm::transpose(frame) * v;
  return local.z >= LEAST ? local : glm::normalize(glm::vec3(local.x, local.y, 0) + glm::vec3(0, 0, LEAST));
}

}  // namespace

LobeSampler::Gloss LobeSampler::yarnOf(const brdf_f::YarnLobe& yarn, const glm::vec3& v) {
  Gloss gloss;
  if (yarn.coverage <= 0) return gloss;
  gloss.frame = glm::mat3(yarn.t, yarn.b, yarn.n);
  gloss.alpha = {yarn.alphaT, yarn.alphaB};
  gloss.v = viewerIn(gloss.frame, v);
  gloss.share = yarn.coverage;
  return gloss;
}

LobeSampler::LobeSampler(const brdf_f::SurfaceInfo& s) : cosineFrame_(brdf_f::basisAbout(s.n)) {
  auto& [base, coat, warp, weft] = gloss_;
  // A frame that leans (its axes come from texture coordinates) is set upright: any square frame samples correctly.
  const glm::vec3 t = s.t - s.n * glm::dot(s.n, s.t);
  base.frame =
      glm::dot(t, t) > 1e-12f ? glm::mat3(glm::normalize(t), glm::cross(s.n, glm::normalize(t)), s.n) : cosineFrame_;
  base.alpha = {glm::max(s.alphaT, s.alpha), s.alpha};
  base.v = viewerIn(base.frame, s.v);
  coat.frame = brdf_f::basisAbout(s.coatNormal);
  coat.alpha = glm::vec2(brdf_f::alphaFromRoughness(s.clearcoatRoughness));
  coat.v = viewerIn(coat.frame, s.v);
  warp = yarnOf(s.warp, s.v);
  weft = yarnOf(s.weft, s.v);

  // In proportion to what each lobe reflects about this view; a floor keeps every lobe alive.
  const float diffuse = glm::max(brdf_f::max3(s.diffuse) + brdf_f::max3(s.sheenColor), 0.1f);
  const float specular = glm::max(brdf_f::max3(brdf_f::F_Schlick(s.f0, s.f90, s.NoV)), 0.1f);
  const float through = s.diffuseTransmission > 0 ? glm::max(brdf_f::max3(s.diffuse) * s.diffuseTransmission, 0.1f) : 0;
  coat.share = s.clearcoat * brdf_f::F_Schlick(glm::vec3(brdf_f::F0_DIELECTRIC), 1, s.clearcoatNoV).x;
  const float yarns = warp.share + weft.share;
  base.share = yarns > 0 ? 0 : specular;
  for (Gloss* yarn : {&warp, &weft}) yarn->share *= yarns > 0 ? specular / yarns : 0;
  float whole = diffuse + through;
  for (const Gloss& gloss : gloss_) whole += gloss.share;
  for (Gloss& gloss : gloss_) gloss.share /= whole;
  throughShare_ = through / whole;
  evenShare_ = diffuse / whole * EVEN_SHARE;
  cosineShare_ = diffuse / whole - evenShare_;
}

glm::vec3 LobeSampler::draw(float choice, const glm::vec2& u) const {
  if ((choice -= cosineShare_) < 0) return cosineFrame_ * brdf_f::sampleCosine(u);
  if ((choice -= evenShare_) < 0) return cosineFrame_ * brdf_f::sampleHemisphere(u);
  if ((choice -= throughShare_) < 0) return cosineFrame_ * -brdf_f::sampleCosine(u);
  for (const Gloss& gloss : gloss_) {
    if ((choice -= gloss.share) >= 0) continue;
    const glm::vec3 h = brdf_f::sampleVisibleNormal(gloss.v, gloss.alpha, u);
    const glm::vec3 l = gloss.frame * (2.0f * glm::dot(gloss.v, h) * h - gloss.v);
    return isYarn(gloss) && glm::dot(cosineFrame_[2], l) < 0 ? mirrored(l) : l;
  }
  return cosineFrame_ * brdf_f::sampleCosine(u);  // the shares fall short of 1 by rounding
}

LobeSampler::Sample LobeSampler::sample(Random& random) const {
  const float choice = random.uniform();
  const glm::vec3 l = draw(choice, random.uniform2());
  return {l, pdf(l)};
}

float LobeSampler::pdf(const glm::vec3& l) const {
  const float cosine = glm::dot(cosineFrame_[2], l);
  float sum = cosineShare_ * brdf_f::pdfCosine(cosine) + throughShare_ * brdf_f::pdfCosine(-cosine);
  sum += evenShare_ * brdf_f::pdfHemisphere(cosine);
  for (const Gloss& gloss : gloss_) {
    if (gloss.share <= 0) continue;
    const auto density = [&](const glm::vec3& d) {
      return brdf_f::pdfReflection(gloss.v, glm::transpose(gloss.frame) * d, gloss.alpha);
    };
    if (!isYarn(gloss)) {
      sum += gloss.share * density(l);
    } else if (cosine >= 0) {
      sum += gloss.share * (density(l) + density(mirrored(l)));
    }
  }
  return sum;
}

bool LobeSampler::isYarn(const Gloss& gloss) const { return &gloss >= &gloss_[2]; }

glm::vec3 LobeSampler::mirrored(const glm::vec3& l) const {
  return l - 2 * glm::dot(cosineFrame_[2], l) * cosineFrame_[2];
}

}  // namespace telar::reference
