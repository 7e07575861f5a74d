#pragma once
#include <cmath>
#include <vector>

#include "brdf/quadrature.h"

namespace telar::numerics {

/// A GGX lobe to draw directions for: its axes and widths.
struct Lobe {
  glm::dmat3 frame{1.0};  ///< columns: along, across, normal
  glm::dvec2 alpha{1.0};
};

/// Quadrature over the hemisphere of +z by several point sets at once: directions by their cosine, and by each lobe.
/// Each point counts in proportion to how dense all sets together are there, so that the sum stays smooth however
/// narrow a lobe is.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.8, the balance heuristic, on
///   Hammersley points
class Mixture {
 public:
  Mixture(const glm::dvec3& v, std::vector<Lobe> lobes, int points)
      : v_(v), lobes_(std::move(lobes)), points_(points) {}

  /// Integral of f(l) dl over the directions with l.z > 0.
  template <class Integrand>
  auto integrate(Integrand f) const {
    decltype(f(glm::dvec3(0)) * 1.0) sum{};
    for (std::size_t set = 0; set <= lobes_.size(); ++set) {
      for (int i = 0; i < points_; ++i) {
        const glm::dvec2 u((i + 0.5) / points_, radicalInverse(static_cast<std::uint32_t>(i)));
        const glm::dvec3 l = set == 0 ? test::direction(std::sqrt(u.x), test::TWO_PI * u.y) : drawn(lobes_[set - 1], u);
        if (!(l.z > 0)) continue;
        sum += f(l) * (1.0 / (density(l) * points_));
      }
    }
    return sum;
  }

 private:
  static double radicalInverse(std::uint32_t bits) {
    double value = 0, digit = 0.5;
    for (; bits; bits >>= 1, digit *= 0.5) value += digit * (bits & 1);
    return value;
  }

  /// v reflected about a normal that is as frequent as D(h) h.z says.
  glm::dvec3 drawn(const Lobe& lobe, const glm::dvec2& u) const {
    const double slope = std::sqrt(u.x / (1 - u.x)), phi = test::TWO_PI * u.y;
    const glm::dvec3 h = lobe.frame * glm::normalize(glm::dvec3(lobe.alpha.x * slope * std::cos(phi),
                                                                lobe.alpha.y * slope * std::sin(phi), 1));
    const double VoH = glm::dot(v_, h);
    return VoH > 0 ? 2 * VoH * h - v_ : glm::dvec3(0, 0, -1);
  }

  /// Sum of the densities of all sets, [1/sr].
  double density(const glm::dvec3& l) const {
    constexpr double PI = test::TWO_PI / 2;
    double sum = l.z / PI;
    for (const Lobe& lobe : lobes_) {
      const glm::dvec3 between = l + v_;
      if (glm::dot(between, between) < 1e-24) continue;
      const glm::dvec3 h = glm::normalize(between), local = glm::transpose(lobe.frame) * h;
      if (local.z <= 0) continue;
      const glm::dvec3 x(local.x / lobe.alpha.x, local.y / lobe.alpha.y, local.z);
      const double d = 1 / (PI * lobe.alpha.x * lobe.alpha.y * glm::dot(x, x) * glm::dot(x, x));
      sum += d * local.z / (4 * glm::dot(v_, h));
    }
    return sum;
  }

  glm::dvec3 v_;
  std::vector<Lobe> lobes_;
  int points_;
};

}  // namespace telar::numerics
