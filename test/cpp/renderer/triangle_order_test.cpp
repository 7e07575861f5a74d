#include "pass/plan/triangle_order.h"

#include <gtest/gtest.h>

#include "renderer/cloth_images.h"

/// What lies in front is seen in front, in whatever order a file has its triangles.
namespace telar::triangle_order_test {
namespace {

using test::flatShot;
using test::netImage;
using test::sceneOf;
using test::squareCloth;

/// Two squares of one mesh that face each other's backs: a green one at z = 0.5 that faces the camera, a red one at -0.5.
/// @param turned  the red one faces away
Primitive layers(bool nearFirst, bool turned, float repeats) {
  const Primitive square = squareCloth(repeats);
  Primitive p;
  for (const bool near : {nearFirst, !nearFirst}) {
    const auto first = static_cast<std::uint32_t>(p.positions.size());
    for (std::size_t i = 0; i < 4; ++i) {
      p.positions.push_back(square.positions[i] + glm::vec3(0, 0, near ? 0.5f : -0.5f));
      p.normals.emplace_back(0, 0, near || !turned ? 1 : -1);
      p.uvs[0].push_back(square.uvs[0][i]);
      p.colors.emplace_back(near ? glm::vec4(0, 1, 0, 1) : glm::vec4(1, 0, 0, 1));
      p.bounds.add(glm::dvec3(p.positions.back()));
    }
    for (std::size_t i = 0; i < 6; ++i) p.indices.push_back(first + square.indices[near || !turned ? i : 5 - i]);
  }
  return p;
}

Shot shotOfPasses(int samples, double height = 1) {
  Shot shot = flatShot(32, height);
  shot.samples = samples;
  if (samples > Shot::SAMPLES_OF_A_PASS) shot.resolve = Resolve::kLinear;
  shot.lights = {{Shot::Light::Type::kAmbient}};
  return shot;
}

Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  return Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
}

/// Red and green of the middle.
glm::ivec2 middleOf(const Frame& frame) {
  const std::uint8_t* pixel = test::pixel8(frame, frame.width / 2, frame.height / 2);
  return {pixel[0], pixel[1]};
}

Material sheer() {
  Material material;
  material.metallicFactor = 0;
  material.alphaMode = AlphaMode::kBlend;
  material.doubleSided = true;
  material.baseColorFactor.a = 0.6f;
  return material;
}

class Order : public testing::TestWithParam<Projection> {};

TEST_P(Order, OfSheerClothInPicturesOfSeveralPassesIsFarToNear) {
  Shot shot = shotOfPasses(16);
  shot.camera.projection = GetParam();
  const Frame right = draw(sceneOf(layers(false, false, 1), sheer()), shot);
  const Frame wrong = draw(sceneOf(layers(true, false, 1), sheer()), shot);
  EXPECT_GT(middleOf(right).y, middleOf(right).x + 40) << "the near one is green";
  EXPECT_EQ(right.pixels, wrong.pixels);
  // One pass is what a browser shows: as the file has them.
  shot = shotOfPasses(4);
  const glm::ivec2 first = middleOf(draw(sceneOf(layers(false, false, 1), sheer()), shot));
  const glm::ivec2 last = middleOf(draw(sceneOf(layers(true, false, 1), sheer()), shot));
  EXPECT_GT(first.y, first.x);
  EXPECT_LT(last.y, last.x);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Order, testing::Values(Projection::kPerspective, Projection::kOrthographic),
                         [](const auto& test) {
                           return test.param == Projection::kPerspective ? "perspective" : "orthographic";
                         });

TEST(TriangleOrder, OnlyPicturesOfClothInSeveralPassesHaveOne) {
  const auto scene = sceneOf(layers(true, false, 1), sheer());
  const auto draws = [&](Shot shot) { return pass::planDraws(*scene, shot, Limits(), false).draws.blended; };
  EXPECT_EQ(draws(shotOfPasses(16)).size(), 1u);
  EXPECT_TRUE(draws(shotOfPasses(16))[0].ordered);
  EXPECT_EQ(draws(shotOfPasses(4)).size(), 2u) << "back faces, then front faces";
  EXPECT_FALSE(draws(shotOfPasses(4))[0].ordered);
  Material glass = sheer();
  glass.physical = true;
  glass.layers.transmissionFactor = 1;
  const auto pane = sceneOf(layers(true, false, 1), glass);
  EXPECT_EQ(pass::planDraws(*pane, shotOfPasses(16), Limits(), false).draws.transmissive.size(), 2u);
  Shot three = shotOfPasses(16);
  three.shading = ShadingModel::kThree;
  EXPECT_EQ(draws(three).size(), 2u);
  pass::FramePlan plan = pass::planDraws(*scene, shotOfPasses(16), Limits(), false);
  pass::orderTriangles(plan, CancelToken());
  EXPECT_EQ(*plan.draws.blended.at(0).farToNear, (std::vector<std::uint32_t>{2, 3, 0, 1}));
}

/// A net from far, whose sides that face away are blended before those that face the camera.
TEST(TriangleOrder, OfNetsIsByTheSideThatIsSeen) {
  Material net = sheer();
  net.alphaMode = AlphaMode::kMask;
  net.baseColorFactor.a = 1;
  net.baseColorTexture.image = 0;
  const auto netOf = [&](bool nearFirst) {
    auto scene = sceneOf(layers(nearFirst, true, 64), net);
    scene->images = std::vector<Image8>{netImage(64, 4, 0.4)};
    return scene;
  };
  const Shot shot = shotOfPasses(4, 2);
  const Frame right = draw(netOf(false), shot), wrong = draw(netOf(true), shot);
  EXPECT_GT(middleOf(right).y, middleOf(right).x + 40) << "the near one is green";
  EXPECT_EQ(right.pixels, wrong.pixels);
}

}  // namespace
}  // namespace telar::triangle_order_test
