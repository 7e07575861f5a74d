#pragma once
#include <glm/glm.hpp>
#include <memory>

#include "telar/cancel.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

/// Light that a surface sends to the viewer, linear Rec.709. `total` is the sum of the four: what one lobe takes from
/// another (a coat from what lies beneath) is taken.
struct LobeRadiance {
  glm::dvec3 diffuse{0}, specular{0}, sheen{0}, coat{0}, total{0};
};

/// Share of the light that a surface reflects, by lobe.
struct Albedo {
  LobeRadiance value;
  LobeRadiance error;  ///< the truth lies no farther from `value`, in 999 cases of 1000
};

/// A material seen from one side, shaded in double by the text that the renderer shades with. Tangent frame: z =
/// normal, x = tangent; the viewer stands in the half plane x >= 0, y = 0. Textures are left out, as if white, normal
/// maps flat.
class ShadedMaterial {
 public:
  /// @param material   index into the scene's; the shading "fabric" takes it with its preset, as in a picture
  /// @param shot       of which only the shading is read
  /// @param viewAngle  radians from the normal, [0, pi / 2)
  ShadedMaterial(const Scene& scene, std::size_t material, const Shot& shot, double viewAngle);

  /// Radiance under light of one direction that gives the irradiance 1 on a surface that faces it: the BRDF times NoL.
  /// @param l  unit, to the light
  LobeRadiance radiance(const glm::dvec3& l) const;

  /// Share of the light that the surface reflects, for light that comes evenly from everywhere to this viewer: the
  /// directional albedo, with its error. Directions are drawn as the lobes lie, until the error is below 1e-6 or there
  /// are 8192 times 16 of them for each lobe: the narrowest lobes then have errors of some 1e-4. The same numbers
  /// always.
  /// @throws Error{X_CANCELLED}
  Albedo albedo(const CancelToken& cancel) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace telar
