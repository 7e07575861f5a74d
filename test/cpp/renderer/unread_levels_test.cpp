#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "renderer/scenes.h"

// Pictures whose textures lack the levels that no fragment reads, beside those with whole textures.

namespace telar::unread_levels_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using LeaveOut = RendererOptions::LeaveOut;

struct Drawn {
  std::vector<std::byte> pixels;
  std::uint64_t unread = 0;
};

struct Job {
  std::shared_ptr<const Scene> scene;
  Shot shot;
};

/// One after the other, by one renderer: a thread has one context.
/// @param use  never: triangle by triangle, and textures are whole
std::vector<Drawn> drawn(LeaveOut use, const std::vector<Job>& jobs) {
  RendererOptions options;
  options.visibilityBuffer = use;
  const auto renderer = Renderer::create(options);
  std::vector<Drawn> out;
  for (const Job& job : jobs) {
    FrameInfo info;
    Frame frame = renderer->draw(job.scene, job.shot, {}, {}, info);
    out.push_back({std::move(frame.pixels), nlohmann::json::parse(info.json).value("unreadTexels", std::uint64_t{0})});
  }
  return out;
}

Drawn drawn(const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  return drawn(LeaveOut::kAlways, {{scene, shot}})[0];
}

/// Each level of noise differs from every other one.
Image8 noise(std::uint32_t width, std::uint32_t height) {
  Image8 image{width, height, ZeroedBytes(std::size_t{4} * width * height)};
  std::uint32_t state = 7;
  for (std::uint8_t& byte : image.pixels) {
    state = state * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return image;
}

/// The same images are made once.
SharedList<Image8> images(std::uint32_t width, std::uint32_t height) {
  static std::map<std::pair<std::uint32_t, std::uint32_t>, SharedList<Image8>> made;
  const auto [found, isNew] = made.try_emplace({width, height});
  if (isNew) found->second = SharedList<Image8>{std::vector<Image8>{noise(width, height), noise(512, 1024)}};
  return found->second;
}

std::shared_ptr<Scene> ball(std::uint32_t width, std::uint32_t height) {
  Material material;
  material.roughnessFactor = 0.5f;
  material.metallicFactor = 0;
  material.baseColorTexture.image = 0;
  material.normalTexture.image = 1;
  material.normalTexture.uvTransform = glm::mat3(3, 0, 0, 0, 2, 0, 0.1f, 0, 1);
  auto scene = sceneOf(spherePrimitive(1, 48), material);
  scene->images = images(width, height);
  scene->fileImages = 2;
  return scene;
}

Shot litShot(int size) {
  Shot shot = shotOf(size);
  shot.samples = 4;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  return shot;
}

constexpr std::uint64_t LEVEL_0 = 1024 * 1024;

bool glMakesLevels() { return drawn(ball(1024, 1024), litShot(40)).unread == 0; }

TEST(UnreadLevels, NoByteDiffers) {
  if (glMakesLevels()) GTEST_SKIP();
  std::vector<Job> jobs;
  for (const auto& [width, height] : {std::pair{1024u, 1024u}, {4096u, 256u}, {512u, 1024u}}) {
    for (const int size : {40, 96}) {
      for (const std::uint32_t filter : {9987u, 9984u}) {
        auto scene = ball(width, height);
        scene->materials[0].baseColorTexture.sampler.minFilter = filter;
        scene->materials[0].baseColorTexture.sampler.wrapS = 33071;
        jobs.push_back({scene, litShot(size)});
      }
    }
  }
  const std::vector<Drawn> whole = drawn(LeaveOut::kNever, jobs), part = drawn(LeaveOut::kAlways, jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_TRUE(whole[i].pixels == part[i].pixels) << i;
    EXPECT_GE(part[i].unread, jobs[i].shot.width == 40 ? LEVEL_0 / 2 : 0u) << i;
    EXPECT_EQ(whole[i].unread, 0u);
  }
}

TEST(UnreadLevels, AreThereWhenTheyAreRead) {
  std::vector<Job> jobs;
  const auto scene = ball(1024, 1024);
  for (const int size : {40, 96, 700, 40}) jobs.push_back({scene, litShot(size)});
  const std::vector<Drawn> whole = drawn(LeaveOut::kNever, jobs), part = drawn(LeaveOut::kAlways, jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_TRUE(whole[i].pixels == part[i].pixels) << i;
    EXPECT_LE(part[i].unread, part[i > 0 ? i - 1 : 0].unread) << i;
  }
  EXPECT_EQ(part[2].unread, 0u);
  EXPECT_EQ(part[3].unread, 0u) << "what is there stays";
}

/// The ball in cloth, with metal in patches: of its normal map relief is made, of its colour what is metal's.
std::shared_ptr<Scene> clothBall(std::uint32_t width, std::uint32_t height) {
  auto scene = ball(width, height);
  scene->materials[0].metallicFactor = 0.7f;
  scene->materials[0].metallicRoughnessTexture.image = 0;
  scene->materials[0].normalTexture.uvTransform = glm::mat3(1);
  scene->materials[0].normalTexture.image = 0;
  return scene;
}

TEST(UnreadLevels, OfWhatIsMadeOfImagesNoByteDiffers) {
  if (glMakesLevels()) GTEST_SKIP();
  std::vector<Job> jobs;
  const auto kept = clothBall(1024, 1024);
  for (const int size : {40, 96, 700, 40}) {
    for (const auto& scene : {kept, clothBall(1024, 1024), clothBall(2048, 512)}) {
      Shot shot = litShot(size);
      shot.shading = ShadingModel::kFabric;
      jobs.push_back({scene, shot});
    }
  }
  const std::vector<Drawn> whole = drawn(LeaveOut::kNever, jobs), part = drawn(LeaveOut::kAlways, jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_TRUE(whole[i].pixels == part[i].pixels) << i;
    const bool isNew = i % 3 > 0, isSmall = jobs[i].shot.width == 40;
    EXPECT_GE(part[i].unread, isNew && isSmall ? LEVEL_0 : 0u) << i;
  }
  EXPECT_GE(part[0].unread, LEVEL_0);
  EXPECT_EQ(part[6].unread, 0u) << "all is there once it is read";
  EXPECT_EQ(part[9].unread, 0u) << "and stays";
}

// Those of triangles that are shaded together: by textures that a near picture has made whole, and by others.
TEST(UnreadLevels, NoByteOfMergedQuadsDiffers) {
  const auto scene = ball(1024, 1024);
  Shot merged = litShot(96);
  merged.mergeQuads = true;
  const Drawn part = drawn(scene, merged),
              whole = drawn(LeaveOut::kAlways, {{scene, litShot(700)}, {scene, merged}})[1];
  EXPECT_TRUE(part.pixels == whole.pixels);
  EXPECT_EQ(whole.unread, 0u);
}

// Planted fault: a level that is read is another.
TEST(UnreadLevels, ADifferenceInALevelIsSeen) {
  const auto scene = ball(1024, 1024), other = ball(1024, 1024);
  std::vector<Image8> changed{scene->images[0], scene->images[1]};
  for (std::size_t i = 0; i < changed[0].pixels.size(); i += 4) changed[0].pixels[i] ^= 16;
  other->images = SharedList<Image8>{std::move(changed)};
  const std::vector<Drawn> both = drawn(LeaveOut::kAlways, {{scene, litShot(96)}, {other, litShot(96)}});
  EXPECT_FALSE(both[0].pixels == both[1].pixels);
}

TEST(UnreadLevels, MapsThatAreReadOtherwiseAreWhole) {
  const auto unreadOf = [](const std::shared_ptr<Scene>& scene, const Shot& shot) { return drawn(scene, shot).unread; };
  auto scene = ball(1024, 1024);
  const std::uint64_t all = unreadOf(scene, litShot(40));
  if (all == 0) GTEST_SKIP() << "the GL makes the levels";
  scene->materials[0].baseColorTexture.sampler.minFilter = 9729;  // linear, level 0 alone
  EXPECT_LT(unreadOf(scene, litShot(40)), all);
  EXPECT_GT(unreadOf(scene, litShot(40)), 0u) << "the normal map's are";
  scene = ball(1024, 1024);
  scene->materials[0].normalTexture.image = -1;
  scene->materials[0].physical = true;
  scene->materials[0].layers.bumpTexture.image = 0;
  EXPECT_EQ(unreadOf(scene, litShot(40)), 0u);
  Shot passes = litShot(40);  // maps in full detail
  passes.samples = 16;
  passes.resolve = Resolve::kLinear;
  EXPECT_EQ(unreadOf(ball(1024, 1024), passes), 0u);
  const std::uint64_t small = unreadOf(ball(256, 256), litShot(40));  // whole, but for the normal map
  EXPECT_GT(small, 0u);
  EXPECT_LT(small, all);
}

}  // namespace
}  // namespace telar::unread_levels_test
