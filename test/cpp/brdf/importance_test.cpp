#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/brdf.h"

/// A density is right where the mean of 1 / density over its own draws is the size of what they cover, and where the
/// density integrates to 1.
namespace telar {
namespace {

using namespace brdf_d;
constexpr double PI_D = 3.14159265358979323846;

/// Integral over the sphere by the midpoints of equal areas.
template <class F>
double overSphere(const F& f) {
  constexpr int ROWS = 1000, COLUMNS = 2000;
  double sum = 0;
  for (int i = 0; i < ROWS; ++i) {
    const double z = 1 - 2 * (i + 0.5) / ROWS, r = std::sqrt(1 - z * z);
    for (int k = 0; k < COLUMNS; ++k) {
      const double phi = 2 * PI_D * (k + 0.5) / COLUMNS;
      sum += f(vec3(r * std::cos(phi), r * std::sin(phi), z));
    }
  }
  return sum * 4 * PI_D / ROWS / COLUMNS;
}

TEST(Importance, DensitiesIntegrateToOne) {
  EXPECT_NEAR(overSphere([](const vec3& l) { return pdfCosine(l.z); }), 1, 1e-5);
  EXPECT_NEAR(overSphere([](const vec3& l) { return pdfHemisphere(l.z); }), 1, 1e-3);
  for (const vec2 alpha : {vec2(0.1, 0.1), vec2(0.6, 0.15), vec2(1, 1)}) {
    for (const double elevation : {0.05, 0.5, 1.5}) {
      const vec3 v(std::cos(elevation) * 0.8, std::cos(elevation) * 0.6, std::sin(elevation));
      EXPECT_NEAR(overSphere([&](const vec3& l) { return pdfReflection(v, l, alpha); }), 1, 4e-3) << elevation;
    }
  }
}

TEST(Importance, DrawsLieAsTheirDensitySays) {
  constexpr int N = 400;
  const vec3 v = normalize(vec3(0.6, -0.3, 0.5));
  const vec2 alpha(0.5, 0.2);
  const vec3 towards = normalize(vec3(-0.5, 0.3, 0.6));
  const auto weight = [&](const vec3& l) { return l.z > 0 ? std::pow(std::max(dot(l, towards), 0.0), 4.0) : 0.0; };
  double gloss = 0, matt = 0;
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < N; ++k) {
      const vec2 u((i + 0.5) / N, (k + 0.5) / N);
      const vec3 h = sampleVisibleNormal(v, alpha, u);
      const vec3 l = 2.0 * dot(v, h) * h - v;
      gloss += weight(l) / (N * N);
      matt += weight(sampleCosine(u)) / (N * N);
    }
  }
  EXPECT_NEAR(gloss, overSphere([&](const vec3& l) { return weight(l) * pdfReflection(v, l, alpha); }), 2e-3 * gloss);
  // Square as the sheen's frame is, whatever the viewer's side.
  const vec3 ltc = sheenLtc(0.3, 0.6);
  double sheen = 0;
  for (int i = 0; i < N * N; ++i)
    sheen += weight(sampleSheenLtc(ltc, vec2((i / N + 0.5) / N, (i % N + 0.5) / N))) / (N * N);
  EXPECT_NEAR(sheen, overSphere([&](const vec3& l) { return weight(l) * sheenLtcCosine(vec3(1, ltc.y, ltc.z), l); }),
              2e-3 * sheen);
  EXPECT_NEAR(matt, overSphere([&](const vec3& l) { return weight(l) * pdfCosine(l.z); }), 1e-4 * matt);
}

TEST(Importance, TheBasisIsSquareForEveryNormal) {
  for (const vec3 n : {vec3(0, 0, 1), vec3(0, 0, -1), normalize(vec3(1, 2, -1e-9)), normalize(vec3(-1, 0.1, 0))}) {
    const mat3 basis = basisAbout(n);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(dot(basis[a], basis[b]), a == b ? 1 : 0, 1e-12);
    }
    EXPECT_NEAR(dot(cross(basis[0], basis[1]), n), 1, 1e-12);
  }
}

}  // namespace
}  // namespace telar
