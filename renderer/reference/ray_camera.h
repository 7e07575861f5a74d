#pragma once
#include <optional>

#include "reference/surface.h"
#include "telar/shot.h"

namespace telar::reference {

/// Height of the sensor, that of 35 mm film. It turns an angle of view into a focal length.
constexpr double SENSOR_HEIGHT_M = 0.024;

/// Makes camera rays, in the tracer's world (metres about the scene's centre).
class RayCamera {
 public:
  RayCamera(const Shot& shot, const glm::dvec3& centre);

  /// @param pixel  from the top-left corner, y down
  /// @param u      [0, 1)^2, chooses the point on the lens; without a lens it changes nothing
  Ray generateRay(const glm::dvec2& pixel, const glm::dvec2& u) const;
  /// What that ray's surface needs to know how wide a pixel is.
  Footprint footprint(const glm::dvec2& pixel, const glm::dvec2& u) const;
  bool hasLens() const { return lens_.has_value(); }

 private:
  /// A thin lens: one plane is in focus.
  struct Lens {
    double radius = 0, focusDistance = 0, near = 0;  ///< metres
    glm::dvec3 centre{0};
    glm::dmat3 axes{1.0};  ///< right, up, back
  };
  /// A plane across the view: its points are linear in device coordinates.
  struct Plane {
    glm::dvec3 centre{0}, right{0}, up{0};
    glm::dvec3 at(const glm::dvec2& ndc) const { return centre + right * ndc.x + up * ndc.y; }
  };

  int width_, height_;
  Plane near_, far_;
  glm::mat3 toView_{1.0f};
  std::optional<Lens> lens_;
};

/// A point of the picture that a path starts at.
struct PixelPoint {
  const RayCamera& camera;
  glm::dvec2 pixel, lens;  ///< of generateRay()
  Ray ray() const { return camera.generateRay(pixel, lens); }
  Footprint footprint() const { return camera.footprint(pixel, lens); }
};

}  // namespace telar::reference
