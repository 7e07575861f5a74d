#pragma once
#include "brdf/shading.h"
#include "telar/shading.h"

namespace telar::lobes {

/// Importance sampling of a BSDF by several techniques: each lobe of shaders/light/lobe_mixture.glsl, dense towards the
/// horizon, and of a principled shading its coat's long tail. Here an albedo is wanted to a bound, not in a few
/// samples: so each technique draws the same number of directions, whatever its share is there. Weighted by the
/// densities of all techniques, the integrand stays smooth however narrow a lobe is. src: Veach 1997, "Robust Monte
/// Carlo Methods for Light Transport Simulation", eq. 9.8, the balance heuristic
class LobeMixture {
 public:
  /// @param s  prepared, about z = normal
  LobeMixture(ShadingModel shading, const brdf_d::SurfaceInfo& s);

  std::size_t techniques() const { return lobeCount_ + (longTailed_ ? 2 : 1); }
  /// A direction of one technique. It may lie below the horizon.
  /// @param technique  below techniques()    @param u  [0, 1)^2
  glm::dvec3 sample(std::size_t technique, const glm::dvec2& u) const;
  /// Sum of the densities of all techniques, [1/sr]. @param l  unit, l.z > 0
  double pdfSum(const glm::dvec3& l) const;

 private:
  brdf_d::LobeMixture lobes_;  ///< every lobe that is there has the share 1
  std::size_t lobeCount_ = 0;
  bool longTailed_ = false;  ///< the coat is GTR1
};

}  // namespace telar::lobes
