#include "lobes/lobe_mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telar::lobes {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double PI = std::numbers::pi;

/// The viewer in a lobe's frame, at least a little above its horizon.
dvec3 viewerIn(const glm::dmat3& frame, const dvec3& v) {
  const dvec3 local = glm::transpose(frame) * v;
  return glm::normalize(dvec3(local.x, local.y, std::max(local.z, 1e-6)));
}

/// Dense towards the horizon, where sheen and the Fresnel term are steep.
dvec3 sampleGrazing(const dvec2& u) {
  const double z = u.x * u.x, sine = std::sqrt(1 - z * z), phi = 2 * PI * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

double pdfGrazing(double z) { return 1 / (4 * PI * std::sqrt(z)); }

/// A microfacet normal of GTR1.
/// src: Burley 2012, "Physically-Based Shading at Disney", appendix B
dvec3 sampleGtr1(double alpha, const dvec2& u) {
  const double a2 = alpha * alpha, cosine2 = (1 - std::pow(a2, 1 - u.x)) / (1 - a2);
  const double sine = std::sqrt(std::max(1 - cosine2, 0.0)), phi = 2 * PI * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cosine2)};
}

double pdfGtr1(double alpha, const dvec3& v, const dvec3& l) {
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
      addMicrofacets(s, glm::dmat3(yarn->t, yarn->b, yarn->n), {yarn->alphaT, yarn->alphaB});
      microfacets_.back().mirrored = true;
    }
  } else if (s.f90 > 0 || brdf_d::max3(s.f0) > 0) {
    addMicrofacets(s, glm::dmat3(s.t, s.b, s.n), {std::max(s.alphaT, s.alpha), s.alpha});
  }
  if (s.clearcoat > 0) {
    const double alpha = std::max(brdf_d::alphaFromRoughness(s.clearcoatRoughness), 0.001);
    addMicrofacets(s, brdf_d::basisAbout(s.coatNormal), dvec2(alpha));
    if (isPrincipled(shading)) {
      const MicrofacetLobe coat = microfacets_.back();
      microfacets_.push_back(coat);
      microfacets_.back().longTailed = true;
      microfacets_.back().alpha = dvec2(std::min(alpha, 0.5));
    }
  }
  if (cloth && brdf_d::max3(s.sheenColor) > 0) addSheen(s);
}

void LobeMixture::addMicrofacets(const brdf_d::SurfaceInfo& s, const glm::dmat3& frame, const dvec2& alpha) {
  microfacets_.push_back({frame, alpha, viewerIn(frame, s.v)});
}

void LobeMixture::addSheen(const brdf_d::SurfaceInfo& s) {
  const dvec3 across = s.v - s.n * glm::dot(s.n, s.v);
  const dvec3 x = glm::dot(across, across) > 1e-24 ? glm::normalize(across) : brdf_d::anyTangent(s.n);
  sheens_.push_back({glm::dmat3(x, glm::cross(s.n, x), s.n),
                     brdf_d::sheenLtc(std::max(s.sheenRoughness, brdf_d::CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV)});
}

dvec3 LobeMixture::sample(const MicrofacetLobe& lobe, const dvec2& u) {
  const dvec3 l = lobe.frame * (lobe.longTailed ? glm::reflect(-lobe.v, sampleGtr1(lobe.alpha.x, u))
                                                : brdf_d::sampleReflection(lobe.v, lobe.alpha, u));
  return lobe.mirrored && l.z < 0 ? mirrorOf(l) : l;
}

double LobeMixture::pdf(const MicrofacetLobe& lobe, const dvec3& l) {
  const auto at = [&](const dvec3& direction) {
    const dvec3 local = glm::transpose(lobe.frame) * direction;
    return lobe.longTailed ? pdfGtr1(lobe.alpha.x, lobe.v, local) : brdf_d::pdfReflection(lobe.v, local, lobe.alpha);
  };
  return at(l) + (lobe.mirrored ? at(mirrorOf(l)) : 0.0);
}

dvec3 LobeMixture::sample(std::size_t technique, const dvec2& u) const {
  if (technique == 0) return brdf_d::sampleCosine(u);
  if (technique == 1) return sampleGrazing(u);
  if ((technique -= WIDE_TECHNIQUES) < microfacets_.size()) return sample(microfacets_[technique], u);
  const SheenLobe& sheen = sheens_[technique - microfacets_.size()];
  return sheen.frame * brdf_d::sampleSheenLtc(sheen.ltc, u);
}

double LobeMixture::pdfSum(const dvec3& l) const {
  double sum = brdf_d::pdfCosine(l.z) + pdfGrazing(l.z);
  for (const MicrofacetLobe& lobe : microfacets_) sum += pdf(lobe, l);
  for (const SheenLobe& sheen : sheens_)
    sum += brdf_d::sheenLtcCosine({1, sheen.ltc.y, sheen.ltc.z}, glm::transpose(sheen.frame) * l);
  return sum;
}

}  // namespace telar::lobes
