#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace telar::ibl {

/// Directions and solid angles of an equirectangular map's texels: u = atan2(z, x), row 0 is +Y.
struct EquirectGrid {
  std::uint32_t width, height;

  /// Angle from +Y, radians. @param y  rows, 0 = the upper edge of the first
  double polar(double y) const { return glm::pi<double>() * y / height; }
  /// Of a texel in a row, steradian.
  double solidAngle(std::uint32_t y) const {
    return glm::two_pi<double>() / width * (std::cos(polar(y)) - std::cos(polar(y + 1.0)));
  }
  /// Of a texel's middle, unit.
  glm::dvec3 direction(std::uint32_t x, std::uint32_t y) const {
    const double phi = ((x + 0.5) / width - 0.5) * glm::two_pi<double>(), theta = polar(y + 0.5);
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
  }
};

}  // namespace telar::ibl
