#include "ibl/bright_directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "telar/luminance.h"

/// What is drawn from a map by itself and what stays in it are together the map.
namespace telar::ibl::bright_directions_test {
namespace {

constexpr std::uint32_t WIDTH = 128, HEIGHT = 64;
constexpr std::uint32_t SUN_X = 100, SUN_Y = 12;
constexpr int MOST = 2048;
constexpr float HALF_MAX = 65504;

ImageF mapOf(const std::function<glm::vec3(std::uint32_t x, std::uint32_t y)>& radiance) {
  ImageF map{WIDTH, HEIGHT, {}};
  for (std::uint32_t y = 0; y < HEIGHT; ++y) {
    for (std::uint32_t x = 0; x < WIDTH; ++x) {
      const glm::vec3 c = radiance(x, y);
      map.pixels.insert(map.pixels.end(), {c.r, c.g, c.b, 1});
    }
  }
  return map;
}

/// Sky, a wide lamp and, where it is asked for, a sun of one texel.
ImageF lampAndSun(float sun) {
  return mapOf([&](std::uint32_t x, std::uint32_t y) {
    if (x == SUN_X && y == SUN_Y) return glm::vec3(sun, sun, sun * 0.9f);
    const bool lamp = x >= 20 && x < 44 && y >= 24 && y < 40;
    return lamp ? glm::vec3(60, 50, 40) : glm::vec3(0.3f, 0.4f, 0.5f) * (1 + 0.01f * static_cast<float>(y));
  });
}

double solidAngle(std::uint32_t y) {
  const double row = glm::pi<double>() / HEIGHT;
  return glm::two_pi<double>() / WIDTH * (std::cos(row * y) - std::cos(row * (y + 1)));
}

glm::vec4 texel(const ImageF& map, std::uint32_t x, std::uint32_t y) {
  const float* p = &map.pixels[(static_cast<std::size_t>(y) * map.width + x) * 4];
  return {p[0], p[1], p[2], p[3]};
}

/// Of luminance, or of alpha.
double integral(const ImageF& map, bool alpha = false) {
  double sum = 0;
  for (std::uint32_t y = 0; y < HEIGHT; ++y) {
    for (std::uint32_t x = 0; x < WIDTH; ++x) {
      const glm::vec4 value = texel(map, x, y);
      sum += (alpha ? value.a : luminance(glm::vec3(value))) * solidAngle(y);
    }
  }
  return sum;
}

bool isCompact(const BrightDirections::Direction& d) { return d.density == BrightDirections::COMPACT; }

TEST(BrightDirections, WhatIsTakenOutAndWhatStaysAreTheMap) {
  for (const float sun : {1.0f, 1e4f, 1e6f}) {
    ImageF map = lampAndSun(sun);
    const double whole = integral(map);
    const BrightDirections bright(map);
    double taken = 0;
    for (const auto& d : bright.directions(MOST)) taken += isCompact(d) ? luminance(d.irradiance) : 0;
    // Directions stand for equal parts: at each end of what is compact one may count for what is not.
    const double tolerance = 0.01 * bright.energy();
    EXPECT_NEAR(integral(map) + taken, whole, tolerance) << sun;
    EXPECT_NEAR(integral(map, true) + taken, bright.energy(), tolerance) << sun;
    EXPECT_LT(bright.energy(), whole);
  }
}

TEST(BrightDirections, TogetherAreTheWholeExcess) {
  ImageF map = lampAndSun(1e4f);
  const BrightDirections bright(map);
  for (const int count : {1, 7, 32, MOST}) {
    const auto list = bright.directions(count);
    ASSERT_EQ(list.size(), static_cast<std::size_t>(count));
    double sum = 0;
    for (const auto& d : list) sum += luminance(d.irradiance);
    EXPECT_NEAR(sum, bright.energy(), 1e-5 * bright.energy()) << count;
  }
}

TEST(BrightDirections, AreAsDenseAsTheExcessThere) {
  ImageF map = lampAndSun(1);
  const BrightDirections bright(map);
  int spread = 0;
  for (const auto& d : bright.directions(256)) {
    EXPECT_NEAR(glm::length(d.direction), 1, 1e-6);
    if (isCompact(d)) continue;  // a corner of the lamp
    ++spread;
    const double u = std::atan2(d.direction.z, d.direction.x) / glm::two_pi<double>() + 0.5;
    const double v = std::acos(d.direction.y) / glm::pi<double>();
    const float excess = texel(map, static_cast<std::uint32_t>(u * WIDTH), static_cast<std::uint32_t>(v * HEIGHT)).a;
    EXPECT_GT(excess, 0);
    EXPECT_NEAR(d.density * luminance(d.irradiance), excess, 1e-4f * excess);
  }
  EXPECT_GT(spread, 200);
}

TEST(BrightDirections, OfASunOfOneTexelAreItsOwn) {
  ImageF map =
      mapOf([](std::uint32_t x, std::uint32_t y) { return glm::vec3(x == SUN_X && y == SUN_Y ? 1.6e9f : 0.5f); });
  const double whole = integral(map);
  const BrightDirections bright(map);
  const double phi = ((SUN_X + 0.5) / WIDTH - 0.5) * glm::two_pi<double>(),
               theta = (SUN_Y + 0.5) / HEIGHT * glm::pi<double>();
  const glm::vec3 sun(glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)));
  for (const auto& d : bright.directions(32)) {
    EXPECT_TRUE(isCompact(d));
    EXPECT_LT(glm::distance(d.direction, sun), 1e-6f);
  }
  EXPECT_EQ(integral(map, true), 0) << "nothing of it is left to be found";
  EXPECT_NEAR(bright.energy() + integral(map), whole, 1e-5 * whole);
  EXPECT_NEAR(texel(map, SUN_X, SUN_Y).r, HALF_MAX, 1) << "the map that stays is one of halves";
}

TEST(BrightDirections, TakeOutAllThatNoHalfHoldsHoweverWide) {
  ImageF map = mapOf(
      [](std::uint32_t x, std::uint32_t y) { return glm::vec3(x >= 20 && x < 80 && y >= 10 && y < 50 ? 1e6f : 0.5f); });
  const double whole = integral(map);
  const BrightDirections bright(map);
  for (const auto& d : bright.directions(32)) EXPECT_TRUE(isCompact(d));
  EXPECT_NEAR(bright.energy() + integral(map), whole, 1e-5 * whole);
  for (const float value : map.pixels) ASSERT_LE(value, HALF_MAX + 1);
}

TEST(BrightDirections, OfAPassAreApartFromThoseOfTheOthers) {
  ImageF map = lampAndSun(1e4f);
  const BrightDirections bright(map);
  const auto all = bright.directions(64);
  std::size_t count = 0;
  for (int pass = 0; pass < 16; ++pass) {
    const auto own = bright.directions(64, pass, 16);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto& same = all[static_cast<std::size_t>(pass) + 16 * i];
      EXPECT_TRUE(own[i].direction == same.direction && own[i].irradiance == same.irradiance);
    }
    count += own.size();
  }
  EXPECT_EQ(count, all.size());
}

TEST(BrightDirections, OfAnEvenOrABlackMapAreNone) {
  for (const float radiance : {3.0f, 0.0f}) {
    ImageF map = mapOf([&](std::uint32_t, std::uint32_t) { return glm::vec3(radiance); });
    const BrightDirections bright(map);
    EXPECT_EQ(bright.energy(), 0);
    EXPECT_TRUE(bright.directions(32).empty());
    for (std::size_t i = 0; i < map.pixels.size(); ++i) ASSERT_EQ(map.pixels[i], i % 4 == 3 ? 0 : radiance);
  }
  EXPECT_TRUE(BrightDirections().directions(32).empty());
}

}  // namespace
}  // namespace telar::ibl::bright_directions_test
