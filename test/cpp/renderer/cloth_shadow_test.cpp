#include <gtest/gtest.h>

#include <cmath>

#include "pass/plan/draw_list.h"
#include "renderer/cloth_images.h"

/// Shadows of the shading "fabric": cloth is thin, seen from both sides, sheer, and full of holes.
namespace telar::cloth_shadow_test {
namespace {

using test::casting;
using test::netImage;
using test::pixelF;
using test::sceneOf;
using test::shotOf;
using test::squareCloth;
using Light = Shot::Light;

Frame draw(const std::shared_ptr<const Scene>& scene, Shot shot) {
  shot.output.bitDepth = 32;
  FrameInfo info;
  return Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
}

/// Green of the middle of a picture, a mean over some pixels.
double middleOf(const Frame& frame) {
  constexpr std::uint32_t SIDE = 32;
  double sum = 0;
  for (std::uint32_t y = 0; y < SIDE; ++y) {
    for (std::uint32_t x = 0; x < SIDE; ++x)
      sum += static_cast<double>(pixelF(frame, (frame.width - SIDE) / 2 + x, (frame.height - SIDE) / 2 + y)[1]);
  }
  return sum / (SIDE * SIDE);
}

/// Shot of `passes` samples, each of its own pass where they are more than one pass takes.
Shot fabricShot(int passes, std::vector<Light> lights) {
  Shot shot = shotOf(64);
  shot.shading = ShadingModel::kFabric;
  shot.samples = passes;
  if (passes > Shot::SAMPLES_OF_A_PASS) shot.resolve = Resolve::kLinear;
  shot.lights = std::move(lights);
  return shot;
}

class LitFrom : public testing::TestWithParam<Light::Type> {};

/// three.js compares a point that it has moved along the normal, into the shadow of the side that faces away.
TEST_P(LitFrom, BehindClothIsNotInItsOwnShadow) {
  Material thin;
  thin.metallicFactor = 0;
  thin.doubleSided = true;
  const auto scene = sceneOf(squareCloth(1), thin);
  Shot shot = fabricShot(4, {casting(GetParam(), {0.3, 0.4, -3})});
  shot.camera.position = {0, 0, -5};
  shot.lights[0].shadow.bias = 0;  // it would hide what the point does
  const double shadowed = middleOf(draw(scene, shot));
  Shot three = shot;
  three.shading = ShadingModel::kThree;
  EXPECT_EQ(middleOf(draw(scene, three)), 0) << "as a browser shows it";
  shot.lights[0].castShadow = false;
  const double lit = middleOf(draw(scene, shot));
  EXPECT_GT(lit, 0.1);
  EXPECT_NEAR(shadowed, lit, 1e-3 * lit);
}

INSTANTIATE_TEST_SUITE_P(Lights, LitFrom,
                         testing::Values(Light::Type::kDirectional, Light::Type::kSpot, Light::Type::kPoint),
                         [](const auto& test) { return std::string(pass::nameOf(test.param)); });

/// A wall, and cloths of 2 x 2 m between it and the light. @param apart  metres
std::shared_ptr<Scene> curtain(const Material& cloth, const Image8& image = {}, int layers = 1, float repeats = 8,
                               float apart = 0.1f) {
  Material wall;
  wall.metallicFactor = 0;
  Primitive behind = squareCloth(1), before = squareCloth(repeats);
  for (glm::vec3& v : behind.positions) v = v * 2.0f - glm::vec3(0, 0, 1);
  for (glm::vec3& v : before.positions) v.y += 2.5f;  // beside what the camera sees of the wall
  behind.material = 0, before.material = 1;
  auto scene = std::make_shared<Scene>();
  scene->materials = {wall, cloth};
  if (image.width > 0) scene->images = std::vector<Image8>{image};
  std::vector<Primitive> all{behind};
  for (int layer = 0; layer < layers; ++layer) {
    all.push_back(before);
    for (glm::vec3& v : all.back().positions) v.z += apart * static_cast<float>(layer);
  }
  for (const Primitive& p : all) {
    for (const glm::vec3& v : p.positions) scene->bounds.add(glm::dvec3(v));
  }
  scene->meshes.push_back({"mesh", all});
  Node node;
  node.mesh = 0;
  scene->nodes.push_back(node);
  return scene;
}

/// The part of the light that a cloth lets on the wall.
double letThrough(const std::shared_ptr<const Scene>& scene, int passes, ShadingModel shading = ShadingModel::kFabric) {
  // Light comes down 2.5 m a metre: the middle of the wall, 1 m behind the cloth, is in the shadow of the cloth's middle.
  Shot shot = fabricShot(passes, {casting(Light::Type::kDirectional, {0, 5, 2}, 1024)});
  shot.camera.fovY = 8;
  shot.shading = shading;
  const double shadowed = middleOf(draw(scene, shot));
  shot.lights[0].castShadow = false;
  return shadowed / middleOf(draw(scene, shot));
}

Material sheerCloth(float alpha) {
  Material sheer;
  sheer.alphaMode = AlphaMode::kBlend;
  sheer.doubleSided = true;
  sheer.baseColorFactor.a = alpha;
  return sheer;
}

TEST(ClothShadow, WhatIsBlendedLetsThroughWhatItsAlphaLeaves) {
  for (const int passes : {4, 16}) {
    for (const float alpha : {0.2f, 0.5f, 0.9f})
      EXPECT_NEAR(letThrough(curtain(sheerCloth(alpha)), passes), 1 - static_cast<double>(alpha), 0.03)
          << alpha << ", " << passes;
    EXPECT_EQ(letThrough(curtain(sheerCloth(1)), passes), 0);
  }
}

TEST(ClothShadow, ByTheAlphaOfItsMapToo) {
  Material sheer = sheerCloth(0.8f);
  sheer.baseColorTexture.image = 0;
  const Image8 half = test::imageOf(4, 4, [](double, double) { return glm::vec4(1, 1, 1, 0.5); });
  EXPECT_NEAR(letThrough(curtain(sheer, half), 4), 0.6, 0.03);
}

/// What three.js shades in the browser casts as three.js has it.
TEST(ClothShadow, WhatIsNoClothCastsAFullOne) {
  EXPECT_EQ(letThrough(curtain(sheerCloth(0.5f)), 4, ShadingModel::kThree), 0);
  Material unlit = sheerCloth(0.5f);
  unlit.unlit = true;
  EXPECT_EQ(letThrough(curtain(unlit), 4), 0);
}

/// However far they are apart.
TEST(ClothShadow, TwoLayersLetThroughWhatBothLeave) {
  for (float apart = 0.03f; apart < 0.33f; apart += 0.011f)
    EXPECT_NEAR(letThrough(curtain(sheerCloth(0.5f), {}, 2, 8, apart), 4), 0.25, 0.04) << apart;
  for (const int passes : {4, 16})
    EXPECT_NEAR(letThrough(curtain(sheerCloth(0.5f), {}, 3), passes), 0.125, 0.04) << passes;
}

/// Threads of a quarter of a mesh, from meshes of five texels of the map to ten meshes in a texel.
TEST(ClothShadow, ANetLetsThroughWhatItsHolesLeave) {
  Material net;
  net.alphaMode = AlphaMode::kMask;
  net.doubleSided = true;
  net.baseColorTexture.image = 0;
  for (const float repeats : {8.0f, 29.0f, 43.0f, 101.0f, 400.0f}) {
    const auto scene = curtain(net, netImage(64, 8, 0.25), 1, repeats);
    EXPECT_NEAR(letThrough(scene, 16), 0.75 * 0.75, 0.06) << repeats;
  }
}

/// The factor is a part of the alpha that is cut by: it makes holes of none.
TEST(ClothShadow, OfANetTheFactorDividesTheCutoff) {
  Material net;
  net.alphaMode = AlphaMode::kMask;
  net.doubleSided = true;
  net.baseColorTexture.image = 0;
  net.baseColorFactor.a = 0.6f;
  const Image8 white = test::imageOf(64, 64, [](double, double) { return glm::vec4(1); });
  for (const float repeats : {8.0f, 101.0f}) EXPECT_EQ(letThrough(curtain(net, white, 1, repeats), 16), 0) << repeats;
  net.baseColorFactor.a = 0.4f;
  for (const float repeats : {8.0f, 101.0f})
    EXPECT_NEAR(letThrough(curtain(net, white, 1, repeats), 16), 1, 1e-6) << repeats << ": it is nowhere";
}

pass::ShadowMap mapOf(Shot shot, int shadowScale, const Limits& limits = {}) {
  shot.shadowScale = shadowScale;
  return pass::planDraws(*sceneOf(squareCloth(1)), shot, limits, false).shadows.flat.at(0);
}

TEST(ClothShadow, MapsAreAsMuchFinerAsTheQualitySays) {
  const Light sun = casting(Light::Type::kDirectional, {0, 3, 3});
  const Shot shot = fabricShot(16, {sun});
  const pass::ShadowMap plain = mapOf(shot, 1), fine = mapOf(shot, 4);
  EXPECT_EQ(plain.settings.mapSize, 256);
  EXPECT_EQ(fine.settings.mapSize, 1024);
  EXPECT_DOUBLE_EQ(fine.settings.bias, plain.settings.bias / 4);
  EXPECT_DOUBLE_EQ(fine.settings.normalBias, plain.settings.normalBias / 4);
  EXPECT_EQ(fine.settings.radius, plain.settings.radius) << "texels";
  Shot three = shot;
  three.shading = ShadingModel::kThree;
  EXPECT_EQ(mapOf(three, 4).settings.mapSize, 256) << "as a browser shows it";
}

TEST(ClothShadow, FineMapsStaySmallTogether) {
  const Light sun = casting(Light::Type::kDirectional, {0, 3, 3}, 2048), small = casting(sun.type, sun.position, 1024);
  EXPECT_EQ(mapOf(fabricShot(16, {small}), 4).settings.mapSize, 4096);
  EXPECT_EQ(mapOf(fabricShot(16, {sun}), 4).settings.mapSize, 4096);
  EXPECT_EQ(mapOf(fabricShot(16, {small, small}), 4).settings.mapSize, 2048);
  EXPECT_EQ(mapOf(fabricShot(16, {sun, sun}), 4).settings.mapSize, 2048);
  Limits few;
  few.shadowTexels = 1024 * 1024;
  EXPECT_EQ(mapOf(fabricShot(16, {small}), 4, few).settings.mapSize, 1024);
}

}  // namespace
}  // namespace telar::cloth_shadow_test
