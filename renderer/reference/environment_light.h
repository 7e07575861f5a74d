#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <utility>
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

  /// Where a direction lies in the map: between the centres of four texels.
  struct Place {
    glm::ivec2 low{0};  ///< column and row of the first one; -1 beyond the edge
    glm::vec2 part{0};  ///< from it to the last, [0, 1]
  };
  struct Sample {
    glm::vec3 direction;  ///< world, unit
    float pdf;            ///< per steradian
    Place place;
  };
  Sample sample(const glm::vec2& u) const;
  static constexpr std::size_t MAX_SAMPLES = 32;
  /// One for each of `us`, MAX_SAMPLES or fewer: their reads wait for memory together, and the map's texels are on
  /// their way when it returns.
  void sample(std::span<const glm::vec2> us, Sample* samples) const;
  /// @param direction  world, unit
  float pdf(const glm::vec3& direction) const;
  /// Bilinear, clamped at the edges, as three.js reads the map.
  glm::vec3 radiance(const glm::vec3& direction) const;
  /// The map at the place is on its way from memory: its pdf() and radiance() are for later.
  Place find(const glm::vec3& direction) const;
  float pdf(const Place& place) const;
  glm::vec3 radiance(const Place& place) const;
  /// radiance() of a sample's direction.
  glm::vec3 radiance(const Sample& sample) const { return radiance(sample.place); }

 private:
  /// A cumulative distribution with a table of where to look in it: finding a place takes one or two steps at any
  /// length. src: Chen & Asau 1974, "On Generating Random Variates from an Empirical Distribution", the guide table
  struct Cdf {
    const float* begin;  ///< ascending from 0 to 1, count + 1, and SCANNED more of any value
    const std::uint16_t* guide;
    std::size_t count;
    /// The interval that u falls in, and the place within it. @param u  [0, 1]
    std::pair<std::size_t, float> find(float u) const;
    static constexpr std::size_t SCANNED = 4;  ///< steps that are looked at together
    const std::uint16_t* guideOf(float u) const;
  };
  Cdf rows() const { return {rows_.data(), rowGuide_.data(), map_.height}; }
  Cdf columns(std::size_t row) const;
  /// @param guide  of guideLength(count)
  static void fillGuide(const float* begin, std::size_t count, std::uint16_t* guide);

  /// Entries of a guide: few enough that those of all rows stay in a cache.
  static std::size_t guideLength(std::size_t count) { return (count + 3) / 4; }
  Sample sampleRow(std::size_t row, float inRow, float u) const;
  /// @param coordinates  of the map, in [0, 1]
  Place placeAt(const glm::vec2& coordinates) const;
  /// Row and column of the texel that a place lies in.
  std::pair<std::size_t, std::size_t> rowAndColumn(const Place& place) const;
  /// Asks the memory for the texels that radiance() reads.
  void prefetch(const Place& place) const;
  const float* texelAt(int x, int y) const;
  glm::vec3 texel(int x, int y) const;
  /// Environment direction to map coordinates in [0, 1], y down.
  glm::vec2 coordinates(const glm::vec3& direction) const;
  /// Density of the directions of a texel, per steradian.
  float pdfOf(std::size_t row, std::size_t column) const;

  const ImageF& map_;
  float intensity_;
  glm::mat3 toEnvironment_;
  std::vector<double> heights_;  // y of the upper edge of each row, height + 1
  std::vector<float> rows_;      // CDF of the rows, height + 1, and Cdf::SCANNED more
  std::vector<float> columns_;   // CDF within each row, (width + 1) a row, and Cdf::SCANNED more
  std::vector<std::uint16_t> rowGuide_, columnGuide_;
  std::vector<float> densities_;  // of a row: of its directions per part of its columns, 1/sr
};

}  // namespace telar::reference
