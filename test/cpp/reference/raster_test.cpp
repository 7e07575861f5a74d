#include <gtest/gtest.h>

#include <cmath>

#include "reference/tracer.h"
#include "renderer/scenes.h"
#include "shading_terms.h"

/// Raster against path traced: the same model, direct light, nothing hidden. What is left is the integrator's error.
namespace telar::reference {
namespace {

Frame rastered(const std::shared_ptr<Scene>& scene, const Shot& shot) {
  RendererOptions options;
  options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  FrameInfo info;
  return Renderer::create(options)->draw(scene, shot, {}, CancelToken(), info);
}

Shot litShot() {
  Shot shot = test::shotOf(96);
  shot.output.bitDepth = 32;
  shot.samples = 1;
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {2, 3, 4};
  sun.intensity = 3;
  Shot::Light lamp{Shot::Light::Type::kPoint};
  lamp.position = {-2, 0.5, 2};
  lamp.intensity = 5;
  Shot::Light dome{Shot::Light::Type::kAmbient};
  dome.intensity = 0.3;
  shot.lights = {sun, lamp, dome};
  return shot;
}

/// Largest and mean difference over pixels that the model covers whole, in linear radiance.
std::pair<double, double> differenceOf(const Frame& a, const Frame& b) {
  double most = 0, sum = 0;
  int count = 0;
  for (std::uint32_t y = 2; y + 2 < a.height; ++y) {
    for (std::uint32_t x = 2; x + 2 < a.width; ++x) {
      bool inside = true;
      for (int d = -2; d <= 2; ++d) {
        inside &= test::pixelF(b, x + static_cast<std::uint32_t>(d), y)[3] == 1 &&
                  test::pixelF(b, x, y + static_cast<std::uint32_t>(d))[3] == 1;
      }
      if (!inside) continue;
      for (int c = 0; c < 3; ++c) {
        const double difference = std::abs(test::pixelF(a, x, y)[c] - test::pixelF(b, x, y)[c]);
        most = std::max(most, difference);
        sum += difference;
      }
      count += 3;
    }
  }
  return {most, sum / count};
}

void expectTheSamePicture(const std::shared_ptr<Scene>& scene, double most, double mean, ShadingModel shading,
                          const std::optional<ShadingTerms>& terms = std::nullopt) {
  Shot shot = litShot();
  shot.shading = shading;
  shot.terms = terms.value_or(termsOf(shading));
  const Frame raster = rastered(scene, shot);
  const Frame truth = trace(*scene, shot, nullptr, {.samples = 64}, Limits(), CancelToken(), {});
  const auto [worst, average] = differenceOf(raster, truth);
  EXPECT_LE(worst, most) << scene->materials[0].name;
  EXPECT_LE(average, mean) << scene->materials[0].name;
}

void expectTheSamePicture(const Material& material, double most, double mean,
                          ShadingModel shading = ShadingModel::kThree) {
  expectTheSamePicture(test::sceneOf(test::spherePrimitive(1), material), most, mean, shading);
}

Material named(const char* name, float roughness, float metallic) {
  Material m;
  m.name = name;
  m.baseColorFactor = {0.7f, 0.3f, 0.2f, 1};
  m.roughnessFactor = roughness;
  m.metallicFactor = metallic;
  return m;
}

TEST(RasterAgainstReference, PlainCloth) { expectTheSamePicture(named("plain", 0.9f, 0), 0.02, 0.001); }

TEST(RasterAgainstReference, Metal) { expectTheSamePicture(named("metal", 0.5f, 1), 0.05, 0.0015); }

Material layered() {
  Material m = named("layers", 0.6f, 0.2f);
  m.physical = true;
  m.layers.ior = 1.4f;
  m.layers.specularFactor = 0.8f;
  m.layers.clearcoatFactor = 0.6f;
  m.layers.clearcoatRoughnessFactor = 0.4f;
  m.layers.sheenColorFactor = {0.2f, 0.3f, 0.4f};
  m.layers.sheenRoughnessFactor = 0.5f;
  m.layers.iridescenceFactor = 0.5f;
  m.layers.diffuseRoughnessFactor = 0.7f;
  return m;
}

TEST(RasterAgainstReference, EveryLayer) { expectTheSamePicture(layered(), 0.03, 0.002); }

TEST(RasterAgainstReference, NormalsThatLean) {
  Material m = named("leaning", 0.5f, 1);
  m.normalTexture.image = 0;
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kDisney2012}) {
    const auto scene = test::sceneOf(test::spherePrimitive(1), m);
    scene->images = {Image8{1, 1, {180, 150, 230, 255}}};
    expectTheSamePicture(scene, 0.06, 0.002, shading);
  }
}

/// Heights in long waves, 64 x 64.
Image8 waves() {
  Image8 image{64, 64, {}};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double wave = std::sin(x * 0.125 * M_PI) * std::cos(y * 0.0625 * M_PI);
      const auto height = static_cast<std::uint8_t>(std::lround(127.5 + 120 * wave));
      for (const std::uint8_t channel : {height, std::uint8_t{0}, std::uint8_t{255}, std::uint8_t{255}})
        image.pixels.push_back(channel);
    }
  }
  return image;
}

TEST(RasterAgainstReference, HeightsThatTilt) {
  Material m = named("bumps", 0.6f, 0);
  m.physical = true;
  m.layers.bumpTexture.image = 0;
  m.layers.bumpFactor = 3;
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kFabric}) {
    const auto scene = test::sceneOf(test::spherePrimitive(1), m);
    scene->images = {waves()};
    expectTheSamePicture(scene, 0.06, 0.004, shading);
  }
}

TEST(RasterAgainstReference, PrincipledShadings) {
  Material soft = layered();
  soft.name = "soft";
  soft.layers.clearcoatFactor = 0;
  soft.fabric.flatness = 0.5f;
  for (const ShadingModel shading : {ShadingModel::kThreeR115, ShadingModel::kDisney2012}) {
    expectTheSamePicture(named("plain", 0.9f, 0), 0.02, 0.001, shading);
    expectTheSamePicture(named("metal", 0.5f, 1), 0.05, 0.0015, shading);
    expectTheSamePicture(layered(), 0.03, 0.002, shading);
    expectTheSamePicture(soft, 0.03, 0.002, shading);
  }
}

TEST(RasterAgainstReference, ThinCloth) {
  Material m = named("thin", 0.8f, 0);
  m.fabric.flatness = 0.3f;
  m.fabric.diffuseTransmissionFactor = 0.4f;
  m.fabric.diffuseTransmissionColorFactor = {0.9f, 0.6f, 0.3f};
  ShadingTerms terms = termsOf(ShadingModel::kDisney2012);
  terms.diffuse = ShadingTerms::DIFFUSE_DISNEY_2015_THIN;
  expectTheSamePicture(test::sceneOf(test::spherePrimitive(1), m), 0.02, 0.001, ShadingModel::kDisney2012, terms);
}

/// Ambient visibility of both sides, light from everywhere alone.
std::shared_ptr<Scene> halfHiddenSphere(bool transmits) {
  Primitive sphere = test::spherePrimitive(1);
  for (const glm::vec3& n : sphere.normals) {
    const glm::vec3 leaning = glm::normalize(n + glm::vec3(0.3f, 0.4f, 0));
    sphere.visibility[0].emplace_back(leaning, 0.5f + 0.4f * n.x);
    sphere.visibility[1].emplace_back(-n, 0.5f - 0.4f * n.y);
  }
  Material m = named("half hidden", 0.4f, 0);
  m.layers.sheenColorFactor = {0.3f, 0.3f, 0.3f};
  m.physical = true;
  if (transmits) m.fabric.diffuseTransmissionFactor = 0.5f;
  m.doubleSided = true;
  return test::sceneOf(std::move(sphere), m);
}

Shot domeShot() {
  Shot shot = litShot();
  Shot::Light dome{Shot::Light::Type::kHemisphere};
  dome.intensity = 2;
  dome.groundColor = {0.1f, 0.2f, 0.4f};
  shot.lights = {dome};
  shot.shading = ShadingModel::kFabric;
  shot.terms = termsOf(shot.shading);
  return shot;
}

/// Threads are white, holes black; a texel is as wide as the picture.
TEST(RasterAgainstReference, WhatIsBlendedHasNoColourOfItsHoles) {
  Primitive square = test::stackedSquares(1);
  square.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  Material sheer;
  sheer.metallicFactor = 0;
  sheer.alphaMode = AlphaMode::kBlend;
  sheer.baseColorTexture.image = 0;
  const auto scene = test::sceneOf(square, sheer);
  scene->images = std::vector<Image8>{Image8{2, 1, {255, 255, 255, 255, 0, 0, 0, 0}}};
  Shot shot = litShot();
  shot.shading = ShadingModel::kFabric;
  shot.lights = {{Shot::Light::Type::kAmbient}};
  for (const Frame& frame :
       {rastered(scene, shot), trace(*scene, shot, nullptr, {.samples = 64}, Limits(), CancelToken(), {})}) {
    int partly = 0;
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      const float* pixel = test::pixelF(frame, x, frame.height / 2);
      if (!(pixel[3] > 0.1f)) continue;
      partly += pixel[3] < 0.9f;
      EXPECT_NEAR(pixel[1] / pixel[3], 1 / glm::pi<float>(), 0.01) << x;
    }
    EXPECT_GT(partly, 10);
  }
}

TEST(RasterAgainstReference, AmbientVisibilityIsThatOfTheTracer) {
  for (const bool transmits : {false, true}) {
    const auto scene = halfHiddenSphere(transmits);
    const Shot shot = domeShot();
    const Frame raster = rastered(scene, shot);
    const Frame truth = trace(*scene, shot, nullptr, {.samples = 64}, Limits(), CancelToken(), {});
    const auto [worst, average] = differenceOf(raster, truth);
    EXPECT_LE(worst, 0.01) << transmits;
    EXPECT_LE(average, 0.001) << transmits;
    const auto open = std::make_shared<Scene>(*scene);
    std::vector<Primitive> primitives(scene->meshes[0].primitives.begin(), scene->meshes[0].primitives.end());
    primitives[0].visibility = {};
    open->meshes[0].primitives = primitives;
    EXPECT_GT(differenceOf(rastered(open, shot), truth).second, 0.01) << "it is left out";
  }
}

}  // namespace
}  // namespace telar::reference
