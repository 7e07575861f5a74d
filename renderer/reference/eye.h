#pragma once
#include <optional>

#include "reference/geometry.h"
#include "telar/shot.h"

namespace telar::reference {

/// Height of the picture on the sensor, by which an angle of view has a focal length: that of 35 mm film.
constexpr double SENSOR_HEIGHT_M = 0.024;

/// Rays through the picture, in the tracer's world (metres about the scene's centre).
class Eye {
 public:
  Eye(const Shot& shot, const glm::dvec3& centre);

  /// @param pixel  from the top-left corner, y down
  /// @param u      [0, 1)^2, the point of the lens that the ray passes; without a lens it changes nothing
  Ray ray(const glm::dvec2& pixel, const glm::dvec2& u) const;
  const glm::mat3& toView() const { return toView_; }
  bool hasLens() const { return lens_.has_value(); }

 private:
  /// A thin lens: what lies in one plane is sharp.
  struct Lens {
    double radius = 0, focusDistance = 0, near = 0;  ///< metres
    glm::dvec3 centre{0};
    glm::dmat3 axes{1.0};  ///< right, up, back
  };
  glm::dvec3 point(const glm::dvec2& ndc, double depth) const;

  int width_, height_;
  glm::dmat4 toWorld_{1.0};
  glm::mat3 toView_{1.0f};
  std::optional<Lens> lens_;
};

}  // namespace telar::reference
