#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::ibl {

/// The part of an equirectangular map that is far brighter than the rest (sun, lamps), to be drawn from.
/// Directions are those of the map, unit; colours linear Rec.709.
class BrightDirections {
 public:
  struct Direction {
    glm::vec3 direction;
    glm::vec3 irradiance;  ///< on a surface that faces it, of the light that it stands for
    float density;         ///< of such directions there, per steradian; COMPACT where nothing else stands for the light
  };

  static constexpr float COMPACT = 1e30f;

  BrightDirections() = default;
  /// Takes the excess over a multiple of the mean radiance.
  /// @param map  what is small (a sun), or more than a half holds, is taken out of it; alpha becomes the luminance of
  ///             the excess that stays
  explicit BrightDirections(ImageF& map);

  /// `count` directions that stand for equal parts of the excess, spread evenly; none where there is no excess.
  /// Neighbours among them are neighbours on the sphere.
  /// @param count        up to 2048
  /// @param first, step  of all these, the ones to return
  std::vector<Direction> directions(int count, int first = 0, int step = 1) const;
  /// Integral of the luminance of the excess over the sphere.
  double energy() const { return energy_; }

 private:
  /// A place among equal parts of the excess.
  struct Part {
    glm::vec3 direction, colour;  ///< colour of luminance 1
    float excess;                 ///< luminance of the excess there
    bool compact;
  };
  std::vector<Part> parts_;
  double energy_ = 0;
};

}  // namespace telar::ibl
