#include "reference/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace telar::reference::angles_test {
namespace {

constexpr double BOUND = 3e-7;  // as the header has it; a float of PI is 2.4e-7 from the next
constexpr int STEPS = 1'000'000;

TEST(Angles, ArcSineIsThatOfTheLibrary) {
  for (int i = -STEPS; i <= STEPS; ++i) {
    const float x = static_cast<float>(i) / STEPS;
    ASSERT_NEAR(arcSine(x), std::asin(static_cast<double>(x)), BOUND) << x;
  }
}

TEST(Angles, ArcTangentIsThatOfTheLibraryAllRound) {
  for (int i = 0; i < STEPS; ++i) {
    const double angle = (static_cast<double>(i) / STEPS * 2 - 1) * std::numbers::pi;
    for (const double length : {1e-30, 1.0, 1e30}) {
      const auto x = static_cast<float>(length * std::cos(angle)), y = static_cast<float>(length * std::sin(angle));
      ASSERT_NEAR(arcTangent(y, x), std::atan2(static_cast<double>(y), static_cast<double>(x)), BOUND) << x << " " << y;
    }
  }
}

TEST(Angles, ArcTangentOnTheAxes) {
  EXPECT_EQ(arcTangent(0, 0), 0);
  EXPECT_EQ(arcTangent(0, 1), 0);
  EXPECT_FLOAT_EQ(arcTangent(1, 0), std::numbers::pi_v<float> / 2);
  EXPECT_FLOAT_EQ(arcTangent(-1, 0), -std::numbers::pi_v<float> / 2);
  EXPECT_FLOAT_EQ(arcTangent(0.0f, -1), std::numbers::pi_v<float>);
  EXPECT_FLOAT_EQ(arcTangent(-0.0f, -1), -std::numbers::pi_v<float>);
}

TEST(Angles, SineAndCosineAreThoseOfTheLibrary) {
  for (int i = -STEPS; i <= STEPS; ++i) {
    const float turns = static_cast<float>(i) / (2 * STEPS);
    const SineCosine found = sineCosine(turns);
    const double angle = static_cast<double>(turns) * 2 * std::numbers::pi;
    ASSERT_NEAR(found.sine, std::sin(angle), BOUND) << turns;
    ASSERT_NEAR(found.cosine, std::cos(angle), BOUND) << turns;
  }
}

}  // namespace
}  // namespace telar::reference::angles_test
