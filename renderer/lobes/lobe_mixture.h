#pragma once
#include <vector>

#include "brdf/shading.h"
#include "telar/shading.h"

namespace telar::lobes {

/// Importance sampling of a BSDF by several techniques: cosine, dense towards the horizon, and one for each narrow
/// lobe. Each technique draws the same number of directions. Weighted by the densities of all techniques, the integrand
/// stays smooth however narrow a lobe is. src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation",
/// eq. 9.8, the balance heuristic
class LobeMixture {
 public:
  /// @param s  prepared, about z = normal
  LobeMixture(ShadingModel shading, const brdf_d::SurfaceInfo& s);

  std::size_t techniques() const { return WIDE_TECHNIQUES + microfacets_.size() + sheens_.size(); }
  /// A direction of one technique. It may lie below the horizon.
  /// @param technique  below techniques()    @param u  [0, 1)^2
  glm::dvec3 sample(std::size_t technique, const glm::dvec2& u) const;
  /// Sum of the densities of all techniques, [1/sr]. @param l  unit, l.z > 0
  double pdfSum(const glm::dvec3& l) const;

 private:
  static constexpr std::size_t WIDE_TECHNIQUES = 2;
  struct MicrofacetLobe {
    glm::dmat3 frame{1.0};
    glm::dvec2 alpha{1.0};
    glm::dvec3 v{0, 0, 1};    ///< the viewer in `frame`
    bool longTailed = false;  ///< GTR1 in place of GGX
    bool mirrored = false;    ///< a yarn: the shading mirrors what it reflects below the surface
  };
  /// A linearly transformed cosine.
  struct SheenLobe {
    glm::dmat3 frame{1.0};
    glm::dvec3 ltc{0};
  };
  void addMicrofacets(const brdf_d::SurfaceInfo& s, const glm::dmat3& frame, const glm::dvec2& alpha);
  void addSheen(const brdf_d::SurfaceInfo& s);
  static glm::dvec3 sample(const MicrofacetLobe& lobe, const glm::dvec2& u);
  static double pdf(const MicrofacetLobe& lobe, const glm::dvec3& l);

  std::vector<MicrofacetLobe> microfacets_;
  std::vector<SheenLobe> sheens_;
};

}  // namespace telar::lobes
