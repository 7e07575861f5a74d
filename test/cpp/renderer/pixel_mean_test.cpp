#include "frame/pixel_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/random.h"

/// The mean of passes, and when a pixel takes no more of them.
namespace telar::frame {
namespace {

constexpr int SIDE = 16;

Shot shotWith(double noise) {
  Shot shot;
  shot.width = shot.height = SIDE;
  shot.toneMapping = ToneMapping::kNone;
  shot.noise = noise;
  return shot;
}

template <class Pixel>
Frame frameOf(const Pixel& pixel) {
  Frame frame{SIDE, SIDE, PixelType::kRgbaF32, std::vector<std::byte>(SIDE * SIDE * sizeof(glm::vec4))};
  for (int i = 0; i < SIDE * SIDE; ++i) {
    const glm::vec4 value = pixel(i % SIDE, i / SIDE);
    std::memcpy(&frame.pixels[static_cast<std::size_t>(i) * sizeof value], &value, sizeof value);
  }
  return frame;
}

/// A pass in which the left half of the picture is sure and the right half is not.
Frame halfSure(std::uint32_t pass) {
  return frameOf([pass](int x, int y) {
    if (x < SIDE / 2) return glm::vec4(0.25f, 0.25f, 0.25f, 1);
    const float value = Random(pass, static_cast<std::uint32_t>(y * SIDE + x), 0).uniform() < 0.5f ? 0.0f : 1.0f;
    return glm::vec4(value, value, value, 1);
  });
}

TEST(PixelMean, WithoutNoiseToStopAtEveryPassCounts) {
  PixelMean mean(shotWith(0));
  for (int i = 0; i < 40; ++i) EXPECT_FALSE(mean.add(frameOf([i](int x, int) { return glm::vec4(x + i); })));
  EXPECT_TRUE(mean.settled().empty());
  EXPECT_FALSE(mean.allSettled());
  EXPECT_FLOAT_EQ(mean.mean()[3].x, 3 + 19.5f);
}

TEST(PixelMean, APassMayBeBelowZeroAndThePictureMayNot) {
  PixelMean mean(shotWith(0));
  mean.add(frameOf([](int x, int) { return glm::vec4(x == 0 ? -1.0f : -5.0f); }));
  mean.add(frameOf([](int, int) { return glm::vec4(3); }));
  EXPECT_FLOAT_EQ(mean.mean()[0].x, 1);
  EXPECT_FLOAT_EQ(mean.mean()[1].x, 0);
}

TEST(PixelMean, TellsTheStandardErrorOfThePixelsThatVary) {
  PixelMean mean(shotWith(0), true, true), unasked(shotWith(0));
  for (std::uint32_t i = 0; i < 64; ++i) {
    EXPECT_FALSE(mean.add(halfSure(i))) << "nothing settles";
    unasked.add(halfSure(i));
    EXPECT_EQ(std::isinf(mean.standardError()), i < 15) << i;
  }
  // A coin of 0 and 1: the mean of 64 has a standard error of 1 / 16 in linear light, |N(0, 1)| has a mean of 0.8. The
  // slope of sRGB at 0.5 is about 0.67.
  EXPECT_NEAR(mean.standardError(), 255 * 0.8 * 0.67 / 16, 2);
  EXPECT_TRUE(std::isinf(unasked.standardError()));
  EXPECT_TRUE(mean.settled().empty());
}

TEST(PixelMean, SettlesWhatIsSureAndLeavesTheRest) {
  PixelMean mean(shotWith(1));
  for (std::uint32_t i = 0; i < 15; ++i) EXPECT_FALSE(mean.add(halfSure(i)));
  EXPECT_TRUE(mean.add(halfSure(15)));
  // Next to what is unsure nobody is sure.
  EXPECT_EQ(mean.settled()[2], 255);
  EXPECT_EQ(mean.settled()[SIDE / 2 - 1], 0);
  EXPECT_EQ(mean.settled()[SIDE - 2], 0);
  EXPECT_FALSE(mean.allSettled());
  // A settled pixel keeps its picture, whatever is drawn there.
  for (std::uint32_t i = 16; i < 64; ++i) {
    const bool looked =
        mean.add(frameOf([](int x, int) { return x < SIDE / 2 ? glm::vec4(100) : glm::vec4(0.5f, 0.5f, 0.5f, 1); }));
    EXPECT_EQ(looked, i == 31 || i == 63);
  }
  EXPECT_FLOAT_EQ(mean.mean()[2].x, 0.25f);
  EXPECT_GT(mean.mean()[SIDE / 2 - 1].x, 50);
}

TEST(PixelMean, WithMoreNoiseAllowedAllIsSettledSooner) {
  const auto passesFor = [](double noise) {
    PixelMean mean(shotWith(noise));
    std::uint32_t i = 0;
    while (i < 4096 && !mean.allSettled()) mean.add(halfSure(i++));
    return i;
  };
  const std::uint32_t strict = passesFor(4), loose = passesFor(16);
  EXPECT_LT(loose, strict);
  EXPECT_LT(strict, 4096u);
}

TEST(PixelMean, CoverageCountsAsColourDoes) {
  PixelMean mean(shotWith(1));
  for (std::uint32_t i = 0; i < 16; ++i)
    mean.add(
        frameOf([i](int, int) { return glm::vec4(0, 0, 0, i < 8 ? 1 : 0); }));  // black cloth, seen half of the time
  EXPECT_EQ(mean.settled()[0], 0);
}

}  // namespace
}  // namespace telar::frame
