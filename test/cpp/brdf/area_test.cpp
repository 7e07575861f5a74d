#include <gtest/gtest.h>

#include <cmath>

#include "brdf/brdf.h"

/// Rectangles of light against what geometry says of them, in double.
namespace telar::test::area_test {
namespace {

using namespace brdf_d;

const vec3 UP(0, 0, 1);

/// Share of the cosine lobe about `n` that a rectangle fills; its front is towards the origin.
double share(const vec3& n, const vec3& v, const vec3& centre, const vec3& halfWidth, const vec3& halfHeight) {
  return ltcRectangle(ltcFrame(n, v), centre + halfWidth - halfHeight, centre - halfWidth - halfHeight,
                      centre - halfWidth + halfHeight, centre + halfWidth + halfHeight);
}

double above(double height, double halfWidth, double halfHeight) {
  return share(UP, glm::normalize(vec3(0.3, 0.1, 1)), UP * height, vec3(halfWidth, 0, 0), vec3(0, halfHeight, 0));
}

TEST(Area, ParallelRectangleHasItsKnownFormFactor) {
  for (const double x : {0.05, 0.5, 1.0, 3.0}) {
    for (const double y : {0.05, 0.5, 1.0, 3.0}) {
      const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
      const double exact = 2 / PI * (x / a * std::atan(y / a) + y / b * std::atan(x / b));
      // |f| >= f.z, so the sphere that stands for the polygon keeps the whole of it.
      EXPECT_NEAR(above(1, x, y), exact, 2e-3) << x << " " << y;
    }
  }
}

TEST(Area, EndlessRectangleFillsTheLobeAndATinyOneIsAPoint) {
  EXPECT_NEAR(above(1, 1e4, 1e4), 1, 1e-3);
  const double angle = 0.7;
  const vec3 direction(std::sin(angle), 0, std::cos(angle));
  const double point = share(UP, vec3(0, 0.6, 0.8), direction * 5.0, vec3(std::cos(angle), 0, -std::sin(angle)) * 0.01,
                             vec3(0, 0.01, 0));
  EXPECT_NEAR(point / (std::cos(angle) * 4e-4 / 25 / PI), 1, 2e-3);
}

TEST(Area, NothingComesFromBelowTheHorizon) {
  EXPECT_EQ(share(UP, vec3(0, 0.6, 0.8), vec3(1, 0, -2), vec3(-0.5, 0, 0), vec3(0, 0.5, 0)), 0);
}

TEST(Area, ViewedHeadOnALobeIsWhatItIsBesideThat) {
  // Round, as the tables are where the viewer stands on the axis.
  const mat3 fit = ltcInverse(vec4(1, 0, 0, 0.4));
  for (const vec3& n : {vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, -1, 0), glm::normalize(vec3(1, 2, 3))}) {
    const vec3 aside = anyTangent(n), other = glm::cross(n, aside), centre = 2.0 * n + 0.7 * aside;
    EXPECT_NEAR(glm::dot(aside, n), 0, 1e-15);
    const auto lit = [&](const vec3& v) {
      return ltcRectangle(fit * ltcFrame(n, v), centre + aside - other, centre - aside - other, centre - aside + other,
                          centre + aside + other);
    };
    EXPECT_GT(lit(n), 0.01);
    for (const double tilt : {1e-6, 1e-5, 1e-4, 1e-3})
      EXPECT_NEAR(lit(glm::normalize(n + tilt * other)), lit(n), 1e-6 + tilt) << tilt;
  }
}

}  // namespace
}  // namespace telar::test::area_test
