#include "pass/plan/light_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "expect_error.h"
#include "pass/describe.h"
#include "pass/plan/draw_list.h"
#include "renderer/scenes.h"

// quality.maxLights: the strongest lights are shaded.

namespace telar::light_choice_test {
namespace {

using pass::LightChoice;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using Light = Shot::Light;
using Type = Shot::Light::Type;

Light lightOf(Type type, const glm::dvec3& position, double intensity) {
  Light light{type};
  light.position = position;
  light.intensity = intensity;
  light.color = glm::vec3(1);
  return light;
}

std::shared_ptr<Scene> ball() { return sceneOf(spherePrimitive(1, 8)); }

/// With a directional light of 5 lux.
std::shared_ptr<Scene> ballWithLamp() {
  auto scene = ball();
  scene->lights.push_back({LightType::kDirectional, "lamp", glm::vec3(1), 5});
  Node node;
  node.light = 0;
  scene->nodes.push_back(node);
  return scene;
}

/// Which of the lights are chosen of at most `most`.
std::vector<bool> chosen(const std::vector<Light>& lights, int most) {
  Shot shot = shotOf(16);
  shot.lights = lights;
  shot.maxLights = most;
  return LightChoice(*ball(), shot, frame::cameraOf(shot), Limits()).ofShot;
}

using Flags = std::vector<bool>;

TEST(LightChoice, TakesThoseThatShineMostOnTheMiddle) {
  const std::vector<Light> lights{lightOf(Type::kDirectional, {0, 1, 0}, 1), lightOf(Type::kPoint, {0, 4, 0}, 32),
                                  lightOf(Type::kPoint, {0, 8, 0}, 32), lightOf(Type::kDirectional, {1, 0, 0}, 1)};
  EXPECT_EQ(chosen(lights, 0), (Flags{true, true, true, true}));
  EXPECT_EQ(chosen(lights, 1), (Flags{false, true, false, false})) << "2 lux";
  EXPECT_EQ(chosen(lights, 2), (Flags{true, true, false, false})) << "of equal ones the first";
  EXPECT_EQ(chosen(lights, 3), (Flags{true, true, false, true}));
  EXPECT_EQ(chosen(lights, 4), (Flags{true, true, true, true}));
}

TEST(LightChoice, ConesAndAreasCountByWhatTheyGiveTheModel) {
  Light at = lightOf(Type::kSpot, {0, 5, 0}, 100), beside = at;
  at.angle = beside.angle = 0.2;
  beside.target = {10, 5, 0};
  Light panel = lightOf(Type::kRect, {0, 0, 5}, 10), turned = panel;
  panel.width = panel.height = turned.width = turned.height = 1;
  turned.target = {0, 0, 10};
  EXPECT_EQ(chosen({beside, at, turned, panel}, 2), (Flags{false, true, false, true}));
  Light disk = lightOf(Type::kDisk, {0, 0, 5}, 10);
  disk.radius = 1;
  EXPECT_EQ(chosen({panel, disk}, 1), (Flags{false, true})) << "it is larger";
  Light far = lightOf(Type::kPoint, {0, 5, 0}, 1000);
  far.range = 2;
  EXPECT_EQ(chosen({far, lightOf(Type::kPoint, {0, 5, 0}, 1)}, 1), (Flags{false, true})) << "out of range";
}

TEST(LightChoice, WhatCostsNothingAFragmentStays) {
  Light contact = lightOf(Type::kDirectional, {0, 1, 0}, 0);
  contact.castShadow = true;
  const std::vector<Light> lights{lightOf(Type::kAmbient, {}, 1), lightOf(Type::kHemisphere, {}, 1), contact,
                                  lightOf(Type::kDirectional, {0, 1, 0}, 1), lightOf(Type::kDirectional, {0, 1, 0}, 2)};
  EXPECT_EQ(chosen(lights, 1), (Flags{true, true, true, false, true}));
}

TEST(LightChoice, TheModelsLightsCompeteAndShadowsGoWithTheirLight) {
  const auto scene = ballWithLamp();
  Shot shot = shotOf(16);
  shot.lights = {lightOf(Type::kDirectional, {0, 1, 0}, 1), lightOf(Type::kPoint, {0, 2, 0}, 100)};
  shot.lights[0].castShadow = true;
  const auto planned = [&](int most) {
    shot.maxLights = most;
    return pass::planDraws(*scene, shot, Limits{}, false);
  };
  pass::FramePlan plan = planned(0);
  EXPECT_EQ(plan.lights.directionalColor.size(), 2u);
  EXPECT_EQ(plan.shadows.flat.size(), 1u);
  plan = planned(2);
  EXPECT_EQ(plan.lights.directionalColor.size(), 1u);
  EXPECT_EQ(plan.lights.directionalColor[0], glm::vec3(5));
  EXPECT_EQ(plan.lights.pointColor.size(), 1u);
  EXPECT_TRUE(plan.shadows.empty());
  shot.modelLights = false;
  EXPECT_EQ(planned(2).shadows.flat.size(), 1u);
}

TEST(LightChoice, SunsComeLastAndAreToldApartFromLightsOfTheShotAndOfTheModel) {
  const auto scene = ballWithLamp();
  Shot shot = shotOf(16);
  shot.lights = {lightOf(Type::kDirectional, {0, 1, 0}, 1)};
  const Shot sunlit = pass::withSuns(shot, {.list = {{glm::dvec3(0, 1, 0), glm::dvec3(3)}}, .share = 0});
  const pass::FramePlan plan = pass::planDraws(*scene, sunlit, Limits{}, false);
  EXPECT_EQ(plan.lights.directionalColor, (std::vector<glm::vec3>{glm::vec3(1), glm::vec3(5), glm::vec3(3)}));
  EXPECT_EQ(plan.lights.suns, 1u);
  pass::LightSet padded = plan.lights;
  padded.pad(6);
  EXPECT_EQ(padded.directionalColor.size(), 6u);
  EXPECT_EQ(padded.directionalColor.back(), glm::vec3(3));
  EXPECT_EQ(plan.frame.lights.directional, 3) << "in one list, suns behind";
  EXPECT_EQ(plan.frame.lights.suns, 1);
  const auto features = plan.frame.features();
  EXPECT_NE(std::find(features.begin(), features.end(), "2 directional-lights"), features.end());
  EXPECT_NE(std::find(features.begin(), features.end(), "1 sun"), features.end());
}

TEST(LightChoice, SunsAreNotChosenAmongLights) {
  for (const double key : {1.0, 5.0}) {
    Shot shot = shotOf(16);
    shot.lights = {lightOf(Type::kDirectional, {0, 1, 0}, key), lightOf(Type::kDirectional, {1, 0, 0}, key / 2)};
    shot.maxLights = 1;
    const Shot sunlit = pass::withSuns(shot, {.list = {{glm::dvec3(0, 1, 0), glm::dvec3(3)}}, .share = 0});
    EXPECT_EQ(LightChoice(*ball(), sunlit, frame::cameraOf(sunlit), Limits()).ofShot, (Flags{true, false, true}))
        << key;
  }
}

TEST(LightChoice, AsManyAsALimitAllowsAreCounted) {
  Shot shot = shotOf(16);
  shot.lights.assign(300, lightOf(Type::kDirectional, {0, 1, 0}, 1));
  Limits limits;
  limits.lights = 300;
  EXPECT_EQ(pass::planDraws(*ball(), shot, limits, false).frame.lights.directional, 300);
}

TEST(LightChoice, TheLimitIsOfThoseThatAreShaded) {
  Shot shot = shotOf(16);
  shot.lights.assign(5, lightOf(Type::kPoint, {0, 2, 0}, 1));
  Limits limits;
  limits.lights = 3;
  EXPECT_ERROR(pass::planDraws(*ball(), shot, limits, false), "L_LIGHTS");
  shot.maxLights = 3;
  EXPECT_EQ(pass::planDraws(*ball(), shot, limits, false).lights.pointColor.size(), 3u);
}

}  // namespace
}  // namespace telar::light_choice_test
