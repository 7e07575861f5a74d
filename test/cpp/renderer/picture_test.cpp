#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "renderer/scenes.h"

namespace telar {
namespace {

using test::pixel8;
using test::pixelF;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& shot, Backend backend = Backend::kAuto,
           bool allFeatures = false) {
  RendererOptions options;
  options.backend = backend;
  options.allFeatures = allFeatures;
  FrameInfo info;
  return Renderer::create(options)->draw(scene, shot, {}, CancelToken(), info);
}

Shot litShot(int size) {
  Shot shot = shotOf(size);
  shot.toneMapping = ToneMapping::kNeutral;
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {1, 2, 3};
  sun.intensity = 3;
  Shot::Light sky{Shot::Light::Type::kHemisphere};
  sky.groundColor = {0.2f, 0.1f, 0.05f};
  Shot::Light spot{Shot::Light::Type::kSpot};
  spot.position = {-2, 0, 2};
  spot.angle = 0.5;
  spot.penumbra = 0.3;
  spot.intensity = 5;
  shot.lights = {sun, sky, spot};
  return shot;
}

TEST(Picture, AWhiteSphereUnderAmbientLightIsALitDiskOnTransparency) {
  Shot shot = shotOf(64);
  shot.lights.push_back({Shot::Light::Type::kAmbient});
  Material material;
  material.metallicFactor = 0;
  const Frame frame = draw(sceneOf(spherePrimitive(1), material), shot);
  EXPECT_EQ(pixel8(frame, 0, 0)[3], 0);
  EXPECT_EQ(pixel8(frame, 32, 32)[3], 255);
  EXPECT_GT(pixel8(frame, 32, 32)[0], 100);
}

TEST(Picture, RowZeroIsTheTop) {
  Shot shot = shotOf(64);
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {0, 1, 0.2};
  shot.lights.push_back(sun);
  Material material;
  material.metallicFactor = 0;
  const Frame frame = draw(sceneOf(spherePrimitive(1), material), shot);
  EXPECT_GT(pixel8(frame, 32, 14)[0], pixel8(frame, 32, 50)[0] + 50);
}

TEST(Picture, AnInstanceLooksLikeANodeInItsPlace) {
  const auto placed = [](const glm::dmat4& matrix) {
    auto scene = sceneOf(spherePrimitive(0.5f));
    scene->nodes[0].world = matrix;
    return scene;
  };
  // Scale and place are exact in fp32, so that both ways round alike.
  glm::dmat4 matrix(2);
  matrix[3] = {0.5, -0.25, 0, 1};
  const auto many = placed(glm::dmat4(1));
  Instances instances;
  instances.matrices = {glm::mat4(matrix)};
  instances.centers = {{0, 0, 0}};
  many->nodes[0].instances = std::make_shared<const Instances>(instances);
  EXPECT_EQ(draw(many, litShot(96)).pixels, draw(placed(matrix), litShot(96)).pixels);
  // One more, far away, adds nothing; a colour of its own does.
  instances.matrices.push_back(glm::mat4(
      glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, 99, 0, 1))));
  many->nodes[0].instances = std::make_shared<const Instances>(instances);
  EXPECT_EQ(draw(many, litShot(96)).pixels, draw(placed(matrix), litShot(96)).pixels);
  instances.colors = {{1, 0, 0}, {1, 1, 1}};
  many->nodes[0].instances = std::make_shared<const Instances>(instances);
  EXPECT_NE(draw(many, litShot(96)).pixels, draw(placed(matrix), litShot(96)).pixels);
}

TEST(Picture, PosesShareTheirModelsCopiesOnTheGpu) {
  auto model = sceneOf(spherePrimitive(1));
  model->fileMeshes = 1;
  const auto renderer = Renderer::create({});
  FrameInfo info;
  const auto drawn = [&](const std::shared_ptr<const Scene>& scene) {
    return renderer->draw(scene, litShot(48), {}, CancelToken(), info).pixels;
  };
  const auto first = drawn(model);
  const int alone = renderer->liveObjects();
  auto pose = std::make_shared<Scene>(*model);
  pose->model = model;
  EXPECT_EQ(drawn(pose), first);
  EXPECT_EQ(renderer->liveObjects(), alone);  // nothing of its own
  pose = std::make_shared<Scene>(*model);
  pose->model = model;
  pose->meshes.push_back({"deformed", {spherePrimitive(0.5f)}});
  pose->nodes[0].mesh = 1;
  EXPECT_NE(drawn(pose), first);
  EXPECT_GT(renderer->liveObjects(), alone);
  renderer->release(*pose);
  EXPECT_EQ(renderer->liveObjects(), alone);
  EXPECT_EQ(drawn(model), first);
  renderer->release(*model);
  EXPECT_LT(renderer->liveObjects(), alone);
}

TEST(Picture, APoseThatAloneHoldsItsModelTakesItAlong) {
  std::shared_ptr<const Scene> model = sceneOf(spherePrimitive(1));
  const auto renderer = Renderer::create({});
  FrameInfo info;
  renderer->draw(model, litShot(48), {}, CancelToken(), info);
  renderer->release(*model);
  const int none = renderer->liveObjects();
  auto pose = std::make_shared<Scene>(*model);
  pose->model = std::move(model);
  renderer->draw(pose, litShot(48), {}, CancelToken(), info);
  renderer->release(*pose);
  EXPECT_EQ(renderer->liveObjects(), none);
}

TEST(Picture, EglAndOsmesaAgreeByteForByte) {
  const auto scene = sceneOf(spherePrimitive(1));
  EXPECT_EQ(draw(scene, litShot(128), Backend::kEglSurfaceless).pixels,
            draw(scene, litShot(128), Backend::kOsmesa).pixels);
}

TEST(Picture, AllFeaturesForcedOnGiveTheSamePicture) {
  Material material;
  material.baseColorFactor = {0.7f, 0.2f, 0.1f, 1};
  material.roughnessFactor = 0.5f;
  const auto scene = sceneOf(spherePrimitive(1), material);
  const Frame few = draw(scene, litShot(64)), all = draw(scene, litShot(64), Backend::kAuto, true);
  for (std::size_t i = 0; i < few.pixels.size(); ++i) {
    ASSERT_LE(std::abs(static_cast<int>(few.pixels[i]) - static_cast<int>(all.pixels[i])), 1) << i;
  }
}

TEST(Picture, NoPixelIsNanWithALightOnTheSurfaceAndBehindAnOrthographicView) {
  Shot shot = litShot(64);
  shot.output.bitDepth = 32;
  shot.camera.projection = Projection::kOrthographic;
  shot.camera.height = 3;
  Shot::Light inside{Shot::Light::Type::kPoint};
  inside.position = {0, 0, 1};
  Shot::Light behind{Shot::Light::Type::kDirectional};
  behind.position = {0, 0, -1};
  shot.lights.push_back(inside);
  shot.lights.push_back(behind);
  Material material;
  material.roughnessFactor = 0;
  const Frame frame = draw(sceneOf(spherePrimitive(1), material), shot);
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixelF(frame, x, y)[c])) << x << ", " << y;
    }
  }
}

TEST(Picture, AFlattenedNodeIsDrawnWithoutNan) {
  Shot shot = litShot(64);
  shot.output.bitDepth = 32;
  const auto scene = sceneOf(spherePrimitive(1));
  scene->nodes[0].world[2] = glm::dvec4(0);
  const Frame frame = draw(scene, shot);
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixelF(frame, x, y)[c])) << x << ", " << y;
    }
  }
  EXPECT_GT(pixelF(frame, 32, 32)[3], 0.9f);
}

TEST(Picture, RepeatedDrawsLeakNoGlNames) {
  const auto renderer = Renderer::create({});
  const auto scene = sceneOf(spherePrimitive(1, 8));
  FrameInfo info;
  renderer->draw(scene, litShot(32), {}, CancelToken(), info);
  const int names = renderer->liveObjects();
  for (int i = 0; i < 20; ++i) renderer->draw(scene, litShot(32), {}, CancelToken(), info);
  EXPECT_EQ(renderer->liveObjects(), names);
  for (int i = 0; i < 20; ++i) renderer->draw(sceneOf(spherePrimitive(1, 8)), litShot(32), {}, CancelToken(), info);
  renderer->draw(scene, litShot(32), {}, CancelToken(), info);
  EXPECT_EQ(renderer->liveObjects(), names);
}

TEST(Picture, ACancelledJobThrowsAndTheRendererGoesOn) {
  const auto renderer = Renderer::create({});
  const auto scene = sceneOf(spherePrimitive(1, 8));
  FrameInfo info;
  CancelToken cancelled;
  cancelled.cancel();
  EXPECT_ERROR(renderer->draw(scene, litShot(32), {}, cancelled, info), "X_CANCELLED");
  EXPECT_NO_THROW(renderer->draw(scene, litShot(32), {}, CancelToken(), info));
}

}  // namespace
}  // namespace telar
