#include <gtest/gtest.h>

#include "ibl/cubes.h"
#include "ibl/prefilter.h"

// quality.environmentSize and quality.prefilterSamples.

namespace telar::ibl::prefilter_settings_test {
namespace {

using test::gradient;
using test::half;
using test::level;

/// Dark but for one bright texel.
ImageF lamp(std::uint32_t width) {
  ImageF map = gradient(width);
  for (std::size_t c = 0; c < 3; ++c) map.pixels[(std::size_t{width} * (width / 8) + width / 3) * 4 + c] = 5000;
  return map;
}

TEST(Prefilter, FaceSizeAndSamplesAreThoseOfTheSettings) {
  const auto context = gl::Context::create(Backend::kAuto);
  const auto made = [&](const PrefilterSettings& settings) {
    return prefilterEquirect(*context, gradient(512), CancelToken(), settings);
  };
  const CubeMap usual = made({}), same = made({256, 256}), small = made({64, 256}), large = made({512, 256});
  EXPECT_EQ(usual.faceSize, 256);
  EXPECT_EQ(small.faceSize, 64);
  EXPECT_EQ(maxLodOf(small), 3);
  EXPECT_EQ(large.faceSize, 512);
  for (int lod = 0; lod < usual.levels; ++lod) {
    EXPECT_EQ(level(*context, usual, lod, GL_TEXTURE_CUBE_MAP_POSITIVE_Y),
              level(*context, same, lod, GL_TEXTURE_CUBE_MAP_POSITIVE_Y));
  }
  // The sharpest and the roughest level show the same light at any size: a texel near the pole, and the cosine mean.
  const auto at = [&](const CubeMap& cube, int lod) {
    const auto texels = level(*context, cube, lod, GL_TEXTURE_CUBE_MAP_POSITIVE_Y);
    const int side = cube.faceSize >> lod;
    return half(texels[static_cast<std::size_t>((side / 2 - 1) * side + side / 2 - 1) * 4]);
  };
  for (const CubeMap* other : {&small, &large}) {
    EXPECT_NEAR(at(*other, 0), at(usual, 0), 0.005);
    EXPECT_NEAR(at(*other, maxLodOf(*other)), at(usual, maxLodOf(usual)), 0.005);
  }
}

TEST(Prefilter, TheSharpestLevelOfASmallCubeIsAMeanOfTheMap) {
  const auto context = gl::Context::create(Backend::kAuto);
  const auto brightest = [&](int faceSize) {
    const CubeMap cube = prefilterEquirect(*context, lamp(512), CancelToken(), {faceSize, 16});
    float most = 0;
    for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face < GL_TEXTURE_CUBE_MAP_POSITIVE_X + 6; ++face) {
      const auto texels = level(*context, cube, 0, face);
      for (std::size_t i = 0; i < texels.size(); i += 4) most = std::max(most, half(texels[i]));
    }
    return most;
  };
  // A texel of a quarter of the width has a sixteenth of the lamp, less or more by the edge that it lies at.
  const float whole = brightest(256), quarter = brightest(64);
  EXPECT_GT(quarter, whole / 64);
  EXPECT_LT(quarter, whole / 4);
}

TEST(Prefilter, MoreSamplesLeaveLessNoise) {
  const auto context = gl::Context::create(Backend::kAuto);
  const auto sharp = [&](int samples) {
    return level(*context, prefilterEquirect(*context, lamp(256), CancelToken(), {128, samples}), 1,
                 GL_TEXTURE_CUBE_MAP_POSITIVE_Y);
  };
  const auto truth = sharp(4096), few = sharp(16), more = sharp(1024);
  const auto distance = [&](const std::vector<std::uint16_t>& texels) {
    double sum = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) sum += std::abs(half(texels[i]) - half(truth[i]));
    return sum;
  };
  EXPECT_GT(distance(more), 0) << "the number is read";
  EXPECT_LT(distance(more), distance(few) / 2);
}

}  // namespace
}  // namespace telar::ibl::prefilter_settings_test
