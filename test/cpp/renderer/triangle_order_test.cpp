#include "pass/plan/triangle_order.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

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

TEST_P(Order, OfSheerClothIsFarToNear) {
  for (const int samples : {4, 16}) {
    Shot shot = shotOfPasses(samples);
    shot.camera.projection = GetParam();
    const Frame right = draw(sceneOf(layers(false, false, 1), sheer()), shot);
    const Frame wrong = draw(sceneOf(layers(true, false, 1), sheer()), shot);
    EXPECT_GT(middleOf(right).y, middleOf(right).x + 40) << "the near one is green";
    EXPECT_EQ(right.pixels, wrong.pixels);
  }
}

TEST_P(Order, OfTheShadingThreeIsThatOfTheFile) {
  Shot shot = shotOfPasses(4);
  shot.camera.projection = GetParam();
  shot.shading = ShadingModel::kThree;
  const glm::ivec2 first = middleOf(draw(sceneOf(layers(false, false, 1), sheer()), shot));
  const glm::ivec2 last = middleOf(draw(sceneOf(layers(true, false, 1), sheer()), shot));
  EXPECT_GT(first.y, first.x);
  EXPECT_LT(last.y, last.x);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Order, testing::Values(Projection::kPerspective, Projection::kOrthographic),
                         [](const auto& test) {
                           return test.param == Projection::kPerspective ? "perspective" : "orthographic";
                         });

TEST(TriangleOrder, OnlyClothHasOne) {
  const auto scene = sceneOf(layers(true, false, 1), sheer());
  const auto draws = [&](Shot shot) { return pass::planDraws(*scene, shot, Limits(), false).draws.blended; };
  for (const int samples : {4, 16}) {
    EXPECT_EQ(draws(shotOfPasses(samples)).size(), 1u);
    EXPECT_TRUE(draws(shotOfPasses(samples))[0].ordered);
  }
  Material glass = sheer();
  glass.physical = true;
  glass.layers.transmissionFactor = 1;
  const auto pane = sceneOf(layers(true, false, 1), glass);
  EXPECT_EQ(pass::planDraws(*pane, shotOfPasses(16), Limits(), false).draws.transmissive.size(), 2u);
  Shot three = shotOfPasses(16);
  three.shading = ShadingModel::kThree;
  EXPECT_EQ(draws(three).size(), 2u) << "back faces, then front faces";
  EXPECT_FALSE(draws(three)[0].ordered);
  pass::FramePlan plan = pass::planDraws(*scene, shotOfPasses(16), Limits(), false);
  pass::orderTriangles(plan, CancelToken());
  EXPECT_EQ(*plan.draws.blended.at(0).farToNear, (std::vector<std::uint32_t>{2, 3, 0, 1}));
}

/// From far, where a net is there in part.
TEST(TriangleOrder, OfNetsIsFarToNearWhicheverSideIsSeen) {
  Material net = sheer();
  net.alphaMode = AlphaMode::kMask;
  net.baseColorFactor.a = 1;
  net.baseColorTexture.image = 0;
  const auto netOf = [&](bool nearFirst, bool turned) {
    auto scene = sceneOf(layers(nearFirst, turned, 64), net);
    scene->images = std::vector<Image8>{netImage(64, 4, 0.4)};
    return scene;
  };
  const Shot shot = shotOfPasses(4, 2);
  for (const bool turned : {false, true}) {
    const Frame right = draw(netOf(false, turned), shot), wrong = draw(netOf(true, turned), shot);
    EXPECT_GT(middleOf(right).y, middleOf(right).x + 40) << "the near one is green";
    EXPECT_EQ(right.pixels, wrong.pixels);
  }
}

/// Instances have no order of their own: sides that face away are blended before those that face the camera.
TEST(TriangleOrder, OfInstancedNetsIsByTheSideThatIsSeen) {
  Material net = sheer();
  net.alphaMode = AlphaMode::kMask;
  net.baseColorFactor.a = 1;
  net.baseColorTexture.image = 0;
  std::vector<Frame> frames;
  for (const bool nearFirst : {false, true}) {
    auto scene = sceneOf(layers(nearFirst, true, 64), net);
    scene->images = std::vector<Image8>{netImage(64, 4, 0.4)};
    Instances one;
    one.matrices = {glm::mat4(1)};
    one.centers = {glm::dvec3(0)};
    scene->nodes.at(0).instances = std::make_shared<Instances>(one);
    EXPECT_FALSE(pass::planDraws(*scene, shotOfPasses(4, 2), Limits(), false).draws.blended.at(0).ordered);
    frames.push_back(draw(scene, shotOfPasses(4, 2)));
  }
  EXPECT_GT(middleOf(frames[0]).y, middleOf(frames[0]).x + 40) << "the near one is green";
  EXPECT_EQ(frames[0].pixels, frames[1].pixels);
}

/// A third square behind an opaque sheet is left out, and the others stay in order.
TEST(TriangleOrder, OfWhatIsNotHidden) {
  Primitive cloth = layers(true, false, 1);
  const auto first = static_cast<std::uint32_t>(cloth.positions.size());
  for (std::uint32_t i = 0; i < 4; ++i) {
    cloth.positions.push_back(cloth.positions[i] - glm::vec3(0, 0, 2));
    cloth.normals.push_back(cloth.normals[i]);
    cloth.uvs[0].push_back(cloth.uvs[0][i]);
    cloth.colors.emplace_back(0, 0, 1, 1);
    cloth.bounds.add(glm::dvec3(cloth.positions.back()));
  }
  for (std::uint32_t i = 0; i < 6; ++i) cloth.indices.push_back(first + cloth.indices[i]);
  auto scene = sceneOf(cloth, sheer());
  Primitive sheet = squareCloth(1);
  sheet.material = 1;
  scene->materials.emplace_back();
  scene->meshes.emplace_back().primitives = std::vector<Primitive>{sheet};
  scene->nodes.push_back(scene->nodes.at(0));
  scene->nodes.at(1).mesh = 1;
  scene->nodes.at(1).world = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -1)), glm::dvec3(2));
  std::vector<Frame> frames;
  for (const auto use : {RendererOptions::LeaveOut::kNever, RendererOptions::LeaveOut::kAlways}) {
    RendererOptions options;
    options.hiddenTriangles = use;
    options.visibilityBuffer = RendererOptions::LeaveOut::kNever;
    FrameInfo info;
    frames.push_back(Renderer::create(options)->draw(scene, shotOfPasses(4, 4), {}, CancelToken(), info));
    const std::size_t hidden = use == RendererOptions::LeaveOut::kAlways ? 2 : 0;
    EXPECT_EQ(nlohmann::json::parse(info.json).at("hiddenTriangles"), hidden);
  }
  EXPECT_EQ(frames[0].pixels, frames[1].pixels);
}

}  // namespace
}  // namespace telar::triangle_order_test
