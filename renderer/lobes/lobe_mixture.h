#pragma once
#include <vector>

#include "brdf/shading.h"
#include "telar/shading.h"

namespace telar::lobes {

/// Several ways to draw the directions above a surface, each right for a part of what it reflects: by the cosine, dense
/// towards the horizon, and about every narrow lobe as it is spread itself. Drawn from all alike and weighed by the
/// densities of all, the integrand stays smooth however narrow a lobe is.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.8, the balance heuristic
class LobeMixture {
 public:
  /// @param s  prepared, about z = normal
  LobeMixture(ShadingModel shading, const brdf_d::SurfaceInfo& s);

  std::size_t ways() const { return WIDE_WAYS + glosses_.size() + sheens_.size(); }
  /// A direction drawn in one way; it may lie below the horizon.
  /// @param u  [0, 1)^2
  glm::dvec3 draw(std::size_t way, const glm::dvec2& u) const;
  /// Sum of the densities of all ways, [1/sr]. @param l  unit, l.z > 0
  double density(const glm::dvec3& l) const;

 private:
  static constexpr std::size_t WIDE_WAYS = 2;
  /// A lobe of microfacets.
  struct Gloss {
    glm::dmat3 frame{1.0};
    glm::dvec2 alpha{1.0};
    glm::dvec3 v{0, 0, 1};    ///< the viewer in `frame`
    bool longTailed = false;  ///< GTR1 in place of GGX
    bool mirrored = false;    ///< what it sends below the surface comes back: yarns
  };
  /// A transformed cosine.
  struct Sheen {
    glm::dmat3 frame{1.0};
    glm::dvec3 ltc{0};
  };
  void addGloss(const brdf_d::SurfaceInfo& s, const glm::dmat3& frame, const glm::dvec2& alpha);
  void addSheen(const brdf_d::SurfaceInfo& s);
  static glm::dvec3 drawn(const Gloss& gloss, const glm::dvec2& u);
  static double density(const Gloss& gloss, const glm::dvec3& l);

  std::vector<Gloss> glosses_;
  std::vector<Sheen> sheens_;
};

}  // namespace telar::lobes
