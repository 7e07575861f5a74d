#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "brdf/brdf.h"

/// Integrals over directions, in double. The surface's normal is +z, the view lies in the xz plane; `strata` is the
/// number of strata a side. An integrand gives a double or a vector.
namespace telar::test {

inline constexpr double TWO_PI = 6.283185307179586;

inline glm::dvec3 direction(double cosine, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

/// Integral of f(l) dl over the hemisphere. Strata are squared towards grazing, where the lobes of cloth are steep.
template <class Integrand>
auto overHemisphere(int strata, Integrand f) {
  decltype(f(glm::dvec3(0)) * 1.0) sum{};
  for (int i = 0; i < strata; ++i) {
    const double s = (i + 0.5) / strata, weight = 2 * s * TWO_PI / (double(strata) * strata);
    for (int j = 0; j < strata; ++j) sum += f(direction(s * s, TWO_PI * (j + 0.5) / strata)) * weight;
  }
  return sum;
}

/// Integral of f(l) l.z dl, l drawn by its cosine: for wide lobes.
template <class Integrand>
auto overCosine(int strata, Integrand f) {
  decltype(f(glm::dvec3(0)) * 1.0) sum{};
  for (int i = 0; i < strata; ++i) {
    for (int j = 0; j < strata; ++j)
      sum += f(direction(std::sqrt((i + 0.5) / strata), TWO_PI * (j + 0.5) / strata)) * (TWO_PI / 2);
  }
  return sum * (1.0 / (double(strata) * strata));
}

/// Integral of f(l) l.z dl, l drawn about the mirror direction of v as GGX of width alpha spreads it: for narrow lobes.
template <class Integrand>
auto overGgx(int strata, double alpha, const glm::dvec3& v, Integrand f) {
  decltype(f(glm::dvec3(0)) * 1.0) sum{};
  for (int i = 0; i < strata; ++i) {
    for (int j = 0; j < strata; ++j) {
      const double u = (i + 0.5) / strata;
      const double NoH = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u));
      const glm::dvec3 h = direction(NoH, TWO_PI * (j + 0.5) / strata);
      const double VoH = glm::dot(v, h);
      const glm::dvec3 l = 2.0 * VoH * h - v;
      if (VoH <= 0 || l.z <= 0) continue;
      const double c = NoH * NoH * (alpha * alpha - 1) + 1;
      const double pdf = alpha * alpha / (TWO_PI / 2 * c * c) * NoH / (4 * VoH);
      sum += f(l) * (l.z / pdf);
    }
  }
  return sum * (1.0 / (double(strata) * strata));
}

/// The same for f(NoL, NoH, LoH).
template <class Lobe>
auto lobeOverGgx(int strata, double alpha, double NoV, Lobe f) {
  const glm::dvec3 v = direction(NoV, 0);
  return overGgx(strata, alpha, v, [&](const glm::dvec3& l) {
    const glm::dvec3 h = brdf_d::halfVector(glm::dvec3(0, 0, 1), l, v);
    return f(l.z, h.z, glm::dot(l, h));
  });
}

/// Area that the normals of a distribution D(NoH) project to: 1 where it is normalised. The nodes theta = pi/2 s^4 are
/// dense where a narrow lobe is.
template <class Distribution>
double projectedArea(Distribution d, int steps = 20000) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps, theta = TWO_PI / 4 * s * s * s * s, step = TWO_PI * s * s * s / steps;
    sum += d(std::cos(theta)) * std::cos(theta) * TWO_PI * std::sin(theta) * step;
  }
  return sum;
}

/// (A, B) of the split sum with the exact Schlick power.
inline glm::dvec2 splitSum(double alpha, double NoV, int strata = 256) {
  return lobeOverGgx(strata, alpha, NoV, [&](double NoL, double NoH, double LoH) {
    const double weight = std::pow(1 - LoH, 5);
    return brdf_d::V_SmithGGXCorrelated(alpha, NoV, NoL) * brdf_d::D_GGX(alpha, NoH) * glm::dvec2(1 - weight, weight);
  });
}

}  // namespace telar::test
