#include "lobes/lobe_mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telar::lobes {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double PI = std::numbers::pi;

/// The viewer in a lobe's frame; edge on he still sees it.
dvec3 viewerIn(const glm::dmat3& frame, const dvec3& v) {
  const dvec3 local = glm::transpose(frame) * v;
  return glm::normalize(dvec3(local.x, local.y, std::max(local.z, 1e-6)));
}

/// Dense towards the horizon, where lobes of fibres and of grazing mirrors are steep.
dvec3 grazing(const dvec2& u) {
  const double z = u.x * u.x, sine = std::sqrt(1 - z * z), phi = 2 * PI * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

double grazingDensity(double z) { return 1 / (4 * PI * std::sqrt(z)); }

/// src: Burley 2012, "Physically-Based Shading at Disney", appendix B, the distribution GTR1 and how it is drawn from
dvec3 longTailedNormal(double alpha, const dvec2& u) {
  const double a2 = alpha * alpha, cosine2 = (1 - std::pow(a2, 1 - u.x)) / (1 - a2);
  const double sine = std::sqrt(std::max(1 - cosine2, 0.0)), phi = 2 * PI * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cosine2)};
}

double longTailedDensity(double alpha, const dvec3& v, const dvec3& l) {
  const dvec3 h = glm::normalize(v + l);
  const double VoH = glm::dot(v, h);
  return h.z > 0 && VoH > 0 ? brdf_d::D_GTR1(alpha, h.z) * h.z / (4 * VoH) : 0;
}

dvec3 mirrorOf(const dvec3& l) { return {l.x, l.y, -l.z}; }

}  // namespace

LobeMixture::LobeMixture(ShadingModel shading, const brdf_d::SurfaceInfo& s) {
  const bool cloth = shading == ShadingModel::kFabric;
  if (cloth && s.warp.coverage + s.weft.coverage > 0) {
    for (const brdf_d::YarnLobe* yarn : {&s.warp, &s.weft}) {
      if (yarn->coverage <= 0) continue;
      addGloss(s, glm::dmat3(yarn->t, yarn->b, yarn->n), {yarn->alphaT, yarn->alphaB});
      glosses_.back().mirrored = true;
    }
  } else if (s.f90 > 0 || brdf_d::max3(s.f0) > 0) {
    addGloss(s, glm::dmat3(s.t, s.b, s.n), {std::max(s.alphaT, s.alpha), s.alpha});
  }
  if (s.clearcoat > 0) {
    const double alpha = std::max(brdf_d::alphaFromRoughness(s.clearcoatRoughness), 0.001);
    addGloss(s, brdf_d::basisAbout(s.coatNormal), dvec2(alpha));
    if (isPrincipled(shading)) {
      const Gloss coat = glosses_.back();
      glosses_.push_back(coat);
      glosses_.back().longTailed = true;
      glosses_.back().alpha = dvec2(std::min(alpha, 0.5));
    }
  }
  if (cloth && brdf_d::max3(s.sheenColor) > 0) addSheen(s);
}

void LobeMixture::addGloss(const brdf_d::SurfaceInfo& s, const glm::dmat3& frame, const dvec2& alpha) {
  glosses_.push_back({frame, alpha, viewerIn(frame, s.v)});
}

void LobeMixture::addSheen(const brdf_d::SurfaceInfo& s) {
  const dvec3 across = s.v - s.n * glm::dot(s.n, s.v);
  const dvec3 x = glm::dot(across, across) > 1e-24 ? glm::normalize(across) : brdf_d::anyTangent(s.n);
  sheens_.push_back({glm::dmat3(x, glm::cross(s.n, x), s.n),
                     brdf_d::sheenLtc(std::max(s.sheenRoughness, brdf_d::CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV)});
}

dvec3 LobeMixture::drawn(const Gloss& gloss, const dvec2& u) {
  const dvec3 h =
      gloss.longTailed ? longTailedNormal(gloss.alpha.x, u) : brdf_d::sampleVisibleNormal(gloss.v, gloss.alpha, u);
  const dvec3 l = gloss.frame * (2 * glm::dot(gloss.v, h) * h - gloss.v);
  return gloss.mirrored && l.z < 0 ? mirrorOf(l) : l;
}

double LobeMixture::density(const Gloss& gloss, const dvec3& l) {
  const auto at = [&](const dvec3& direction) {
    const dvec3 local = glm::transpose(gloss.frame) * direction;
    return gloss.longTailed ? longTailedDensity(gloss.alpha.x, gloss.v, local)
                            : brdf_d::pdfReflection(gloss.v, local, gloss.alpha);
  };
  return at(l) + (gloss.mirrored ? at(mirrorOf(l)) : 0.0);
}

dvec3 LobeMixture::draw(std::size_t way, const dvec2& u) const {
  if (way == 0) return brdf_d::sampleCosine(u);
  if (way == 1) return grazing(u);
  if ((way -= WIDE_WAYS) < glosses_.size()) return drawn(glosses_[way], u);
  const Sheen& sheen = sheens_[way - glosses_.size()];
  return sheen.frame * brdf_d::sampleSheenLtc(sheen.ltc, u);
}

double LobeMixture::density(const dvec3& l) const {
  double sum = brdf_d::pdfCosine(l.z) + grazingDensity(l.z);
  for (const Gloss& gloss : glosses_) sum += density(gloss, l);
  for (const Sheen& sheen : sheens_)
    sum += brdf_d::sheenLtcCosine({1, sheen.ltc.y, sheen.ltc.z}, glm::transpose(sheen.frame) * l);
  return sum;
}

}  // namespace telar::lobes
