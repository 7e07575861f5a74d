#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pass/texture/mip_levels.h"
#include "renderer/scenes.h"

// quality.textureSize: larger textures are read from the mip level that fits.

namespace telar::texture_size_test {
namespace {

using test::pixel8;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

struct Job {
  std::shared_ptr<const Scene> scene;
  Shot shot;
};

/// One after the other, by one renderer.
std::vector<Frame> drawn(const std::vector<Job>& jobs) {
  const auto renderer = Renderer::create({});
  std::vector<Frame> out;
  for (const Job& job : jobs) {
    FrameInfo info;
    out.push_back(renderer->draw(job.scene, job.shot, {}, {}, info));
  }
  return out;
}

/// Whether this GL's mip levels are those of halveSrgb() and halveLinear().
bool hasKnownLevels() {
  FrameInfo info;
  Renderer::create({})->draw(sceneOf(spherePrimitive(1, 4)), shotOf(4), {}, {}, info);
  const std::string version = nlohmann::json::parse(info.json)["gl"]["version"];
  return pass::canHalveSrgb() && version.find("Mesa 22.3.") != std::string::npos;
}

Image8 noise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
  Image8 image{width, height, ZeroedBytes(std::size_t{4} * width * height)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    seed = seed * 1664525u + 1013904223u;
    // Normals that lean, and colours of every kind.
    image.pixels[i] = i % 4 == 2 ? 255 : static_cast<std::uint8_t>(96 + (seed >> 26));
  }
  return image;
}

Image8 halved(const Image8& image, bool srgb, int times) {
  pass::MipLevel from{image.width, image.height, image.pixels}, to;
  for (; times > 0; --times) {
    (srgb ? pass::halveSrgb : pass::halveLinear)(from.texels.data(), from.width, from.height, to);
    std::swap(from, to);
  }
  return {from.width, from.height, from.texels};
}

std::shared_ptr<Scene> ballOf(std::vector<Image8> images) {
  Material material;
  material.roughnessFactor = 0.5f;
  material.metallicFactor = 0;
  material.baseColorTexture.image = 0;
  if (images.size() > 1) material.normalTexture.image = 1;
  auto scene = sceneOf(spherePrimitive(1, 48), material);
  scene->fileImages = images.size();
  scene->images = SharedList<Image8>{std::move(images)};
  return scene;
}

Shot litShot(int textureSize, ShadingModel shading = ShadingModel::kThree) {
  Shot shot = shotOf(96);
  shot.samples = 4;
  shot.shading = shading;
  shot.textureSize = textureSize;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  return shot;
}

TEST(TextureSize, IsThePictureOfSmallerImages) {
  if (!hasKnownLevels()) GTEST_SKIP() << "levels of another GL";
  const Image8 color = noise(512, 512, 7), normals = noise(256, 512, 9);
  const auto whole = ballOf({color, normals}), small = ballOf({halved(color, true, 3), halved(normals, false, 3)});
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kFabric}) {
    const auto pictures = drawn({{whole, litShot(0, shading)},
                                 {whole, litShot(64, shading)},
                                 {small, litShot(0, shading)},
                                 {whole, litShot(100, shading)},
                                 {whole, litShot(512, shading)},
                                 {whole, litShot(0, shading)}});
    EXPECT_TRUE(pictures[1].pixels == pictures[2].pixels) << "a level of 64 texels is read";
    EXPECT_TRUE(pictures[3].pixels == pictures[2].pixels) << "the next that fits";
    EXPECT_FALSE(pictures[1].pixels == pictures[0].pixels);
    EXPECT_TRUE(pictures[4].pixels == pictures[0].pixels) << "all fit";
    EXPECT_TRUE(pictures[5].pixels == pictures[0].pixels) << "whole again";
  }
}

TEST(TextureSize, HoldsForTexturesThatAnotherShadingHadBefore) {
  const auto scene = ballOf({noise(512, 512, 7), noise(512, 512, 9)});
  const std::vector<Job> jobs{{scene, litShot(0, ShadingModel::kFabric)},
                              {scene, litShot(0)},
                              {scene, litShot(64, ShadingModel::kFabric)},
                              {scene, litShot(64)},
                              {scene, litShot(0, ShadingModel::kFabric)}};
  const auto pictures = drawn(jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) EXPECT_TRUE(pictures[i].pixels == drawn({jobs[i]})[0].pixels) << i;
}

TEST(TextureSize, HoldsForTexturesThatAnotherModelHadBefore) {
  const auto one = ballOf({noise(100, 60, 7)}), other = ballOf({noise(100, 60, 8)});
  const Frame expected = drawn({{other, litShot(0)}})[0];
  const auto renderer = Renderer::create({});
  FrameInfo info;
  const Frame small = renderer->draw(one, litShot(10), {}, {}, info);
  EXPECT_FALSE(small.pixels == renderer->draw(one, litShot(0), {}, {}, info).pixels) << "not of powers of two";
  renderer->draw(one, litShot(10), {}, {}, info);
  renderer->release(*one);
  EXPECT_TRUE(renderer->draw(other, litShot(0), {}, {}, info).pixels == expected.pixels);
}

TEST(TextureSize, ReadsTheFilesOwnLevels) {
  const auto plain = [](std::uint32_t side, std::array<std::uint8_t, 4> texel) {
    ZeroedBytes out(std::size_t{4} * side * side);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = texel[i % 4];
    return out;
  };
  Image8 image{64, 64, plain(64, {200, 0, 0, 255})};
  image.ownLevels = true;
  image.missingLevels = MissingLevels::kNone;
  image.smallerLevels.push_back(plain(32, {0, 200, 0, 255}));
  const auto scene = ballOf({image});
  Shot shot = litShot(0);
  shot.width = shot.height = 256;
  const auto at = [](const Frame& frame) { return pixel8(frame, 140, 100); };
  shot.textureSize = 0;
  const Frame whole = drawn({{scene, shot}})[0];
  EXPECT_GT(at(whole)[0], at(whole)[1]);
  for (const int size : {32, 8}) {
    shot.textureSize = size;
    const Frame small = drawn({{scene, shot}})[0];
    EXPECT_GT(at(small)[1], at(small)[0]) << "there is no smaller one";
  }
}

}  // namespace
}  // namespace telar::texture_size_test
