#include <gtest/gtest.h>

#include <cmath>

#include "frame/covered_pixels.h"
#include "renderer/scenes.h"
#include "telar/reference.h"

/// Who draws quality "high": by counts, and only where both show the same.
namespace telar {
namespace {

constexpr std::uint64_t MANY = 100'000;
constexpr double PI = glm::pi<double>();

Shot highShot(int size = 16) {
  Shot shot = test::shotOf(size);
  shot.isHigh = true;
  shot.shading = ShadingModel::kFabric;
  shot.samples = 1024;
  shot.resolve = Resolve::kLinear;
  shot.noise = 2;
  shot.environmentSamples = 2048;
  shot.denoise = true;
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
  EXPECT_EQ(traced->noise, 1) << "it is not denoised";
  EXPECT_FALSE(traced->lens) << "the raster shows everything sharp";
}

TEST(TracedInstead, FewTrianglesOnManyPixelsAreRastered) {
  EXPECT_FALSE(tracedInstead(*sceneWith(MANY), highShot(4096)));
  EXPECT_FALSE(tracedInstead(*sceneWith(2), highShot()));
}

TEST(TracedInstead, PixelsCountThatTheModelCovers) {
  Shot shot = highShot(1024);
  EXPECT_DOUBLE_EQ(frame::coveredPixels(*sceneWith(2), shot), 1024.0 * 1024) << "no more than there are";
  EXPECT_FALSE(tracedInstead(*sceneWith(MANY), shot));
  shot.camera.position.z = 600;  // the square of 4 m is 16 m^2 of (2 * 600 m * tan 15 degrees)^2
  const double height = 1200 * std::tan(glm::radians(15.0));
  EXPECT_NEAR(frame::coveredPixels(*sceneWith(2), shot), 1024.0 * 1024 * 16 / (height * height), 1);
  EXPECT_TRUE(tracedInstead(*sceneWith(MANY), shot)) << "a small model in a large picture";
  shot.camera.position.z = -1;
  shot.camera.target = {0, 0, -2};
  EXPECT_DOUBLE_EQ(frame::coveredPixels(*sceneWith(2), shot), 1024.0 * 1024) << "behind the camera nothing is known";
}

TEST(TracedInstead, ClosedModelsCountOnceAndInstancesEach) {
  const Shot shot = highShot(128);
  auto ball = test::sceneOf(test::spherePrimitive(0.5f));
  const double one = frame::coveredPixels(*ball, shot);
  const double radius = 128 * 0.5 / (10 * std::tan(glm::radians(15.0)));
  EXPECT_NEAR(one, PI * radius * radius, 0.03 * one);
  auto instances = std::make_shared<Instances>();
  instances->matrices.assign(3, glm::mat4(1));
  ball->nodes[0].instances = instances;
  EXPECT_NEAR(frame::coveredPixels(*ball, shot), 3 * one, 1e-6 * one);
}

TEST(TracedInstead, WhatLetsLightThroughCostsMore) {
  const auto traces = [](AlphaMode mode, int size) {
    Material material;
    material.alphaMode = mode;
    return tracedInstead(*sceneWith(9000, material), highShot(size)).has_value();
  };
  EXPECT_TRUE(traces(AlphaMode::kOpaque, 8));
  EXPECT_TRUE(traces(AlphaMode::kBlend, 8));
  EXPECT_TRUE(traces(AlphaMode::kMask, 24)) << "nets take all passes of the raster";
  EXPECT_FALSE(traces(AlphaMode::kOpaque, 24));
  EXPECT_FALSE(traces(AlphaMode::kBlend, 24));
}

TEST(TracedInstead, NetsOfLargeTrianglesAreRastered) {
  Material net;
  net.alphaMode = AlphaMode::kMask;
  for (const int size : {32, 128}) {
    EXPECT_FALSE(tracedInstead(*sceneWith(2, net), highShot(size))) << size;
    EXPECT_TRUE(tracedInstead(*sceneWith(60'000, net), highShot(size))) << size;
  }
}

TEST(TracedInstead, PassesThatAreNotDenoisedAreMore) {
  const auto traced = [](bool denoise) {
    Shot shot = highShot(24);
    shot.denoise = denoise;
    return tracedInstead(*sceneWith(9000), shot);
  };
  EXPECT_FALSE(traced(true));
  const auto plain = traced(false);
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->noise, 2) << "both end at the same noise";
}

TEST(TracedInstead, OtherShadingsAreTracedWhereTheyAreLitTheSame) {
  const auto scene = sceneWith(MANY);
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kThreeR115, ShadingModel::kDisney2012}) {
    const auto traces = [&](auto change) {
      Shot shot = highShot();
      shot.shading = shading;
      shot.environment.source = Shot::Environment::Source::kStudio;
      change(shot);
      return tracedInstead(*scene, shot).has_value();
    };
    using Light = Shot::Light;
    EXPECT_TRUE(traces([](Shot&) {}));
    EXPECT_TRUE(traces([](Shot& shot) { shot.lights = {Light{Light::Type::kPoint}}; }));
    EXPECT_FALSE(traces([](Shot& shot) { shot.lights = {Light{Light::Type::kRect}}; }));
    EXPECT_FALSE(traces([](Shot& shot) {
      shot.lights = {Light{Light::Type::kSpot}};
      shot.lights[0].castShadow = true;
    }));
    const bool three = shading == ShadingModel::kThree;
    EXPECT_EQ(traces([](Shot& shot) { shot.environment.source = Shot::Environment::Source::kBytes; }), !three);
    EXPECT_EQ(traces([](Shot& shot) { shot.three.lineMap = ThreeTerms::THREE_LINE_MAP_NONE; }), !three);
    Material veil;
    veil.alphaMode = AlphaMode::kBlend;
    Shot shot = highShot(8);
    EXPECT_TRUE(tracedInstead(*sceneWith(MANY, veil), shot));
    shot.shading = shading;
    EXPECT_FALSE(tracedInstead(*sceneWith(MANY, veil), shot)) << "a browser sorts it";
  }
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

  auto blocks = sceneWith(MANY);
  Image8 image;
  image.type = TexelType::kBlocks;
  blocks->images = {image};
  EXPECT_FALSE(tracedInstead(*blocks, highShot()));
  EXPECT_FALSE(isTraceable(*blocks, highShot())) << "quality \"reference\" refuses them";

  const auto seenThrough = [&](float opacity) {
    return traces([opacity](Shot& shot) { shot.ghost.push_back({.part = {}, .opacity = opacity}); });
  };
  EXPECT_FALSE(seenThrough(0.25f)) << "the raster's casts no shadow";
  EXPECT_TRUE(seenThrough(0)) << "it is left out";
  EXPECT_TRUE(seenThrough(1));
}

}  // namespace
}  // namespace telar
