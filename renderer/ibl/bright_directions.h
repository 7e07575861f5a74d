#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::ibl {

/// Samples the part of an equirectangular map that is far brighter than the rest: sun, lamps.
/// Directions are those of the map, unit; colours linear Rec.709.
class BrightDirections {
 public:
  struct Direction {
    glm::vec3 direction;
    glm::vec3 irradiance;  ///< on a surface that faces it, of the part of the light that the direction samples
    float density;         ///< of the directions there, per steradian; COMPACT where nothing else samples the light
  };

  static constexpr float COMPACT = 1e30f;

  BrightDirections() = default;
  /// Takes the excess over a multiple of the mean radiance.
  /// @param map  loses its compact lights (a sun) and what half floats do not hold; alpha becomes the luminance of the
  ///             excess that is left
  explicit BrightDirections(ImageF& map);

  /// `count` stratified directions, each of an equal part of the excess. None where there is no excess. Neighbours in
  /// the list are neighbours on the sphere.
  /// @param count        up to 2048
  /// @param first, step  of all these, the ones to return
  std::vector<Direction> directions(int count, int first = 0, int step = 1) const;
  /// Integral of the luminance of the excess over the sphere.
  double energy() const { return energy_; }

 private:
  /// One of the equal parts of the excess.
  struct Part {
    glm::vec3 direction, colour;  ///< colour of luminance 1
    float excess;                 ///< luminance of the excess there
    bool compact;
  };
  std::vector<Part> parts_;
  double energy_ = 0;
};

}  // namespace telar::ibl
