// White furnace: a white dielectric under an environment of radiance 1 must send back 1 in every direction.
#include <gtest/gtest.h>

#include <fstream>

#include "ibl/prefilter.h"
#include "renderer/scenes.h"

namespace telar {
namespace {

/// A Radiance .hdr of 1 everywhere, as bytes: mantissa 255 and exponent 128 decode to exactly 1 by three.js's rule.
std::vector<std::byte> constantEnvironment() {
  constexpr int WIDTH = 64, HEIGHT = 32;
  std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
  for (int i = 0; i < WIDTH * HEIGHT; ++i) file += std::string("\xff\xff\xff\x80", 4);
  const auto* bytes = reinterpret_cast<const std::byte*>(file.data());
  return {bytes, bytes + file.size()};
}

class Furnace : public testing::TestWithParam<int> {};

TEST_P(Furnace, WhiteDielectricReflectsOneAwayFromTheSilhouette) {
  Material material;
  material.metallicFactor = 0;
  material.roughnessFactor = static_cast<float>(GetParam()) / 10.0f;
  Shot shot = test::shotOf(128);
  shot.output.bitDepth = 32;
  shot.environment.source = Shot::Environment::Source::kBytes;
  const auto renderer = Renderer::create({});
  FrameInfo info;
  const Frame frame = renderer->draw(test::sceneOf(test::spherePrimitive(1), material), shot, constantEnvironment(),
                                     CancelToken(), info);
  ASSERT_EQ(frame.type, PixelType::kRgbaF32);
  const double radiusPx = 128 / (2 * std::tan(glm::radians(15.0)) * 5) * 1.0;
  int checked = 0;
  for (std::uint32_t y = 0; y < 128; ++y) {
    for (std::uint32_t x = 0; x < 128; ++x) {
      if (std::hypot(x - 63.5, y - 63.5) > radiusPx - 3) continue;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(test::pixelF(frame, x, y)[c], 1.0f, 0.005f) << "at " << x << ", " << y;
      ++checked;
    }
  }
  EXPECT_GT(checked, 5000);
}

INSTANTIATE_TEST_SUITE_P(Roughness, Furnace, testing::Range(0, 11));

}  // namespace
}  // namespace telar
