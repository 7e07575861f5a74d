#include "reference/environment_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/random.h"
#include "reference/sphere.h"

namespace telar::reference {
namespace {

/// A dim gradient with one small sun.
ImageF sunnyMap() {
  ImageF map{64, 32, std::vector<float>(64 * 32 * 4, 1.0f)};
  for (std::size_t y = 0; y < 32; ++y) {
    for (std::size_t x = 0; x < 64; ++x) {
      float* p = &map.pixels[(y * 64 + x) * 4];
      p[0] = 0.1f + 0.01f * static_cast<float>(y);
      p[1] = 0.2f;
      p[2] = x == 20 && y == 9 ? 500.0f : 0.05f;
    }
  }
  return map;
}

/// Mean over n draws of f(direction) / pdf, and its standard error.
template <class F>
std::pair<double, double> estimate(const EnvironmentLight& light, int n, F f) {
  Random random(3, 0, 0);
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const auto [direction, pdf, place] = light.sample(random.uniform2());
    const double x = pdf > 0 ? f(direction) / pdf : 0;
    sum += x, squares += x * x;
  }
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / n)};
}

double quadrature(const EnvironmentLight& light, float glm::vec3::*channel) {
  constexpr int ROWS = 800, COLUMNS = 1600;
  double sum = 0;
  for (int i = 0; i < ROWS; ++i) {
    for (int j = 0; j < COLUMNS; ++j) {
      const double y = -1 + 2 * (i + 0.5) / ROWS, phi = 6.283185307 * (j + 0.5) / COLUMNS, r = std::sqrt(1 - y * y);
      sum += light.radiance(glm::vec3(glm::dvec3(r * std::cos(phi), y, r * std::sin(phi)))).*channel;
    }
  }
  return sum * 4 * 3.14159265358979 / (ROWS * COLUMNS);
}

// A place of the map is drawn by its luminance: what falls between two places of [0, 1) is what lies between them.
TEST(EnvironmentLight, DrawsInvertTheDistribution) {
  const ImageF map = sunnyMap();
  const EnvironmentLight light(map, 37, 0.7);
  // Where places of equal distances are drawn, the density of each is that of its direction.
  constexpr int SIDE = 200;
  std::array<EnvironmentLight::Sample, EnvironmentLight::MAX_SAMPLES> together;
  int inSun = 0;
  for (int i = 0; i < SIDE * SIDE; ++i) {
    const glm::vec2 u = (glm::vec2(i % SIDE, i / SIDE) + 0.5f) / static_cast<float>(SIDE);
    const EnvironmentLight::Sample sample = light.sample(u);
    const float pdf = light.pdf(sample.direction);
    // Directions on the edge of a texel may be found in the next one.
    if (std::abs(pdf - sample.pdf) > 1e-3f * sample.pdf) continue;
    inSun += pdf > 3;  // an even map: 0.08
    const glm::vec3 whole = light.radiance(sample.direction), carried = light.radiance(sample);
    EXPECT_NEAR(carried.y, whole.y, 1e-3f * whole.y + 1e-5f);
    const std::array<glm::vec2, 2> us{glm::vec2(1) - u, u};
    light.sample(us, together.data());
    EXPECT_EQ(together[1].direction, sample.direction);
    EXPECT_EQ(together[1].pdf, sample.pdf);
  }
  EXPECT_GT(inSun, SIDE * SIDE / 20);
}

// Samples in squares are (cell + u) / side, which floats round to 1 where u is just below it.
TEST(EnvironmentLight, PlacesThatAreRoundedTo1LieInTheLastRowAndColumn) {
  const ImageF map = sunnyMap();
  const EnvironmentLight light(map, 0, 1);
  const float last = (1 + 0x1.fffffep-1f) / 2;
  ASSERT_EQ(last, 1);
  const EnvironmentLight::Sample sample = light.sample({last, last});
  EXPECT_GT(sample.pdf, 0);
  EXPECT_LT(sample.direction.y, -0.99f);
  EXPECT_NEAR(glm::length(sample.direction), 1, 1e-5f);
  EXPECT_EQ(sample.place.low, glm::ivec2(63, 31));
  EXPECT_NEAR(sample.pdf, light.pdf(sample.place), 1e-3f * sample.pdf);
}

TEST(EnvironmentLight, DrawsGiveTheIntegralOfTheMapWithoutBias) {
  const ImageF map = sunnyMap();
  const EnvironmentLight light(map, 37, 0.7);
  for (float glm::vec3::*channel : {&glm::vec3::x, &glm::vec3::z}) {
    const auto [mean, error] = estimate(light, 200000, [&](const glm::vec3& d) { return light.radiance(d).*channel; });
    EXPECT_NEAR(mean, quadrature(light, channel), 3 * error + 1e-3 * mean);
  }
}

TEST(EnvironmentLight, PdfIsOneWhole) {
  const ImageF map = sunnyMap();
  const EnvironmentLight light(map, 0, 1);
  Random random(4, 0, 0);
  double sum = 0, squares = 0;
  constexpr int COUNT = 400000;
  for (int i = 0; i < COUNT; ++i) {
    const double x = light.pdf(sampleSphere(random.uniform2())) / PDF_SPHERE;
    sum += x, squares += x * x;
  }
  const double mean = sum / COUNT;
  EXPECT_NEAR(mean, 1, 3 * std::sqrt((squares / COUNT - mean * mean) / COUNT));
}

TEST(EnvironmentLight, RotationTurnsTheMap) {
  const ImageF map = sunnyMap();
  const EnvironmentLight still(map, 0, 1), turned(map, 90, 1);
  // A turn of 90 degrees about +Y takes +X to -Z.
  const glm::vec3 d = glm::normalize(glm::vec3(0.6f, 0.3f, -0.2f)), e(d.z, d.y, -d.x);
  EXPECT_NEAR(still.radiance(d).x, turned.radiance(e).x, 1e-5f);
}

TEST(EnvironmentLight, ABlackMapIsDrawnFromEvenly) {
  const ImageF map{4, 2, std::vector<float>(4 * 2 * 4, 0.0f)};
  const EnvironmentLight light(map, 0, 1);
  const auto [direction, pdf, place] = light.sample({0.3f, 0.9f});
  EXPECT_NEAR(glm::length(direction), 1, 1e-5f);
  EXPECT_GT(pdf, 0);
  EXPECT_EQ(light.radiance(direction), glm::vec3(0));
}

}  // namespace
}  // namespace telar::reference
