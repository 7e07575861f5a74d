#include "asset/pose/sample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace telar::test {
namespace {

using asset::sample;

AnimationSampler samplerOf(Interpolation interpolation, std::size_t width, std::vector<float> times,
                           std::vector<float> values) {
  return {interpolation, width, std::move(times), std::move(values)};
}

std::vector<float> aboutZ(double degrees) {
  const double half = degrees * std::acos(-1.0) / 360;
  return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

AnimationSampler turns(Interpolation interpolation, double from, double to, float sign = 1) {
  std::vector<float> values = aboutZ(from);
  for (const float x : aboutZ(to)) values.push_back(sign * x);
  return samplerOf(interpolation, 4, {0, 2}, values);
}

double degreesOf(const std::vector<double>& q) { return std::atan2(q[2], q[3]) * 360 / std::acos(-1.0); }

TEST(Sample, LinearValuesLieBetweenTheirKeyframes) {
  const auto sampler = samplerOf(Interpolation::kLinear, 3, {1, 2, 4}, {0, 0, 0, 1, 2, 4, 3, -2, 4});
  EXPECT_EQ(sample(sampler, AnimationPath::kTranslation, 1.25), (std::vector<double>{0.25, 0.5, 1}));
  EXPECT_EQ(sample(sampler, AnimationPath::kTranslation, 3.5), (std::vector<double>{2.5, -1, 4}));
}

TEST(Sample, KeyframesHoldBeforeTheFirstAndAfterTheLast) {
  const auto sampler = samplerOf(Interpolation::kLinear, 1, {1, 2}, {5, 7});
  for (const double time : {-1e30, 0.0, 1.0}) {
    EXPECT_EQ(sample(sampler, AnimationPath::kWeights, time), std::vector<double>{5}) << time;
  }
  for (const double time : {2.0, 1e30}) {
    EXPECT_EQ(sample(sampler, AnimationPath::kWeights, time), std::vector<double>{7}) << time;
  }
}

TEST(Sample, StepsHoldUntilTheNextKeyframe) {
  const auto sampler = samplerOf(Interpolation::kStep, 1, {0, 1, 2}, {1, 2, 3});
  EXPECT_EQ(sample(sampler, AnimationPath::kWeights, 0.999), std::vector<double>{1});
  EXPECT_EQ(sample(sampler, AnimationPath::kWeights, 1), std::vector<double>{2});
}

TEST(Sample, SplinesAreHermiteCurvesOfValuesAndTangents) {
  // From 1 with tangent 4 to 3 with tangent -2, two seconds long.
  const auto sampler = samplerOf(Interpolation::kCubicSpline, 1, {0, 2}, {9, 1, 4, -2, 3, 9});
  // Half way: (1 + 3) / 2 + (4 - -2) * 2 / 8; a quarter: 0.84375, 0.140625, 0.15625, -0.046875 of 1, 4 * 2, 3, -2 * 2.
  EXPECT_DOUBLE_EQ(sample(sampler, AnimationPath::kWeights, 1)[0], 3.5);
  EXPECT_DOUBLE_EQ(sample(sampler, AnimationPath::kWeights, 0.5)[0], 0.84375 + 1.125 + 0.46875 + 0.1875);
  EXPECT_EQ(sample(sampler, AnimationPath::kWeights, 0)[0], 1);
  EXPECT_EQ(sample(sampler, AnimationPath::kWeights, 2)[0], 3);
}

TEST(Sample, SplinesOfVectorsUseEachTangentOfItsOwn) {
  const auto sampler =
      samplerOf(Interpolation::kCubicSpline, 3, {0, 1}, {0, 0, 0, 1, 2, 3, 8, 0, -8, 0, 16, 0, 5, 6, 7, 0, 0, 0});
  EXPECT_EQ(sample(sampler, AnimationPath::kScale, 0.5), (std::vector<double>{4, 2, 4}));
}

TEST(Sample, RotationsTurnEvenlyAlongTheShorterArc) {
  EXPECT_NEAR(degreesOf(sample(turns(Interpolation::kLinear, 0, 90), AnimationPath::kRotation, 0.5)), 22.5, 1e-5);
  EXPECT_NEAR(degreesOf(sample(turns(Interpolation::kLinear, 10, 60, -1), AnimationPath::kRotation, 1.5)), 47.5, 1e-5);
  // Nearly parallel: a line, normalized.
  const auto close = sample(turns(Interpolation::kLinear, 0, 1), AnimationPath::kRotation, 1);
  EXPECT_NEAR(degreesOf(close), 0.5, 1e-5);
  EXPECT_NEAR(std::hypot(close[2], close[3]), 1, 1e-12);
}

TEST(Sample, SplinesOfRotationsAreNormalized) {
  std::vector<float> values{0, 0, 0, 0};
  for (const auto& part : {aboutZ(0), std::vector<float>{0, 0, 3, 0}, std::vector<float>{0, 0, 0, 0}, aboutZ(90),
                           std::vector<float>{0, 0, 0, 0}}) {
    values.insert(values.end(), part.begin(), part.end());
  }
  const auto q = sample(samplerOf(Interpolation::kCubicSpline, 4, {0, 1}, values), AnimationPath::kRotation, 0.5);
  EXPECT_NEAR(std::hypot(q[2], q[3]), 1, 1e-12);
  EXPECT_NEAR(q[2] / q[3], (0.5 * std::sqrt(0.5) + 0.125 * 3) / (0.5 + 0.5 * std::sqrt(0.5)), 1e-6);
}

TEST(Sample, EqualTimesAreAJump) {
  const auto sampler = samplerOf(Interpolation::kLinear, 1, {0, 1, 1, 2}, {0, 1, 5, 6});
  EXPECT_NEAR(sample(sampler, AnimationPath::kWeights, 0.999999)[0], 1, 1e-5);
  EXPECT_EQ(sample(sampler, AnimationPath::kWeights, 1)[0], 5);
}

}  // namespace
}  // namespace telar::test
