#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "brdf/quadrature.h"

namespace telar::numerics {

/// A GGX lobe to draw directions for: its axes and widths.
struct Lobe {
  glm::dmat3 frame{1.0};  ///< columns: along, across, normal
  glm::dvec2 alpha{1.0};
};

/// A linearly transformed cosine to draw directions for, about +z.
struct Fuzz {
  glm::dvec3 towards{1, 0, 0};  ///< unit, in the plane of x and y: where the viewer is
  double aInverse = 1, bInverse = 0;
};

/// Quadrature over the hemisphere of +z by several point sets at once: directions by their cosine, and by each lobe.
/// Each point counts in proportion to how dense all sets together are there, so that the sum stays smooth however
/// narrow a lobe is.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.8, the balance heuristic, on
///   Hammersley points
class Mixture {
 public:
  Mixture(const glm::dvec3& v, std::vector<Lobe> lobes, int points, std::optional<Fuzz> fuzz = std::nullopt)
      : v_(v), lobes_(std::move(lobes)), points_(points), fuzz_(fuzz) {}

  /// Integral of f(l) dl over the directions with l.z > 0.
  template <class Integrand>
  auto integrate(Integrand f) const {
    decltype(f(glm::dvec3(0)) * 1.0) sum{};
    const std::size_t sets = lobes_.size() + 1;
    for (std::size_t set = 0; set < sets + (fuzz_ ? 1 : 0); ++set) {
      for (int i = 0; i < points_; ++i) {
        const glm::dvec2 u((i + 0.5) / points_, radicalInverse(static_cast<std::uint32_t>(i)));
        const glm::dvec3 cosine = test::direction(std::sqrt(u.x), test::TWO_PI * u.y);
        const glm::dvec3 l = set == 0 ? cosine : set == sets ? drawn(*fuzz_, cosine) : drawn(lobes_[set - 1], u);
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

  static glm::dvec3 aside(const Fuzz& fuzz) { return glm::cross(glm::dvec3(0, 0, 1), fuzz.towards); }

  static glm::dvec3 drawn(const Fuzz& fuzz, const glm::dvec3& w) {
    return glm::normalize(fuzz.towards * ((w.x - fuzz.bInverse * w.z) / fuzz.aInverse) +
                          aside(fuzz) * (w.y / fuzz.aInverse) + glm::dvec3(0, 0, w.z));
  }

  static double density(const Fuzz& fuzz, const glm::dvec3& l) {
    const double a = fuzz.aInverse;
    const glm::dvec3 w(a * glm::dot(fuzz.towards, l) + fuzz.bInverse * l.z, a * glm::dot(aside(fuzz), l), l.z);
    return l.z * a * a / (test::TWO_PI / 2 * glm::dot(w, w) * glm::dot(w, w));
  }

  /// Sum of the densities of all sets, [1/sr].
  double density(const glm::dvec3& l) const {
    constexpr double PI = test::TWO_PI / 2;
    double sum = l.z / PI + (fuzz_ ? density(*fuzz_, l) : 0.0);
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
  std::optional<Fuzz> fuzz_;
};

}  // namespace telar::numerics
