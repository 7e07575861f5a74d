#include "frame/light_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/scenes.h"
#include "telar/error.h"

// Lights whose range ends before the model: they are left out, and no byte differs.

namespace telar::light_reach_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using Light = Shot::Light;

const Light::Type KINDS[] = {Light::Type::kPoint, Light::Type::kSpot};

/// A unit ball; without bounds nothing is known to be out of reach.
std::shared_ptr<Scene> ball(bool bounded = true) {
  Material material;
  material.roughnessFactor = 0.4f;
  auto scene = sceneOf(spherePrimitive(1, 32), material);
  if (!bounded) scene->bounds = {};
  return scene;
}

/// 2 m beside the ball's bounds, or 8.
Light lamp(Light::Type type, double range, double x = 3) {
  Light light{type};
  light.position = {x, 0, 0};
  light.range = range;
  light.intensity = 1e6;
  light.angle = 0.7;
  return light;
}

Shot litShot(std::vector<Light> lights, ShadingModel shading = ShadingModel::kThree, int bitDepth = 8) {
  Shot shot = shotOf(48);
  shot.shading = shading;
  shot.output.bitDepth = bitDepth;
  Light sun{Light::Type::kDirectional};
  sun.position = {1, 2, 3};
  shot.lights = std::move(lights);
  shot.lights.push_back(sun);
  return shot;
}

/// The largest difference of two pictures in floats.
float apart(const std::vector<std::byte>& a, const std::vector<std::byte>& b) {
  const auto* first = reinterpret_cast<const float*>(a.data());
  const auto* second = reinterpret_cast<const float*>(b.data());
  float most = 0;
  for (std::size_t i = 0; i < a.size() / sizeof(float); ++i) most = std::max(most, std::abs(first[i] - second[i]));
  return most;
}

struct Drawn {
  std::vector<std::byte> pixels;
  nlohmann::json told;
  nlohmann::json skipped(const char* what) const {
    for (const auto& each : told.at("skipped")) {
      if (each.at("what") == what) return each;
    }
    return nullptr;
  }
};

Drawn draw(const std::shared_ptr<Scene>& scene, const Shot& shot) {
  FrameInfo info;
  Frame frame = Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
  return {std::move(frame.pixels), nlohmann::json::parse(info.json)};
}

TEST(LightReach, ARangeReachesTheNearestPointOfTheBounds) {
  Shot shot = shotOf(8);
  shot.samples = 1;
  const frame::Camera camera = frame::cameraOf(shot);
  const auto reaches = [&](const glm::dvec3& position, double range) {
    return frame::reaches(*ball(), shot, camera, position, range);
  };
  EXPECT_TRUE(reaches({3, 0, 0}, 0)) << "without end";
  EXPECT_TRUE(reaches({0.2, 0, 0}, 0.1)) << "inside";
  EXPECT_TRUE(reaches({3, 0, 0}, 2));
  EXPECT_TRUE(reaches({3, 0, 0}, 1.99999)) << "a float may round it into reach";
  EXPECT_FALSE(reaches({3, 0, 0}, 1.99));
  EXPECT_FALSE(reaches({3, 3, 3}, 2 * std::sqrt(3.0) - 0.01)) << "a corner";
  EXPECT_TRUE(frame::reaches(*ball(false), shot, camera, {3, 0, 0}, 1));
  shot.mergeQuads = true;
  EXPECT_TRUE(reaches({3, 0, 0}, 1.99));
}

TEST(LightReach, WithSeveralSamplesNoLineOfSightMayMeetItsSphere) {
  Shot shot = shotOf(48);
  const auto reaches = [&](const glm::dvec3& position, double range) {
    return frame::reaches(*ball(), shot, frame::cameraOf(shot), position, range);
  };
  EXPECT_TRUE(reaches({3, 0, 0}, 1.99));
  EXPECT_FALSE(reaches({9, 0, 0}, 5));
  EXPECT_TRUE(reaches({0, 0, -20}, 5)) << "behind the ball";
  EXPECT_TRUE(reaches({0, 0, 30}, 5)) << "behind the camera";
  EXPECT_TRUE(reaches({0, 0, 5}, 2)) << "around the camera";
  shot.camera.projection = Shot::Camera::Projection::kOrthographic;
  shot.camera.height = 4;
  EXPECT_TRUE(reaches({3, 0, 0}, 1.9)) << "the sphere of the bounds";
  EXPECT_FALSE(reaches({5, 0, 0}, 3));
  EXPECT_TRUE(reaches({5, 0, 0}, 3.2));
}

TEST(LightReach, WhereFloatsAreCoarseTheMarginIsWide) {
  Shot shot = shotOf(8), near = shotOf(8);
  shot.samples = near.samples = 1;
  shot.camera.position.z = 1e6;  // a float of so much is known to 0.06
  EXPECT_TRUE(frame::reaches(*ball(), shot, frame::cameraOf(shot), {3, 0, 0}, 1.99));
  Primitive sphere = spherePrimitive(1, 8);
  const Bounds own = sphere.bounds;
  sphere.bounds.min.x += 1e6;
  sphere.bounds.max.x += 1e6;
  auto far = sceneOf(sphere);
  far->bounds = own;
  const auto offset = glm::translate(glm::dmat4(1.0), glm::dvec3(-1e6, 0, 0));
  far->nodes[0].world = offset;
  EXPECT_TRUE(frame::reaches(*far, near, frame::cameraOf(near), {3, 0, 0}, 1.99));
  far->nodes[0].world = glm::dmat4(1.0);
  auto instances = std::make_shared<Instances>();
  instances->matrices = {glm::mat4(offset)};
  far->nodes[0].instances = instances;
  EXPECT_TRUE(frame::reaches(*far, near, frame::cameraOf(near), {3, 0, 0}, 1.99));
}

/// @param far  m, where the light is; of several samples it has to be farther off
void expectTheSameBytes(ShadingModel shading, Light::Type type, int samples, double far, double range) {
  const auto shotWith = [&](double reach, int bitDepth) {
    Shot shot = litShot({lamp(type, reach, far)}, shading, bitDepth);
    shot.samples = samples;
    return shot;
  };
  const Drawn without = draw(ball(), shotWith(range, 8)), with = draw(ball(false), shotWith(range, 8));
  EXPECT_TRUE(without.pixels == with.pixels);
  // In floats too, but for what another program of the GL's compiler rounds.
  EXPECT_LT(apart(draw(ball(), shotWith(range, 32)).pixels, draw(ball(false), shotWith(range, 32)).pixels), 1e-6f);
  EXPECT_EQ(without.skipped("lights").at("count"), 1);
  EXPECT_EQ(without.skipped("lights").at("of"), 2);
  EXPECT_GT(without.skipped("lights").at("estimatedPart"), 0.0);
  EXPECT_TRUE(with.skipped("lights").is_null());
  EXPECT_NE(without.told["features"], with.told["features"]);
  // The same light with a range that reaches changes the picture: its bytes can tell.
  EXPECT_FALSE(draw(ball(), shotWith(far - 0.5, 8)).pixels == without.pixels);
}

TEST(LightReach, OneThatIsOutOfReachIsLeftOutWithTheSameBytes) {
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kFabric, ShadingModel::kDisney2012}) {
    for (const Light::Type type : KINDS) {
      expectTheSameBytes(shading, type, 1, 3, 1.99);
      expectTheSameBytes(shading, type, 4, 9, 5);
    }
  }
}

// At the rim a fragment of four samples lies beside the ball, where this light shines: without it the bytes differ.
TEST(LightReach, WhatShinesBesideTheModelIsSeenAtItsRim) {
  const Drawn with = draw(ball(), litShot({lamp(Light::Type::kPoint, 1.99)}));
  EXPECT_TRUE(with.skipped("lights").is_null());
  EXPECT_FALSE(with.pixels == draw(ball(), litShot({})).pixels);
}

TEST(LightReach, LightsOfTheModelToo) {
  for (const LightType type : {LightType::kPoint, LightType::kSpot}) {
    std::vector<std::byte> pixels[2];
    for (const bool bounded : {true, false}) {
      auto scene = ball(bounded);
      ModelLight light;
      light.type = type;
      light.intensity = 1e6f;
      light.range = 1.9f;
      scene->lights.push_back(light);
      Node node;
      node.light = 0;
      node.world = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 3, 0));
      scene->nodes.push_back(node);
      Shot shot = litShot({});
      shot.samples = 1;
      const Drawn drawn = draw(scene, shot);
      pixels[bounded] = drawn.pixels;
      EXPECT_EQ(drawn.skipped("lights").is_null(), !bounded);
    }
    EXPECT_TRUE(pixels[0] == pixels[1]);
  }
}

TEST(LightReach, ItsShadowMapIsDrawnForAGroundAlone) {
  for (const Light::Type type : KINDS) {
    Light light = lamp(type, 1.9);
    light.castShadow = true;
    light.shadow = {64, 1, 1, -0.002, 0.02, 0.5, 10, -3, 3, -3, 3, 1};
    Shot shot = litShot({light});
    shot.samples = 1;
    const Drawn without = draw(ball(), shot), with = draw(ball(false), shot);
    EXPECT_TRUE(without.pixels == with.pixels);
    EXPECT_FALSE(without.told["ms"].contains("shadows"));
    EXPECT_TRUE(with.told["ms"].contains("shadows"));
    EXPECT_EQ(without.skipped("shadowMaps").at("count"), 1);
    EXPECT_EQ(without.skipped("shadowMaps").at("texels"), 64 * 64 * (type == Light::Type::kPoint ? 6 : 1));
    shot.ground = Shot::Ground{1, {0, -1, 0}, {8, 8}};
    const Drawn ground = draw(ball(), shot);
    EXPECT_TRUE(ground.pixels == draw(ball(false), shot).pixels);
    EXPECT_TRUE(ground.told["ms"].contains("shadows"));
    EXPECT_TRUE(ground.skipped("shadowMaps").is_null());
  }
}

TEST(Skipped, FeaturesAndPassesAgainstAllForcedOn) {
  const Drawn plain = draw(ball(), litShot({}));
  const auto features = plain.skipped("features");
  EXPECT_GT(features.at("count"), 10);
  EXPECT_EQ(features.at("of").get<std::size_t>() - features.at("count").get<std::size_t>(),
            plain.told["features"].size());
  EXPECT_GT(features.at("estimatedPart"), 0.0);
  EXPECT_EQ(plain.skipped("passes").at("count").get<std::size_t>() + plain.told["passes"].size(), 10u);
  EXPECT_TRUE(plain.skipped("lights").is_null());
  auto sheen = ball();
  sheen->materials[0].physical = true;
  sheen->materials[0].layers.sheenColorFactor = glm::vec3(1);
  EXPECT_EQ(draw(sheen, litShot({})).skipped("features").at("count"), features.at("count").get<int>() - 1);
}

}  // namespace
}  // namespace telar::light_reach_test
