#include "reference/lobe_sampler.h"

#include <cmath>
#include <initializer_list>

namespace telar::reference {

namespace {

constexpr float UNIFORM_SHARE = 0.2f;  ///< of the samples for diffuse and sheen, for sheen at grazing angles

/// The viewer in a lobe's frame. An interpolated or mapped normal may face away from a viewer who sees the surface.
/// Shading and sampling then take the viewer as grazing.
glm::vec3 viewerIn(const glm::mat3& frame, const glm::vec3& v) {
  constexpr float MIN_COSINE = 1e-3f;
  const glm::vec3 local = glm::transpose(frame) * v;
  return local.z >= MIN_COSINE ? local : glm::normalize(glm::vec3(local.x, local.y, 0) + glm::vec3(0, 0, MIN_COSINE));
}

}  // namespace

LobeSampler::MicrofacetLobe LobeSampler::yarnLobe(const brdf_f::YarnLobe& yarn, const glm::vec3& v) {
  MicrofacetLobe lobe;
  if (yarn.coverage <= 0) return lobe;
  lobe.frame = glm::mat3(yarn.t, yarn.b, yarn.n);
  lobe.alpha = {yarn.alphaT, yarn.alphaB};
  lobe.v = viewerIn(lobe.frame, v);
  lobe.share = yarn.coverage;
  return lobe;
}

LobeSampler::LobeSampler(const brdf_f::SurfaceInfo& s) : cosineFrame_(brdf_f::basisAbout(s.n)) {
  auto& [base, coat, warp, weft] = specular_;
  // The frame of texture coordinates need not be orthonormal. Any orthonormal frame samples correctly.
  const glm::vec3 t = s.t - s.n * glm::dot(s.n, s.t);
  base.frame =
      glm::dot(t, t) > 1e-12f ? glm::mat3(glm::normalize(t), glm::cross(s.n, glm::normalize(t)), s.n) : cosineFrame_;
  base.alpha = {glm::max(s.alphaT, s.alpha), s.alpha};
  base.v = viewerIn(base.frame, s.v);
  coat.frame = brdf_f::basisAbout(s.coatNormal);
  coat.alpha = glm::vec2(brdf_f::alphaFromRoughness(s.clearcoatRoughness));
  coat.v = viewerIn(coat.frame, s.v);
  warp = yarnLobe(s.warp, s.v);
  weft = yarnLobe(s.weft, s.v);

  // About in proportion to the albedo of each lobe at this view. A floor keeps every lobe sampled.
  const float diffuse = glm::max(brdf_f::max3(s.diffuse) + brdf_f::max3(s.sheenColor), 0.1f);
  const float specular = glm::max(brdf_f::max3(brdf_f::F_Schlick(s.f0, s.f90, s.NoV)), 0.1f);
  const float transmission =
      s.diffuseTransmission > 0 ? glm::max(brdf_f::max3(s.diffuse) * s.diffuseTransmission, 0.1f) : 0;
  coat.share = s.clearcoat * brdf_f::F_Schlick(glm::vec3(brdf_f::F0_DIELECTRIC), 1, s.clearcoatNoV).x;
  const float yarns = warp.share + weft.share;
  base.share = yarns > 0 ? 0 : specular;
  for (MicrofacetLobe* yarn : {&warp, &weft}) yarn->share *= yarns > 0 ? specular / yarns : 0;
  float whole = diffuse + transmission;
  for (const MicrofacetLobe& lobe : specular_) whole += lobe.share;
  for (MicrofacetLobe& lobe : specular_) lobe.share /= whole;
  transmissionShare_ = transmission / whole;
  uniformShare_ = diffuse / whole * UNIFORM_SHARE;
  cosineShare_ = diffuse / whole - uniformShare_;
}

glm::vec3 LobeSampler::sampleDirection(float choice, const glm::vec2& u) const {
  if ((choice -= cosineShare_) < 0) return cosineFrame_ * brdf_f::sampleCosine(u);
  if ((choice -= uniformShare_) < 0) return cosineFrame_ * brdf_f::sampleHemisphere(u);
  if ((choice -= transmissionShare_) < 0) return cosineFrame_ * -brdf_f::sampleCosine(u);
  for (const MicrofacetLobe& lobe : specular_) {
    if ((choice -= lobe.share) >= 0) continue;
    const glm::vec3 l = lobe.frame * brdf_f::sampleReflection(lobe.v, lobe.alpha, u);
    return isYarn(lobe) && glm::dot(cosineFrame_[2], l) < 0 ? mirrored(l) : l;
  }
  return cosineFrame_ * brdf_f::sampleCosine(u);  // the shares fall short of 1 by rounding
}

LobeSampler::Sample LobeSampler::sample(Random& random) const {
  const float choice = random.uniform();
  const glm::vec3 l = sampleDirection(choice, random.uniform2());
  return {l, pdf(l)};
}

float LobeSampler::pdf(const glm::vec3& l) const {
  const float cosine = glm::dot(cosineFrame_[2], l);
  float sum = cosineShare_ * brdf_f::pdfCosine(cosine) + transmissionShare_ * brdf_f::pdfCosine(-cosine);
  sum += uniformShare_ * brdf_f::pdfHemisphere(cosine);
  for (const MicrofacetLobe& lobe : specular_) {
    if (lobe.share <= 0) continue;
    const auto density = [&](const glm::vec3& d) {
      return brdf_f::pdfReflection(lobe.v, glm::transpose(lobe.frame) * d, lobe.alpha);
    };
    if (!isYarn(lobe)) {
      sum += lobe.share * density(l);
    } else if (cosine >= 0) {
      sum += lobe.share * (density(l) + density(mirrored(l)));
    }
  }
  return sum;
}

bool LobeSampler::isYarn(const MicrofacetLobe& lobe) const { return &lobe >= &specular_[2]; }

glm::vec3 LobeSampler::mirrored(const glm::vec3& l) const {
  return l - 2 * glm::dot(cosineFrame_[2], l) * cosineFrame_[2];
}

}  // namespace telar::reference
