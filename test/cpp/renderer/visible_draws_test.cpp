#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "renderer/scenes.h"

// Pictures without the triangles that nobody sees have the bytes of those with all of them.

namespace telar::visible_draws_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using LeaveOut = RendererOptions::LeaveOut;

std::unique_ptr<Renderer> rendererWith(LeaveOut hiddenTriangles) {
  RendererOptions options;
  options.hiddenTriangles = hiddenTriangles;
  options.visibilityBuffer = LeaveOut::kNever;
  return Renderer::create(options);
}

struct Drawn {
  Frame frame;
  std::size_t all = 0, hidden = 0;
};

Drawn drawn(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  Drawn out{renderer.draw(scene, shot, {}, {}, info)};
  const auto told = nlohmann::json::parse(info.json);
  out.all = told.at("triangles");
  out.hidden = told.at("hiddenTriangles");
  return out;
}

/// An open tube of cloth with folds, seen from inside and outside.
Primitive tube(float radius, int columns, int rows) {
  Primitive p;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const float turn = 6.2831853f * static_cast<float>(x) / static_cast<float>(columns);
      const float height = 2 * static_cast<float>(y) / static_cast<float>(rows) - 1;
      const float r = radius * (1 + 0.12f * std::sin(7 * turn + 3 * height));
      p.positions.emplace_back(r * std::sin(turn), height, r * std::cos(turn));
      p.normals.emplace_back(std::sin(turn), 0, std::cos(turn));
      p.uvs[0].emplace_back(turn, height);
      p.bounds.add(glm::dvec3(p.positions.back()));
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((y + j) * (columns + 1) + x + i); };
      for (const auto i : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)}) p.indices.push_back(i);
    }
  }
  // Triangles without area, as files have them.
  for (const std::uint32_t i : {0u, 0u, 1u, 5u, 5u, 5u}) p.indices.push_back(i);
  return p;
}

Material colored(const glm::vec3& color, AlphaMode mode, bool doubleSided) {
  Material material;
  material.baseColorFactor = {color, mode == AlphaMode::kBlend ? 0.5f : 1.0f};
  material.alphaMode = mode;
  material.doubleSided = doubleSided;
  material.roughnessFactor = 0.6f;
  return material;
}

/// One tube in another with a ball in it, a cut-out and a blended tube around, a mirrored copy, instances, vertices
/// without indices and lines.
std::shared_ptr<Scene> wardrobe(bool transmits) {
  auto scene = sceneOf(tube(0.6f, 60, 24), colored({0.8f, 0.3f, 0.3f}, AlphaMode::kOpaque, true));
  scene->materials.push_back(colored({0.3f, 0.7f, 0.3f}, AlphaMode::kOpaque, false));
  scene->materials.push_back(colored({0.3f, 0.4f, 0.9f}, AlphaMode::kMask, true));
  scene->materials.push_back(colored({0.9f, 0.9f, 0.3f}, AlphaMode::kBlend, true));
  if (transmits) {
    scene->materials[3] = colored({1, 1, 1}, AlphaMode::kOpaque, true);
    scene->materials[3].physical = true;
    scene->materials[3].layers.transmissionFactor = 0.7f;
  }
  Image8 holes{2, 2};
  holes.pixels = {255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 255};
  scene->images = SharedList<Image8>{std::vector<Image8>{holes}};
  scene->fileImages = 1;
  scene->materials[2].baseColorTexture.image = 0;
  Primitive loose = spherePrimitive(0.3f, 12);
  Primitive unindexed;
  for (const std::uint32_t i : loose.indices) {
    unindexed.positions.push_back(loose.positions[i]);
    unindexed.normals.push_back(loose.normals[i]);
  }
  unindexed.bounds = loose.bounds;
  Primitive line;
  line.topology = Topology::kLineStrip;
  line.positions = {{-1, -1, 0}, {1, 1, 0}, {1, -1, 1}};
  line.bounds = loose.bounds;
  std::vector<Primitive> meshes{tube(0.5f, 40, 16), spherePrimitive(0.4f, 20), unindexed, tube(0.75f, 30, 8), line};
  const int materials[] = {1, 1, 0, 2, 1};
  Instances instances;
  for (int i = 0; i < 3; ++i)
    instances.matrices.push_back(glm::translate(glm::mat4(1), glm::vec3(0.4f * static_cast<float>(i), 0.8f, 0.2f)));
  instances.centers = {{0, 0, 0}};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes[i].material = materials[i];
    scene->meshes.push_back({"more", {meshes[i]}});
    Node node;
    node.mesh = static_cast<int>(i) + 1;
    node.world = glm::translate(glm::dmat4(1), glm::dvec3(i == 2 ? 0.5 : 0.0, 0, 0));
    if (i == 0) node.world = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    scene->nodes.push_back(node);
  }
  Primitive last = tube(0.85f, 30, 6);
  last.material = 3;
  scene->meshes.push_back({"last", {last}});
  Node node;
  node.mesh = static_cast<int>(scene->meshes.size()) - 1;
  scene->nodes.push_back(node);
  node.mesh = 2;
  node.instances = std::make_shared<const Instances>(instances);
  scene->nodes.push_back(node);
  scene->fileMeshes = scene->meshes.size();
  scene->bounds = {};
  scene->bounds.add(glm::dvec3(-1.2));
  scene->bounds.add(glm::dvec3(1.2));
  return scene;
}

/// A shot from anywhere, inside too, where the near plane cuts triangles.
Shot shotFrom(std::mt19937& engine) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) * 0x1p-32;
  };
  Shot shot = shotOf(64);
  shot.width = static_cast<int>(between(40, 200));
  shot.height = static_cast<int>(between(40, 200));
  shot.samples = 4;
  const double distance = between(0.4, 6);
  const glm::dvec3 from(between(-1, 1), between(-1, 1), between(-1, 1));
  shot.camera.position = glm::normalize(from) * distance;
  shot.camera.target = {between(-0.3, 0.3), between(-0.3, 0.3), 0};
  shot.camera.fovY = between(15, 80);
  shot.camera.near = std::max(distance - 1.6, 0.02 * distance);
  shot.camera.far = distance + 2;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  return shot;
}

enum class Kind { kThree, kFabric, kTransmission, kShadows, kOrthographic, kFloats, kManySamples, kSlices, kCount };

Shot shotOf(Kind kind, std::mt19937& engine) {
  Shot shot = shotFrom(engine);
  if (kind == Kind::kFabric) shot.shading = ShadingModel::kFabric;
  if (kind == Kind::kShadows) {
    shot.lights[0].castShadow = true;
    shot.lights[0].shadow = {96, 1, 1, -0.002, 0.02, 0.5, 10, -3, 3, -3, 3, 1};
    shot.ground = Shot::Ground{};
    shot.ground->opacity = 0.5;
    shot.ground->position = {0, -1, 0};
    shot.ground->size = {4, 4};
  }
  if (kind == Kind::kOrthographic) {
    shot.camera.projection = Shot::Camera::Projection::kOrthographic;
    shot.camera.height = 2.2;
  }
  if (kind == Kind::kFloats) shot.resolve = Resolve::kLinear;
  if (kind == Kind::kManySamples) shot.samples = 16, shot.resolve = Resolve::kLinear;
  return shot;
}

class PicturesOf : public testing::TestWithParam<int> {};

TEST_P(PicturesOf, KeepTheirBytes) {
  const auto kind = static_cast<Kind>(GetParam());
  const auto scene = wardrobe(kind == Kind::kTransmission);
  RendererOptions options;
  options.hiddenTriangles = LeaveOut::kAlways;
  options.visibilityBuffer = LeaveOut::kNever;
  if (kind == Kind::kSlices) options.sliceMs = 1e-3;
  const auto whole = rendererWith(LeaveOut::kNever), less = Renderer::create(options);
  std::mt19937 engine(static_cast<std::uint32_t>(GetParam()));
  std::size_t hidden = 0, all = 0;
  // Slices of a microsecond wait for the GL after each triangle.
  const int shots = kind == Kind::kThree || kind == Kind::kFabric ? 40 : kind == Kind::kSlices ? 2 : 8;
  for (int i = 0; i < shots; ++i) {
    const Shot shot = shotOf(kind, engine);
    const Drawn a = drawn(*whole, scene, shot), b = drawn(*less, scene, shot);
    EXPECT_TRUE(a.frame.pixels == b.frame.pixels) << "picture " << i;
    EXPECT_EQ(a.hidden, 0u);
    hidden += b.hidden;
    all += b.all;
  }
  // A target of one sample, as one of many passes is, is drawn in full.
  if (kind == Kind::kManySamples) {
    EXPECT_EQ(hidden, 0u);
  } else {
    EXPECT_GT(hidden, all / 4);
  }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, PicturesOf, testing::Range(0, static_cast<int>(Kind::kCount)));

TEST(VisibleDraws, TheSameComparisonSeesOneTriangleLess) {
  auto scene = sceneOf(tube(0.6f, 60, 24), colored({0.8f, 0.3f, 0.3f}, AlphaMode::kOpaque, true));
  const auto renderer = rendererWith(LeaveOut::kNever);
  std::mt19937 engine(7);
  Shot shot = shotFrom(engine);
  shot.camera.position = {0, 0, 5};
  shot.width = shot.height = 200;
  const Frame whole = drawn(*renderer, scene, shot).frame;
  Primitive less = tube(0.6f, 60, 24);
  // Of the front, in the middle of the picture.
  for (const std::size_t triangle : {12u * 60 * 2, 12u * 60 * 2 + 5, 12u * 60 * 2 + 110}) {
    Primitive part = less;
    const auto at = part.indices.begin() + static_cast<std::ptrdiff_t>(triangle * 3);
    part.indices.erase(at, at + 3);
    const auto without = sceneOf(part, scene->materials[0]);
    EXPECT_FALSE(drawn(*renderer, without, shot).frame.pixels == whole.pixels) << triangle;
  }
}

TEST(VisibleDraws, AFaceOnTheNearPlaneHidesOnlyWhatItCovers) {
  auto scene = sceneOf(tube(0.6f, 60, 24), colored({0.8f, 0.3f, 0.3f}, AlphaMode::kOpaque, true));
  scene->materials.push_back(colored({0.3f, 0.7f, 0.3f}, AlphaMode::kOpaque, true));
  Primitive card = test::stackedSquares(1);
  card.material = 1;
  scene->meshes.push_back({"card", {card}});
  Node node;
  node.mesh = 1;
  scene->nodes.push_back(node);
  scene->fileMeshes = scene->meshes.size();
  scene->bounds.add(glm::dvec3(-3));
  scene->bounds.add(glm::dvec3(3));
  const auto whole = rendererWith(LeaveOut::kNever), less = rendererWith(LeaveOut::kAlways);
  std::mt19937 engine(11);
  std::size_t seen = 0, shots = 0;
  for (; shots < 48; ++shots) {
    Shot shot = shotFrom(engine);
    shot.width = shot.height = 64;
    const glm::dvec3 away = glm::normalize(shot.camera.position - shot.camera.target);
    shot.camera.near = 0.3 + 0.01 * static_cast<double>(shots);
    // A card across the view at that distance, turned by chance.
    const glm::dvec3 center = shot.camera.position - away * shot.camera.near;
    const glm::dmat4 turned = glm::inverse(glm::lookAt(glm::dvec3(0), -away, glm::dvec3(0, 1, 0)));
    scene->nodes[1].world =
        glm::translate(glm::dmat4(1), center) * turned * glm::scale(glm::dmat4(1), glm::dvec3(0.02));
    const Frame a = drawn(*whole, scene, shot).frame, b = drawn(*less, scene, shot).frame;
    EXPECT_TRUE(a.pixels == b.pixels) << "picture " << shots;
    const auto* middle = &a.pixels[static_cast<std::size_t>(32 * 64 + 32) * 4];
    seen += middle[1] > middle[0] ? 1 : 0;
  }
  // The rounding of the GL cuts some of these cards away.
  EXPECT_GT(seen, 0u);
  EXPECT_LT(seen, shots);
}

TEST(VisibleDraws, LooksOnlyWhereItPays) {
  const auto renderer = rendererWith(LeaveOut::kWhereItPays);
  const auto scene = wardrobe(false);
  std::mt19937 engine(3);
  Shot shot = shotFrom(engine);
  const bool software =
      nlohmann::json::parse(renderer->describe()).at("renderer").get<std::string>().find("llvmpipe") !=
      std::string::npos;
  EXPECT_EQ(drawn(*renderer, scene, shot).hidden > 0, software);
  shot.samples = 1;
  EXPECT_EQ(drawn(*renderer, scene, shot).hidden, 0u);
  shot.samples = 4;
  EXPECT_EQ(drawn(*renderer, sceneOf(test::stackedSquares(100)), shot).hidden, 0u) << "so few are drawn at once";
}

TEST(VisibleDraws, WhatHidesLittleIsNotLookedAtEachFrame) {
  const auto renderer = rendererWith(LeaveOut::kWhereItPays);
  const bool software =
      nlohmann::json::parse(renderer->describe()).at("renderer").get<std::string>().find("llvmpipe") !=
      std::string::npos;
  if (!software) GTEST_SKIP() << "it pays nowhere";
  // The back of a ball is turned away: the GL leaves it out by itself.
  const auto ball = sceneOf(spherePrimitive(1, 32), colored({0.5f, 0.5f, 0.5f}, AlphaMode::kOpaque, false));
  const auto tubes = wardrobe(false);
  Shot shot = shotOf(64);
  shot.samples = 4;
  int looks = 0, looksAtTubes = 0;
  for (int i = 0; i < 32; ++i) {
    looks += drawn(*renderer, ball, shot).hidden > 0 ? 1 : 0;
    looksAtTubes += drawn(*renderer, tubes, shot).hidden > 0 ? 1 : 0;
  }
  EXPECT_EQ(looks, 2);
  EXPECT_EQ(looksAtTubes, 32);
}

}  // namespace
}  // namespace telar::visible_draws_test
