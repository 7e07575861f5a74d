#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pass/plan/draw_list.h"
#include "pass/target/transmission_target.h"
#include "renderer/scenes.h"

namespace telar::transmission_test {
namespace {

using test::pixel8;
using test::pixelF;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using json = nlohmann::json;

constexpr float NONE = std::numeric_limits<float>::infinity();

Material glass() {
  Material material;
  material.metallicFactor = 0;
  material.roughnessFactor = 0.2f;
  material.physical = true;
  material.layers.transmissionFactor = 1;
  return material;
}

/// A red ball that shines, and a larger one of `material` before it.
std::shared_ptr<Scene> ballBehind(const Material& material) {
  const auto scene = sceneOf(spherePrimitive(1, 24), material);
  Material red;
  red.emissiveFactor = {0.5f, 0, 0};
  red.baseColorFactor = {0, 0, 0, 1};
  scene->materials.push_back(red);
  Primitive ball = spherePrimitive(0.5f, 12);
  ball.material = 1;
  scene->meshes.push_back({"ball", {ball}});
  Node node;
  node.mesh = 1;
  node.world[3] = glm::dvec4(0, 0, -1.4, 1);
  scene->nodes.push_back(node);
  return scene;
}

Shot litShot(int size = 32) {
  Shot shot = shotOf(size);
  Shot::Light sky{Shot::Light::Type::kHemisphere};
  sky.groundColor = {0.2f, 0.1f, 0.05f};
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {1, 2, 3};
  shot.lights = {sky, sun};
  return shot;
}

Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& shot, bool allFeatures = false) {
  RendererOptions options;
  options.allFeatures = allFeatures;
  FrameInfo info;
  return Renderer::create(options)->draw(scene, shot, {}, CancelToken(), info);
}

pass::DrawList drawsOf(const Material& material) {
  // The plan points into the scene, of which the lists' keys are looked at only.
  return pass::planDraws(*ballBehind(material), litShot(), Limits{}, false).draws;
}

TEST(PlanTransmission, NothingIsDrawnBehindWhereNothingTransmits) {
  Material material = glass();
  material.layers.transmissionFactor = 0;
  material.layers.thicknessFactor = material.layers.dispersion = 1;
  const pass::DrawList draws = drawsOf(material);
  EXPECT_EQ(draws.opaque.size(), 2u);
  EXPECT_EQ(draws.size(), 2u);
  for (const pass::DrawItem& item : draws.opaque) EXPECT_FALSE(item.key.volume || item.key.dispersion);
  material = glass();
  material.unlit = true;
  EXPECT_TRUE(drawsOf(material).transmissive.empty());
}

TEST(PlanTransmission, OpaqueSurfacesAreDrawnBehindInLinearRadiance) {
  const pass::DrawList draws = drawsOf(glass());
  ASSERT_EQ(draws.transmissive.size(), 1u);
  EXPECT_FALSE(draws.transmissive[0].key.outputLinear);
  ASSERT_EQ(draws.behind.size(), 1u);
  EXPECT_TRUE(draws.behind[0].key.outputLinear);
  EXPECT_EQ(draws.behind[0].key.toneMapping, shader::ToneMapping::kNone);
  EXPECT_TRUE(draws.behindBackSides.empty());
}

TEST(PlanTransmission, BackSidesOfDoubleSidedOnesAreDrawnBehind) {
  Material material = glass();
  material.doubleSided = true;
  pass::DrawList draws = drawsOf(material);
  ASSERT_EQ(draws.behindBackSides.size(), 1u);
  EXPECT_TRUE(draws.behindBackSides[0].key.flipSided && !draws.behindBackSides[0].bothSides);
  ASSERT_EQ(draws.transmissive.size(), 1u);
  EXPECT_TRUE(draws.transmissive[0].bothSides);
  material.alphaMode = AlphaMode::kBlend;
  draws = drawsOf(material);
  EXPECT_EQ(draws.behindBackSides.size(), 1u);
  EXPECT_EQ(draws.transmissive.size(), 2u);
  EXPECT_TRUE(draws.blended.empty());
}

TEST(PlanTransmission, CompilesOnlyWhatTheVolumeUses) {
  Material material = glass();
  const auto key = [&] { return drawsOf(material).transmissive[0].key; };
  material.layers.attenuationDistance = 1;
  material.layers.attenuationColor = {0.5f, 1, 1};
  EXPECT_FALSE(key().volume || key().attenuation) << "no thickness";
  material.layers.thicknessFactor = 1;
  EXPECT_TRUE(key().volume && key().attenuation);
  material.layers.attenuationColor = {1, 1, 1};
  EXPECT_FALSE(key().attenuation);
  material.layers.attenuationColor = {0.5f, 1, 1};
  material.layers.attenuationDistance = NONE;
  EXPECT_FALSE(key().attenuation);
  material.layers.dispersion = 1;
  EXPECT_TRUE(key().dispersion);
  material.layers.ior = 1;
  EXPECT_FALSE(key().dispersion) << "nothing is refracted";
}

TEST(PlanTransmission, NamesFeaturesAndPasses) {
  Material material = glass();
  material.layers.thicknessFactor = material.layers.dispersion = 1;
  const auto plan = json::parse(planFrame(*ballBehind(material), litShot(), Limits{}));
  EXPECT_EQ(plan["passes"], json::array({"transmission", "opaque", "transmissive", "resolve"}));
  for (const char* feature : {"transmission", "volume", "dispersion"}) {
    EXPECT_NE(std::find(plan["features"].begin(), plan["features"].end(), feature), plan["features"].end()) << feature;
  }
}

TEST(Transmission, ShowsWhatLiesBehind) {
  const Frame frame = draw(ballBehind(glass()), litShot(64));
  const std::uint8_t* centre = pixel8(frame, 32, 32);
  EXPECT_GT(centre[0], centre[1] + 80);
  EXPECT_EQ(centre[3], 255);
  EXPECT_EQ(pixel8(frame, 1, 1)[3], 0);
  // Where nothing lies behind, it is half see-through, as in three.js.
  EXPECT_NEAR(pixel8(frame, 32, 10)[3], 128, 20);
}

TEST(Transmission, WhatLiesBehindMayBeDrawnSmaller) {
  const auto extent = [](double scale) {
    Shot shot = litShot(100);
    shot.height = 30;
    shot.transmissionScale = scale;
    return pass::TransmissionTarget::extentOf(shot, {});
  };
  using Extent = pass::TransmissionTarget::Extent;
  EXPECT_EQ(extent(1), (Extent{100, 30, 4}));
  EXPECT_EQ(extent(0.5), (Extent{50, 15, 4}));
  EXPECT_EQ(extent(0.0625), (Extent{6, 2, 4}));
  // How many pixels show the red ball behind, and where their middle lies.
  const auto red = [](const Frame& frame) {
    glm::dvec3 sum(0);
    for (std::uint32_t y = 0; y < frame.height; ++y) {
      for (std::uint32_t x = 0; x < frame.width; ++x)
        if (pixel8(frame, x, y)[0] > pixel8(frame, x, y)[1] + 80) sum += glm::dvec3(1, x, y);
    }
    return glm::dvec3(sum.x, sum.y / sum.x, sum.z / sum.x);
  };
  Shot shot = litShot(256);
  const auto scene = ballBehind(glass());
  const Frame whole = draw(scene, shot);
  shot.transmissionScale = 0.25;
  const Frame small = draw(scene, shot);
  EXPECT_FALSE(whole.pixels == small.pixels);
  EXPECT_NEAR(red(small).x / red(whole).x, 1, 0.2);
  EXPECT_NEAR(red(small).y, red(whole).y, 2) << "it lies where it lay";
  EXPECT_NEAR(red(small).z, red(whole).z, 2);
}

TEST(Transmission, IsExposedOnce) {
  Shot shot = litShot();
  shot.exposure = 0.5;
  shot.toneMapping = ToneMapping::kLinear;
  shot.background = {{}, Shot::Background::Type::kColor, glm::vec3(0.3f, 0.4f, 0.5f)};
  const auto scene = ballBehind(glass());
  const Frame encoded = draw(scene, shot);
  shot.output.bitDepth = 32;
  const Frame linear = draw(scene, shot);
  for (std::uint32_t y = 12; y < 20; ++y) {
    for (std::uint32_t x = 12; x < 20; ++x) {
      for (int c = 0; c < 3; ++c) {
        const float radiance = pixelF(linear, x, y)[c];
        const float srgb = radiance <= 0.0031308f ? radiance * 12.92f : 1.055f * std::pow(radiance, 0.41666f) - 0.055f;
        EXPECT_NEAR(pixel8(encoded, x, y)[c], 255 * srgb, 1.5) << x << ", " << y;
      }
    }
  }
}

TEST(Transmission, BlackOverNoThicknessTakesNothing) {
  Material black = glass();
  black.layers.thicknessFactor = 1e-30f;
  black.layers.attenuationColor = {0, 0, 0};
  black.layers.attenuationDistance = 1e12f;
  EXPECT_GT(pixel8(draw(ballBehind(black), litShot()), 16, 16)[0], 100);
}

TEST(Transmission, AllFeaturesForcedOnGiveTheSamePicture) {
  Material material = glass();
  material.layers.thicknessFactor = 0.3f;
  for (const bool doubleSided : {false, true}) {
    material.doubleSided = doubleSided;
    const auto scene = ballBehind(material);
    const Frame few = draw(scene, litShot(64)), all = draw(scene, litShot(64), true);
    for (std::size_t i = 0; i < few.pixels.size(); ++i) {
      ASSERT_LE(std::abs(static_cast<int>(few.pixels[i]) - static_cast<int>(all.pixels[i])), 1) << i;
    }
  }
}

TEST(Transmission, ItsTargetIsFreedByAFrameWithoutIt) {
  RendererOptions options;
  options.visibilityBuffer = RendererOptions::LeaveOut::kNever;  // it has names of its own
  const auto renderer = Renderer::create(options);
  const auto opaque = sceneOf(spherePrimitive(1, 8));
  const auto scene = ballBehind(glass());
  FrameInfo info;
  const auto drawBoth = [&] {
    renderer->draw(scene, litShot(), {}, CancelToken(), info);
    const int during = renderer->liveObjects();
    renderer->draw(opaque, litShot(), {}, CancelToken(), info);
    EXPECT_LT(renderer->liveObjects(), during);
    return renderer->liveObjects();
  };
  drawBoth();
  const int after = drawBoth();
  EXPECT_EQ(drawBoth(), after);
}

/// {ior, roughness, thickness, attenuation distance, attenuation colour, dispersion}
using Extreme = std::array<float, 6>;

constexpr Extreme EXTREMES[] = {
    {1, 0, 0, NONE, 1, 0},           {1, 0, 1, 1, 0, 40},
    {1, 1, 1e12f, 1e-12f, 0, 0},     {1.5f, 0, 1e12f, 1e12f, 1, 40},
    {1.5f, 1, 1e-12f, 1e-12f, 0, 1}, {1.5f, 1, 5, NONE, 0, 40},
    {1000, 0, 1, 1e-12f, 1, 40},     {1000, 1, 1e12f, 1e12f, 0, 40},
    {1000, 0, 0, 1, 0, 1},           {1.0001f, 0.5f, 1e30f, 1, 0.5f, 40},
};

Material extremeGlass(const Extreme& extreme) {
  const auto [ior, roughness, thickness, distance, color, dispersion] = extreme;
  Material material = glass();
  material.roughnessFactor = roughness;
  material.doubleSided = true;
  material.layers.ior = ior;
  material.layers.thicknessFactor = thickness;
  material.layers.attenuationDistance = distance;
  material.layers.attenuationColor = glm::vec3(color, 0.5f, 0);
  material.layers.dispersion = dispersion;
  return material;
}

TEST(Transmission, NoExtremeGivesAPixelThatIsNotANumber) {
  constexpr std::uint32_t SIZE = 16;
  Shot shot = litShot(SIZE);
  shot.output.bitDepth = 32;
  shot.camera.height = 2.5;
  const auto renderer = Renderer::create({});
  FrameInfo info;
  for (std::size_t row = 0; row < std::size(EXTREMES); ++row) {
    SCOPED_TRACE(row);
    const auto scene = ballBehind(extremeGlass(EXTREMES[row]));
    for (const bool perspective : {true, false}) {
      shot.camera.projection = perspective ? Projection::kPerspective : Projection::kOrthographic;
      const Frame frame = renderer->draw(scene, shot, {}, CancelToken(), info);
      for (std::uint32_t i = 0; i < SIZE * SIZE * 4; ++i) {
        ASSERT_TRUE(std::isfinite(pixelF(frame, 0, 0)[i])) << "channel " << i;
      }
      EXPECT_GE(pixelF(frame, SIZE / 2, SIZE / 2)[3], 0.4f);
    }
  }
}

}  // namespace
}  // namespace telar::transmission_test
