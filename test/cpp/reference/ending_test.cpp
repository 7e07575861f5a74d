#include <gtest/gtest.h>

#include "reference/tracer.h"
#include "renderer/scenes.h"

// Pictures that end before their last path: when they are enough as they are.

namespace telar::reference::ending_test {
namespace {

/// Brighter from texel to texel, so that paths differ.
ImageF sky() {
  ImageF map{8, 4, std::vector<float>(8 * 4 * 4, 1)};
  for (std::size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = i % 4 == 3 ? 1 : static_cast<float>(i % 23) / 8;
  return map;
}

std::shared_ptr<Scene> ball() {
  Material material;
  material.metallicFactor = 0;
  material.roughnessFactor = 0.5f;
  return test::sceneOf(test::spherePrimitive(1, 16), material);
}

struct Traced {
  std::vector<glm::vec4> pixels;
  TraceFacts facts;
};

Traced traced(double noise, int samples, int threads, const Progress& progress) {
  const ImageF map = sky();
  Shot shot = test::shotOf(16);
  shot.noise = noise;
  Traced out;
  out.pixels = traceRadiance(*ball(), shot, &map, {.samples = samples, .threads = threads}, Limits(), CancelToken(),
                             progress, &out.facts);
  return out;
}

// Rounds are followed in steps where time may end them: the sums are the same.
TEST(Ending, AnAllowedTimeChangesNothingUntilItIsSpent) {
  for (const double noise : {0.0, 2.0}) {
    const Progress ample, spent;
    ample.allowCpu(1e9);
    spent.allowCpu(1e-6);
    const Traced free = traced(noise, 96, 2, {}), allowed = traced(noise, 96, 2, ample);
    EXPECT_TRUE(allowed.pixels == free.pixels);
    EXPECT_EQ(allowed.facts.samples, free.facts.samples);
    EXPECT_FALSE(allowed.facts.end.early || free.facts.end.early);
    const Traced ended = traced(noise, 96, 2, spent);
    EXPECT_TRUE(ended.facts.end.early);
    EXPECT_EQ(ended.facts.samples, 1) << "one path at least";
    EXPECT_GT(ended.pixels[16 * 8 + 8].y, 0);
  }
}

TEST(Ending, AnAllowedErrorEndsAtTheSameSampleWithAnyThreads) {
  const auto draw = [](double error, int threads) {
    const Progress progress;
    progress.allowError(error);
    return traced(0.2, 1024, threads, progress);
  };
  const Traced one = draw(4, 1), four = draw(4, 4), exact = draw(1e-9, 4), rough = draw(8, 4);
  EXPECT_TRUE(one.pixels == four.pixels);
  EXPECT_EQ(one.facts.samples, four.facts.samples);
  EXPECT_TRUE(one.facts.end.early);
  EXPECT_LE(one.facts.end.standardError, 4.0);
  EXPECT_GT(exact.facts.samples, one.facts.samples);
  EXPECT_LT(rough.facts.samples, one.facts.samples) << "a larger error is reached sooner";
  EXPECT_GE(rough.facts.samples, 16);
}

}  // namespace
}  // namespace telar::reference::ending_test
