#include "pass/plan/simplified_draws.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/scenes.h"

// quality.geometryError: fewer triangles where that shows by less than so many pixels.

namespace telar::simplified_draws_test {
namespace {

using test::pixel8;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

struct Drawn {
  Frame frame;
  int triangles = 0;
  int glObjects = 0;
};

/// One after the other, by one renderer.
std::vector<Drawn> drawn(const std::shared_ptr<const Scene>& scene, const std::vector<Shot>& shots) {
  const auto renderer = Renderer::create({});
  std::vector<Drawn> out;
  for (const Shot& shot : shots) {
    FrameInfo info;
    Frame frame = renderer->draw(scene, shot, {}, {}, info);
    const auto json = nlohmann::json::parse(info.json);
    out.push_back({std::move(frame), json["triangles"], json["glObjects"]});
  }
  return out;
}

Shot litShot(double geometryError, int size = 64) {
  Shot shot = shotOf(size);
  shot.samples = 4;
  shot.geometryError = geometryError;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  return shot;
}

/// Pixels whose alpha says the opposite.
int turned(const Frame& a, const Frame& b) {
  int count = 0;
  for (std::size_t i = 3; i < a.pixels.size(); i += 4)
    count += std::abs(static_cast<int>(a.pixels[i]) - static_cast<int>(b.pixels[i])) > 127;
  return count;
}

constexpr int RINGS = 96, ALL = RINGS * RINGS * 4;

TEST(SimplifiedDraws, FewerTrianglesShowTheSameByTheError) {
  const auto scene = sceneOf(spherePrimitive(1, RINGS));
  const auto pictures = drawn(scene, {litShot(0), litShot(0.25), litShot(2), litShot(0)});
  EXPECT_EQ(pictures[0].triangles, ALL);
  EXPECT_LT(pictures[1].triangles, ALL / 4);
  EXPECT_LT(pictures[2].triangles, pictures[1].triangles / 2);
  EXPECT_GT(pictures[2].triangles, 20);
  EXPECT_EQ(turned(pictures[1].frame, pictures[0].frame), 0);
  EXPECT_FALSE(pictures[1].frame.pixels == pictures[0].frame.pixels);
  EXPECT_TRUE(pictures[3].frame.pixels == pictures[0].frame.pixels) << "all of them again";
}

TEST(SimplifiedDraws, ThePixelsAreThoseOfThePicture) {
  const auto scene = sceneOf(spherePrimitive(1, RINGS));
  const auto pictures = drawn(scene, {litShot(0.5, 32), litShot(0.5, 256)});
  EXPECT_LT(2 * pictures[0].triangles, pictures[1].triangles);
  auto large = sceneOf(spherePrimitive(1, RINGS));
  large->nodes[0].world = glm::dmat4(glm::dmat3(0.125));
  large->nodes[0].world[3].w = 1;
  large->bounds = {glm::dvec3(-0.125), glm::dvec3(0.125)};
  EXPECT_LT(drawn(large, {litShot(0.5, 256)})[0].triangles, pictures[1].triangles) << "it is drawn small";
}

TEST(SimplifiedDraws, NamesOfTheGlDoNotGrow) {
  const auto scene = sceneOf(spherePrimitive(1, RINGS));
  std::vector<Shot> shots;
  for (int i = 0; i < 3; ++i) {
    for (const double error : {0.125, 0.25, 0.5, 1.0, 2.0, 0.0}) shots.push_back(litShot(error));
  }
  const auto pictures = drawn(scene, shots);
  for (std::size_t i = 12; i < 18; ++i) {
    EXPECT_TRUE(pictures[i].frame.pixels == pictures[i - 6].frame.pixels) << i;
    EXPECT_EQ(pictures[i].glObjects, pictures[i - 6].glObjects) << i;
  }
}

TEST(SimplifiedDraws, WhatMovesAndWhatHasFewTrianglesStays) {
  auto primitive = spherePrimitive(1, RINGS);
  primitive.deformers = std::make_shared<Deformers>();
  EXPECT_EQ(drawn(sceneOf(primitive), {litShot(2)})[0].triangles, ALL);
  EXPECT_EQ(drawn(sceneOf(test::stackedSquares(1)), {litShot(2)})[0].triangles, 2);
}

TEST(SimplifiedDraws, ShadowsAreOfTheSameTriangles) {
  const auto scene = sceneOf(spherePrimitive(1, RINGS));
  Shot shot = litShot(0.25);
  shot.lights[0].castShadow = true;
  shot.lights[0].shadow.mapSize = 256;
  shot.lights[0].shadow.left = shot.lights[0].shadow.bottom = -2;
  shot.lights[0].shadow.right = shot.lights[0].shadow.top = 2;
  shot.lights[0].shadow.near = 0.1;
  shot.lights[0].shadow.far = 10;
  shot.lights[0].shadow.bias = -0.01;
  Shot whole = shot;
  whole.geometryError = 0;
  const auto pictures = drawn(scene, {shot, whole});
  EXPECT_NEAR(pixel8(pictures[0].frame, 36, 24)[0], pixel8(pictures[1].frame, 36, 24)[0], 4) << "no stripes";
  EXPECT_LT(pictures[0].triangles, ALL / 4);
}

}  // namespace
}  // namespace telar::simplified_draws_test
