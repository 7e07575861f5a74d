#include "lobes/lobe_mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telar::lobes {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double PI = std::numbers::pi;

/// Dense towards the horizon, where sheen and the Fresnel term are steep.
dvec3 sampleGrazing(const dvec2& u) {
  const double z = u.x * u.x, sine = std::sqrt(1 - z * z), phi = 2 * PI * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

double pdfGrazing(double z) { return 1 / (4 * PI * std::sqrt(z)); }

/// Width of GTR1, which the distribution needs below 1.
double gtr1Alpha(const brdf_d::MicrofacetLobe& coat) { return std::min(coat.alpha.x, 0.5); }

/// Directions of a GTR1 lobe.
/// src: Burley 2012, "Physically-Based Shading at Disney", appendix B
dvec3 sampleGtr1(const brdf_d::MicrofacetLobe& coat, const dvec2& u) {
  const double a2 = std::pow(gtr1Alpha(coat), 2), cosine2 = (1 - std::pow(a2, 1 - u.x)) / (1 - a2);
  const double sine = std::sqrt(std::max(1 - cosine2, 0.0)), phi = 2 * PI * u.y;
  return coat.frame * glm::reflect(-coat.v, dvec3(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(cosine2)));
}

double pdfGtr1(const brdf_d::MicrofacetLobe& coat, const dvec3& l) {
  const dvec3 h = glm::normalize(coat.v + l * coat.frame);
  const double VoH = glm::dot(coat.v, h);
  return h.z > 0 && VoH > 0 ? brdf_d::D_GTR1(gtr1Alpha(coat), h.z) * h.z / (4 * VoH) : 0;
}

}  // namespace

LobeMixture::LobeMixture(ShadingModel shading, const brdf_d::SurfaceInfo& s)
    : lobes_(brdf_d::lobeMixture(s)), longTailed_(isPrincipled(shading) && s.clearcoat > 0) {
  lobes_.transmissionShare = 0;  // the albedo is that of the lit side
  if (s.f90 == 0 && brdf_d::max3(s.f0) == 0) lobes_.baseShare = lobes_.weftShare = 0;  // it would draw for nothing
  for (double* share :
       {&lobes_.cosineShare, &lobes_.baseShare, &lobes_.weftShare, &lobes_.coatShare, &lobes_.sheenShare}) {
    if (*share > 0) *share = 1, ++lobeCount_;
  }
}

dvec3 LobeMixture::sample(std::size_t technique, const dvec2& u) const {
  // A mixture of shares of 1 draws its first lobe from x in [0, 1), the next from [1, 2).
  if (technique < lobeCount_) return brdf_d::sampleMixture(lobes_, {static_cast<double>(technique) + u.x, u.y});
  return technique == lobeCount_ ? sampleGrazing(u) : sampleGtr1(lobes_.coat, u);
}

double LobeMixture::pdfSum(const dvec3& l) const {
  return brdf_d::pdfMixture(lobes_, l) + pdfGrazing(l.z) + (longTailed_ ? pdfGtr1(lobes_.coat, l) : 0.0);
}

}  // namespace telar::lobes
