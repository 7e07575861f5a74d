#include "ibl/suns.h"

#include <gtest/gtest.h>

#include "ibl/equirect_grid.h"
#include "telar/codec.h"
#include "telar/luminance.h"

namespace telar::ibl::suns_test {
namespace {

constexpr std::uint32_t WIDTH = 128, HEIGHT = 64;
constexpr EquirectGrid GRID{WIDTH, HEIGHT};

ImageF skyOf(float radiance) { return {WIDTH, HEIGHT, std::vector<float>(std::size_t{WIDTH} * HEIGHT * 4, radiance)}; }

void setTexel(ImageF& map, std::uint32_t x, std::uint32_t y, const glm::vec3& radiance) {
  for (int c = 0; c < 3; ++c) map.pixels[(std::size_t{y} * WIDTH + x) * 4 + std::size_t(c)] = radiance[c];
}

TEST(Suns, HoldWhatHalvesDoNot) {
  ImageF map = skyOf(1);
  setTexel(map, 100, 12, {1e6f, 5e5f, 1000});
  const Suns suns = sunsOf(map);
  ASSERT_EQ(suns.list.size(), 1u);
  const Suns::Sun& sun = suns.list.front();
  EXPECT_NEAR(glm::length(sun.direction - GRID.direction(100, 12)), 0, 1e-12);
  const double angle = GRID.solidAngle(12);
  EXPECT_NEAR(sun.irradiance.r, (1e6 - HALF_MAX) * angle, 1e-9 * sun.irradiance.r);
  EXPECT_NEAR(sun.irradiance.g, (5e5 - HALF_MAX) * angle, 1e-9 * sun.irradiance.r);
  EXPECT_EQ(sun.irradiance.b, 0) << "as much as a half holds stays in the map";
  const double whole = luminance(glm::dvec3(1e6, 5e5, 1000)) * angle + 4 * glm::pi<double>() - angle;
  EXPECT_NEAR(suns.share, luminance(sun.irradiance) / whole, 1e-6);
}

TEST(Suns, AreSmallLightsThatLeaveTheMap) {
  ImageF map = skyOf(1);
  for (const std::uint32_t x : {100u, 101u}) setTexel(map, x, 12, {9000, 6000, 3000});
  const ImageF whole = map;
  const auto light = [](const ImageF& of) {
    glm::dvec3 sum(0);
    for (std::uint32_t y = 0; y < HEIGHT; ++y) {
      for (std::uint32_t x = 0; x < WIDTH; ++x) {
        for (int c = 0; c < 3; ++c)
          sum[c] += of.pixels[(std::size_t{y} * WIDTH + x) * 4 + std::size_t(c)] * GRID.solidAngle(y);
      }
    }
    return sum;
  };
  EXPECT_TRUE(sunsOf(map).list.empty());
  const Suns suns = takeSuns(map);
  ASSERT_EQ(suns.list.size(), 1u);
  const Suns::Sun& sun = suns.list.front();
  EXPECT_NEAR(glm::length(sun.direction - glm::normalize(GRID.direction(100, 12) + GRID.direction(101, 12))), 0, 1e-9);
  // No light is lost, and what is left of it is a hundred times the mean at the most.
  const glm::dvec3 expected = light(whole);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sun.irradiance[c] + light(map)[c], expected[c], 1e-6 * expected[c]);
  const float left = map.pixels[(std::size_t{12} * WIDTH + 100) * 4 + 1];
  EXPECT_NEAR(left,
              100 * luminance(expected) / (4 * glm::pi<double>()) * 6000 / luminance(glm::dvec3(9000, 6000, 3000)),
              1e-3 * left);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i) changed += map.pixels[i] != whole.pixels[i];
  EXPECT_EQ(changed, 6u);
}

TEST(Suns, OfManySmallLightsAreNone) {
  ImageF map = skyOf(0);
  for (std::uint32_t x = 0; x < 80; x += 20) setTexel(map, x, 30, glm::vec3(5e4f));
  const ImageF whole = map;
  EXPECT_TRUE(takeSuns(map).list.empty());
  EXPECT_EQ(map.pixels, whole.pixels);
}

TEST(Suns, OfAMapThatHalvesHoldAreNone) {
  for (const float radiance : {0.0f, 1.0f, HALF_MAX}) {
    const Suns suns = sunsOf(skyOf(radiance));
    EXPECT_TRUE(suns.list.empty()) << radiance;
    EXPECT_EQ(suns.share, 0) << radiance;
  }
}

TEST(Suns, ThatLieCloseTogetherAreOne) {
  // The texels of a real sun, across the seam of the map, and another one far from it.
  ImageF map = skyOf(0);
  for (const std::uint32_t x : {WIDTH - 1, 0u}) {
    for (const std::uint32_t y : {20u, 21u}) setTexel(map, x, y, glm::vec3(2e5f));
  }
  setTexel(map, 60, 40, glm::vec3(1e5f));
  const Suns suns = sunsOf(map);
  ASSERT_EQ(suns.list.size(), 2u);
  const glm::dvec3 middle(-std::sin(GRID.polar(21)), std::cos(GRID.polar(21)), 0);
  EXPECT_LT(glm::length(suns.list[0].direction - middle), 0.01);
  EXPECT_NEAR(glm::length(suns.list[0].direction), 1, 1e-12);
  EXPECT_NEAR(suns.list[1].irradiance.r, (1e5 - HALF_MAX) * GRID.solidAngle(40), 1e-6);
}

TEST(Suns, HoweverManyAreFewAndKeepTheirLight) {
  for (const bool everywhere : {false, true}) {
    ImageF map = skyOf(everywhere ? 1e5f : 0.0f);
    if (!everywhere) {
      for (std::uint32_t x = 0; x < WIDTH; x += 4) setTexel(map, x, (x * 7) % HEIGHT, glm::vec3(1e7f));
    }
    double light = 0, expected = 0;
    for (std::uint32_t y = 0; y < HEIGHT; ++y) {
      for (std::uint32_t x = 0; x < WIDTH; ++x)
        expected += std::max(map.pixels[(std::size_t{y} * WIDTH + x) * 4] - double(HALF_MAX), 0.0) * GRID.solidAngle(y);
    }
    const Suns suns = sunsOf(map);
    for (const Suns::Sun& sun : suns.list) {
      light += sun.irradiance.r;
      EXPECT_NEAR(glm::length(sun.direction), 1, 1e-9);
    }
    EXPECT_LE(suns.list.size(), Suns::MOST);
    EXPECT_GE(suns.list.size(), 2u);
    EXPECT_NEAR(light, expected, 1e-9 * expected);
  }
}

}  // namespace
}  // namespace telar::ibl::suns_test
