#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"

namespace telar::reference {

/// An equirectangular map as a light. It is read as the raster reads it and sampled by its luminance.
class EnvironmentLight {
 public:
  /// @param map        linear Rec.709 radiance, finite
  /// @param rotation   degrees about +Y, as Shot::Environment
  /// @param intensity  factor on the radiance
  EnvironmentLight(const ImageF& map, double rotation, double intensity);

  struct Sample {
    glm::vec3 direction;  ///< world, unit
    float pdf;            ///< per steradian
  };
  Sample sample(const glm::vec2& u) const;
  /// @param direction  world, unit
  float pdf(const glm::vec3& direction) const;
  /// Bilinear, clamped at the edges, as three.js reads the map.
  glm::vec3 radiance(const glm::vec3& direction) const;

 private:
  glm::vec3 texel(int x, int y) const;
  /// Environment direction to map coordinates in [0, 1], y down.
  glm::vec2 coordinates(const glm::vec3& direction) const;
  /// Density of the directions of a texel, per steradian.
  float pdfOf(std::size_t row, std::size_t column) const;

  const ImageF& map_;
  float intensity_;
  glm::mat3 toEnvironment_;
  std::vector<double> heights_;  // y of the upper edge of each row, height + 1
  std::vector<float> rows_;      // CDF of the rows, height + 1
  std::vector<float> columns_;   // CDF within each row, (width + 1) a row
};

}  // namespace telar::reference
