#include "albedo.h"

#include "mixture.h"

namespace telar::numerics {

double directAlbedo(const Shaded<double>& shaded, int points) {
  const brdf_d::SurfaceInfo& s = shaded.info();
  std::vector<Lobe> lobes;
  for (const brdf_d::YarnLobe* yarn : {&s.warp, &s.weft}) {
    if (yarn->coverage > 0) lobes.push_back({glm::dmat3(yarn->t, yarn->b, yarn->n), {yarn->alphaT, yarn->alphaB}});
  }
  if (lobes.empty()) lobes.push_back({glm::dmat3(s.t, s.b, s.n), {std::max(s.alphaT, s.alpha), s.alpha}});
  if (s.clearcoat > 0) lobes.push_back({glm::dmat3(1.0), glm::dvec2(s.clearcoatRoughness * s.clearcoatRoughness)});
  std::optional<Fuzz> fuzz;
  if (s.sheenColor != glm::dvec3(0)) {
    const glm::dvec3 ltc = brdf_d::sheenLtc(std::max(s.sheenRoughness, brdf_d::CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
    const glm::dvec3 along(s.v.x, s.v.y, 0);
    fuzz = Fuzz{glm::length(along) > 1e-9 ? glm::normalize(along) : glm::dvec3(1, 0, 0), ltc.y, ltc.z};
  }
  return Mixture(s.v, lobes, points, fuzz).integrate([&](const glm::dvec3& l) { return shaded.direct(l).y; });
}

}  // namespace telar::numerics
