#include <gtest/gtest.h>

#include "renderer/scenes.h"
#include "telar/reference.h"

/// Who draws quality "high": by counts, and only where both show the same.
namespace telar {
namespace {

constexpr std::uint64_t MANY = 100'000;

Shot highShot(int size = 64) {
  Shot shot = test::shotOf(size);
  shot.isHigh = true;
  shot.shading = ShadingModel::kFabric;
  shot.samples = 1024;
  shot.resolve = Resolve::kLinear;
  shot.noise = 1.25;
  shot.environmentSamples = 2048;
  return shot;
}

std::shared_ptr<Scene> sceneWith(std::uint64_t triangles, Material material = {}) {
  auto scene = test::sceneOf(test::stackedSquares(1), std::move(material));
  scene->triangleCount = triangles;
  return scene;
}

TEST(TracedInstead, ManyTrianglesOnFewPixelsAreTracedUntilTheyAreAsSure) {
  Shot shot = highShot();
  shot.lens.emplace().focusDistance = 1;
  const auto traced = tracedInstead(*sceneWith(MANY), shot);
  ASSERT_TRUE(traced && traced->reference);
  EXPECT_EQ(traced->reference->samples, 1024);
  EXPECT_EQ(traced->reference->transport, Shot::Reference::Transport::kDirect);
  EXPECT_EQ(traced->reference->bounces, 0);
  EXPECT_EQ(traced->noise, 1.25);
  EXPECT_FALSE(traced->lens) << "the raster shows everything sharp";
}

TEST(TracedInstead, FewTrianglesOnManyPixelsAreRastered) {
  EXPECT_FALSE(tracedInstead(*sceneWith(MANY), highShot(4096)));
  EXPECT_FALSE(tracedInstead(*sceneWith(2), highShot()));
}

TEST(TracedInstead, OnlyCommonGroundIsTraced) {
  const auto scene = sceneWith(MANY);
  const auto traces = [&](auto change) {
    Shot shot = highShot();
    change(shot);
    return tracedInstead(*scene, shot).has_value();
  };
  EXPECT_TRUE(traces([](Shot&) {}));
  EXPECT_FALSE(traces([](Shot& shot) { shot.isHigh = false; })) << "settings given one by one are the raster's";
  EXPECT_FALSE(traces([](Shot& shot) { shot.shading = ShadingModel::kThree; }));
  EXPECT_FALSE(traces([](Shot& shot) { shot.layers = {Layer::kDepth}; }));
  EXPECT_FALSE(traces([](Shot& shot) { shot.debugOutput = DebugOutput::kBaseColor; }));

  Material glass;
  glass.layers.transmissionFactor = 0.5f;
  EXPECT_FALSE(tracedInstead(*sceneWith(MANY, glass), highShot()));
  auto lines = sceneWith(MANY);
  Primitive strip = test::stackedSquares(1);
  strip.topology = Topology::kLines;
  lines->meshes.push_back({"strip", {strip}});
  EXPECT_FALSE(tracedInstead(*lines, highShot()));
}

}  // namespace
}  // namespace telar
