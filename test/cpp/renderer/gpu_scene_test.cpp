#include "pass/model/gpu_scene.h"

#include <gtest/gtest.h>

#include "renderer/cloth_images.h"

namespace telar::gpu_scene_test {
namespace {

using test::sceneOf;
using test::spherePrimitive;
using test::weaveNormals;

constexpr std::uint32_t SIDE = 512;

class GpuSceneTest : public testing::Test {
 protected:
  GpuSceneTest() {
    Material material;
    material.normalTexture.image = 0;
    scene = sceneOf(spherePrimitive(1, 4), material);
    scene->images = SharedList<Image8>{weaveNormals(SIDE, SIDE, 9, 0.6)};
    scene->fileImages = 1;
    gpu.emplace(*context, store, scene, nullptr);
  }

  GLuint texture(int unread = 0) { return gpu->texture(*scene, 0, false, CancelToken(), unread); }
  GLuint source() { return gpu->source(*scene, 0, false, CancelToken()); }

  std::unique_ptr<gl::Context> context = gl::Context::create(Backend::kAuto);
  pass::TextureStore store{*context};
  std::shared_ptr<Scene> scene;
  std::optional<pass::GpuScene> gpu;
};

TEST_F(GpuSceneTest, ASourceHasOneLevelAndGoes) {
  const GLuint made = source();
  EXPECT_EQ(source(), made) << "for all that is made of it";
  EXPECT_FALSE(gpu->isWhole(0));
  EXPECT_EQ(store.keptCount(), 0);
  gpu->dropSources();
  EXPECT_EQ(store.keptCount(), 1);
  EXPECT_EQ(store.uploadLargest(scene->images[0], false).texture.get(), made) << "the next one of one level has it";
  texture();
  EXPECT_TRUE(gpu->isWhole(0)) << "a draw reads all";
}

TEST_F(GpuSceneTest, ATextureThatIsWholeIsItsOwnSource) {
  const GLuint whole = texture();
  EXPECT_EQ(source(), whole);
  gpu->dropSources();
  EXPECT_EQ(store.keptCount(), 0);
}

TEST_F(GpuSceneTest, ATextureThatLacksLevelsIsNoSource) {
  const GLuint part = texture(2);
  if (gpu->isWhole(0)) GTEST_SKIP() << "another GL makes the levels";
  EXPECT_NE(source(), part);
  EXPECT_FALSE(gpu->isWhole(0)) << "it stays";
}

TEST_F(GpuSceneTest, OfTexturesWithALimitTheLevelThatItLeavesIsTheSource) {
  gpu->limitTextures(64);
  EXPECT_EQ(source(), texture());
}

}  // namespace
}  // namespace telar::gpu_scene_test
