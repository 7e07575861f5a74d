#include "pass/plan/partial_coverage.h"

#include <gtest/gtest.h>

#include "renderer/cloth_images.h"

/// A net that is there in part everywhere is drawn once, and looks as if it were drawn for its whole parts too.
namespace telar::partial_coverage_test {
namespace {

using test::flatShot;
using test::netImage;
using test::sceneOf;
using test::squareCloth;

constexpr int SIZE = 128;
constexpr std::uint32_t TEXELS = 64;  ///< four meshes with threads of four texels

/// A net of 512 texels a metre.
std::shared_ptr<Scene> netOf(Image8 image, Primitive primitive = squareCloth(16), Sampler sampler = {}) {
  Material material;
  material.metallicFactor = 0;
  material.alphaMode = AlphaMode::kMask;
  material.baseColorTexture.image = 0;
  material.baseColorTexture.sampler = sampler;
  auto scene = sceneOf(std::move(primitive), std::move(material));
  scene->images = std::vector<Image8>{std::move(image)};
  return scene;
}

Image8 net() { return netImage(TEXELS, 4, 0.25); }

/// The net with a square of so many texels without holes.
Image8 patched(std::uint32_t side) {
  Image8 image = net();
  for (std::uint32_t y = 16; y < 16 + side; ++y) {
    for (std::uint32_t x = 16; x < 16 + side; ++x) image.pixels[(std::size_t{y} * TEXELS + x) * 4 + 3] = 255;
  }
  return image;
}

/// The square, and beside the picture a triangle whose texture does not move: nothing is known of how near its texels are seen.
Primitive besideAStillTriangle() {
  Primitive p = squareCloth(16);
  for (const glm::vec3& corner : {glm::vec3(90, 0, 0), glm::vec3(91, 0, 0), glm::vec3(90, 1, 0)}) {
    p.indices.push_back(static_cast<std::uint32_t>(p.positions.size()));
    p.positions.push_back(corner);
    p.normals.emplace_back(0, 0, 1);
    p.tangents.emplace_back(1, 0, 0, 1);
    p.uvs[0].emplace_back(0);
    p.bounds.add(glm::dvec3(corner));
  }
  return p;
}

class PartialCoverage : public testing::Test {
 protected:
  bool isPartial(const std::shared_ptr<Scene>& scene, const Shot& shot) {
    const pass::GpuScene gpu(*context_, store_, scene, nullptr);
    pass::FramePlan plan = pass::planDraws(*scene, shot, Limits(), false);
    pass::findPartial(plan, *scene, shot, gpu, CancelToken());
    EXPECT_EQ(plan.draws.blended.size(), 1u);
    EXPECT_TRUE(plan.draws.blended.at(0).blendsCoverage);
    return plan.draws.blended.at(0).isPartial;
  }
  /// @param texels  of the net, for each pixel
  bool isPartial(const std::shared_ptr<Scene>& scene, double texels) {
    return isPartial(scene, flatShot(SIZE, texels * SIZE / 512));
  }
  std::unique_ptr<gl::Context> context_ = gl::Context::create(Backend::kAuto);
  pass::TextureStore store_{*context_};
};

TEST_F(PartialCoverage, ByTheLargestPartWithoutHoles) {
  EXPECT_FALSE(isPartial(netOf(net()), 1));
  EXPECT_FALSE(isPartial(netOf(net()), 4));  // level 2: threads are as wide as a texel
  EXPECT_TRUE(isPartial(netOf(net()), 12));
  EXPECT_FALSE(isPartial(netOf(patched(16)), 12));
  EXPECT_TRUE(isPartial(netOf(patched(16)), 40));
  EXPECT_FALSE(isPartial(netOf(patched(48)), 20));
}

TEST_F(PartialCoverage, ThoughAFewTexelsOfItAreMissing) {
  // Level 4, 256 texels: 98.5 of 100 make it whole.
  Image8 image = patched(16);
  const auto remove = [&](std::uint32_t i) { image.pixels[((16 + i) * TEXELS + 16 + 2 * i) * 4 + 3] = 0; };
  EXPECT_FALSE(isPartial(netOf(image), 24));
  for (const std::uint32_t i : {0, 1, 2}) remove(i);
  EXPECT_FALSE(isPartial(netOf(image), 24));
  remove(3);
  EXPECT_TRUE(isPartial(netOf(image), 24));
}

TEST_F(PartialCoverage, ByEachCutoffOfAnImage) {
  Image8 image = patched(16);
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] /= 2;
  auto scene = netOf(image);
  scene->materials.at(0).alphaCutoff = 0.4f;
  scene->materials.push_back(scene->materials.at(0));
  scene->materials.at(1).alphaCutoff = 0.6f;
  Primitive second = squareCloth(16);
  second.material = 1;
  scene->meshes.emplace_back().primitives = std::vector<Primitive>{second};
  scene->nodes.push_back(scene->nodes.at(0));
  scene->nodes.at(1).mesh = 1;
  const pass::GpuScene gpu(*context_, store_, scene, nullptr);
  pass::FramePlan plan = pass::planDraws(*scene, flatShot(SIZE, 24.0 * SIZE / 512), Limits(), false);
  pass::findPartial(plan, *scene, flatShot(SIZE, 24.0 * SIZE / 512), gpu, CancelToken());
  ASSERT_EQ(plan.draws.blended.size(), 2u);
  for (const pass::DrawItem& item : plan.draws.blended) EXPECT_EQ(item.isPartial, item.material->alphaCutoff > 0.5f);
}

TEST_F(PartialCoverage, OnlyWhereTheLevelIsKnown) {
  Sampler sharp;
  sharp.minFilter = 9729;
  EXPECT_FALSE(isPartial(netOf(net(), squareCloth(16), sharp), 12));
  EXPECT_FALSE(isPartial(netOf(net(), besideAStillTriangle()), 12));
  EXPECT_FALSE(isPartial(netOf(netImage(60, 4, 0.25)), 12));  // its levels are no halves
  auto enlarged = netOf(net());
  enlarged->nodes.at(0).world = glm::scale(glm::dmat4(1), glm::dvec3(1, 4, 1));
  EXPECT_FALSE(isPartial(enlarged, 12));
}

TEST_F(PartialCoverage, ATexelThatEqualsTheCutoffMayBeThere) {
  Image8 image = netImage(TEXELS, 4, 2);
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 51;
  auto scene = netOf(image);
  scene->materials.at(0).alphaCutoff = 0.2f;  // 255 times that is above 51
  EXPECT_FALSE(isPartial(scene, 12));
  scene->materials.at(0).alphaCutoff = 0.21f;
  EXPECT_TRUE(isPartial(scene, 12));
}

TEST_F(PartialCoverage, OfANodeWithoutSizeNothingFails) {
  auto scene = netOf(net());
  scene->nodes.at(0).world = glm::scale(glm::dmat4(1), glm::dvec3(0));
  EXPECT_TRUE(isPartial(scene, 12));
}

TEST_F(PartialCoverage, OfAPerspectiveByWhatIsNext) {
  Shot shot = flatShot(SIZE, 0);
  shot.camera.projection = Projection::kPerspective;
  EXPECT_TRUE(isPartial(netOf(net()), shot));  // 11 texels a pixel, 5 metres away
  auto nearer = netOf(net());
  nearer->bounds.add(glm::dvec3(0, 0, 4));
  EXPECT_FALSE(isPartial(nearer, shot));
  shot.camera.fovY = 10;
  EXPECT_FALSE(isPartial(netOf(net()), shot));
}

TEST_F(PartialCoverage, PicturesHaveTheBytesOfBothDraws) {
  const auto renderer = Renderer::create({});
  const auto draw = [&](const std::shared_ptr<Scene>& scene, const Shot& shot) {
    FrameInfo info;
    return renderer->draw(scene, shot, {}, CancelToken(), info).pixels;
  };
  int once = 0;
  for (const auto& image : {net(), patched(12), patched(40)}) {
    const auto scene = netOf(image), both = netOf(image, besideAStillTriangle());
    for (const double texels : {2.0, 4.5, 7.0, 9.0, 12.0, 17.0, 30.0, 60.0}) {
      Shot shot = flatShot(SIZE, texels * SIZE / 512);
      shot.samples = 4;
      shot.lights.push_back({Shot::Light::Type::kAmbient});
      once += isPartial(scene, shot) ? 1 : 0;
      ASSERT_FALSE(isPartial(both, shot));
      EXPECT_EQ(draw(scene, shot), draw(both, shot)) << texels << " texels a pixel";
    }
  }
  EXPECT_GT(once, 8);
}

}  // namespace
}  // namespace telar::partial_coverage_test
