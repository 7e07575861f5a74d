#include "ibl/octahedral_map.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "ibl/cubes.h"
#include "ibl/irradiance.h"

namespace telar::ibl::octahedral_map_test {
namespace {

using test::gradient;
using test::half;

/// Texels of a level, row by row.
std::vector<glm::vec3> texelsOf(const gl::Context& context, const OctahedralMap& map, int level = 0) {
  const auto rgba = test::halfs(context, GL_TEXTURE_2D, map.texture, level, map.size >> level);
  std::vector<glm::vec3> texels;
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    texels.emplace_back(half(rgba[i]), half(rgba[i + 1]), half(rgba[i + 2]));
  return texels;
}

/// Another light towards each axis: 2 + direction.
ImageF directions(std::uint32_t width) {
  ImageF map{width, width / 2, {}};
  for (std::uint32_t y = 0; y < map.height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const double polar = (y + 0.5) / map.height * 3.14159265358979;
      const double phi = ((x + 0.5) / width - 0.5) * 2 * 3.14159265358979;
      for (const double of : {std::sin(polar) * std::cos(phi), std::cos(polar), std::sin(polar) * std::sin(phi)})
        map.pixels.push_back(static_cast<float>(2 + of));
      map.pixels.push_back(1);
    }
  }
  return map;
}

TEST(RadianceMap, ShowsTheMapInEachLevel) {
  const auto context = gl::Context::create(Backend::kAuto);
  const OctahedralMap map = radianceMap(*context, directions(512), CancelToken());
  ASSERT_EQ(map.size, 512);
  for (int level = 0; map.size >> level >= OctahedralMap::LEAST_SIZE; ++level) {
    const int size = map.size >> level;
    const auto texels = texelsOf(*context, map, level);
    // Half floats of up to 3 are 0.002 apart, and a GL may round down: three channels of the map, and of each level. The mean
    // over a texel is shorter than a direction, by about its angle squared.
    const double angle = 3.0 / (size - 2), tolerance = 0.0035 * (level + 2) + angle * angle;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const glm::vec3 off = texels[static_cast<std::size_t>(y * size + x)] - 2.0f - octahedralDirection(x, y, size);
        ASSERT_LT(glm::length(off), tolerance) << "level " << level << ", texel " << x << ", " << y;
      }
    }
  }
}

TEST(RadianceMap, GoesOnInTheGutterBesideEachEdge) {
  // A step of half floats in three channels, and of the map, whose first and last columns are not mixed.
  constexpr float TOLERANCE = 0.0035f + 6.3f / 1024;
  const auto context = gl::Context::create(Backend::kAuto);
  const OctahedralMap map = radianceMap(*context, directions(1024), CancelToken());
  for (int level = 0; map.size >> level >= OctahedralMap::LEAST_SIZE; ++level) {
    const int size = map.size >> level, last = size - 1;
    const auto texels = texelsOf(*context, map, level);
    const auto at = [&](int x, int y) { return texels[static_cast<std::size_t>(y * size + x)]; };
    for (int i = 1; i < last; ++i) {
      ASSERT_LT(glm::length(at(0, i) - at(1, last - i)), TOLERANCE) << "left, level " << level << ", row " << i;
      ASSERT_LT(glm::length(at(last, i) - at(last - 1, last - i)), TOLERANCE)
          << "right, level " << level << ", row " << i;
      ASSERT_LT(glm::length(at(i, 0) - at(last - i, 1)), TOLERANCE) << "below, level " << level << ", column " << i;
      ASSERT_LT(glm::length(at(i, last) - at(last - i, last - 1)), TOLERANCE)
          << "above, level " << level << ", column " << i;
    }
  }
}

TEST(RadianceMap, IsHalfAsWideAsALargeMap) {
  const auto context = gl::Context::create(Backend::kAuto);
  EXPECT_EQ(radianceMap(*context, gradient(2048), CancelToken()).size, 1024);
  EXPECT_EQ(radianceMap(*context, gradient(3000), CancelToken()).size, 1024);
  EXPECT_EQ(radianceMap(*context, gradient(16), CancelToken()).size, 512);
}

TEST(RadianceMap, CanBeStopped) {
  const auto context = gl::Context::create(Backend::kAuto);
  const CancelToken cancelled;
  cancelled.cancel();
  EXPECT_ERROR(radianceMap(*context, gradient(64), cancelled), "X_CANCELLED");
}

/// What irradianceMap() has for a map, against a formula of the unit normal.
template <class Formula>
void expectIrradiance(const ImageF& map, const Formula& expected, double tolerance) {
  const auto context = gl::Context::create(Backend::kAuto);
  const OctahedralMap irradiance = irradianceMap(*context, map, CancelToken());
  const int size = irradiance.size;
  const auto texels = texelsOf(*context, irradiance);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::vec3 n = octahedralDirection(x, y, size);
      ASSERT_NEAR(texels[static_cast<std::size_t>(y * size + x)].x, expected(n), tolerance)
          << "texel " << x << ", " << y;
    }
  }
}

TEST(Irradiance, IsTheCosineMeanOfTheMap) {
  expectIrradiance(
      gradient(256), [](const glm::vec3& n) { return 1 + 0.8 * 2 / 3 * n.y; }, 1.5e-3);
}

TEST(Irradiance, OfOneTexelFallsAsItsCosineAndIsNothingBehindIt) {
  ImageF map{128, 64, std::vector<float>(128 * 64 * 4)};
  constexpr std::uint32_t X = 32, Y = 31;  // towards -Z, just above the horizon
  map.pixels[(Y * map.width + X) * 4] = 1000;
  const double phi = ((X + 0.5) / 128 - 0.5) * 2 * 3.14159265358979, polar = (Y + 0.5) / 64 * 3.14159265358979;
  const glm::vec3 lamp(std::sin(polar) * std::cos(phi), std::cos(polar), std::sin(polar) * std::sin(phi));
  const double angle = 2 * 3.14159265358979 / 128 *
                       (std::cos(polar - 3.14159265358979 / 128) - std::cos(polar + 3.14159265358979 / 128));
  expectIrradiance(
      map, [&](const glm::vec3& n) { return 1000 * angle / 3.14159265358979 * std::max(glm::dot(n, lamp), 0.0f); },
      2e-3);
}

}  // namespace
}  // namespace telar::ibl::octahedral_map_test
