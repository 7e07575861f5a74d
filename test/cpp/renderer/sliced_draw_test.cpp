#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <set>
#include <thread>

#include "cpu_clock.h"
#include "expect_error.h"
#include "renderer/cloth_images.h"
#include "renderer/scenes.h"

// What is cut into slices gives the same bytes, and can be stopped.

namespace telar::sliced_draw_test {
namespace {

using test::CpuClock;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

constexpr double UNCUT = std::numeric_limits<double>::infinity();
/// Less than the GL takes for anything: each triangle is drawn alone, in parts of 64 x 64 pixels.
constexpr double FINEST = 1e-9;

std::unique_ptr<Renderer> rendererWith(double sliceMs) {
  RendererOptions options;
  options.sliceMs = sliceMs;
  return Renderer::create(options);
}

Frame drawn(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot,
            const CancelToken& cancel = {}) {
  FrameInfo info;
  return renderer.draw(scene, shot, {}, cancel, info);
}

/// Curved lines of one kind through the picture.
Primitive linesOf(Topology topology, bool indexed) {
  Primitive p;
  p.topology = topology;
  constexpr std::uint32_t COUNT = 24;
  for (std::uint32_t i = 0; i < COUNT; ++i) {
    const float t = static_cast<float>(i) / COUNT * 6.2831853f;
    p.positions.push_back({1.1f * std::cos(3 * t), 1.1f * std::sin(2 * t), 0.3f * std::sin(t)});
    p.colors.push_back({std::cos(t) * 0.5f + 0.5f, 0.4f, std::sin(t) * 0.5f + 0.5f, 1});
    p.bounds.add(glm::dvec3(p.positions.back()));
    if (indexed) p.indices.push_back(COUNT - 1 - i);
  }
  return p;
}

/// A scene in which one thing hides, mirrors, blends with and shadows another.
std::shared_ptr<Scene> everything(Material material) {
  material.doubleSided = true;
  auto scene = sceneOf(spherePrimitive(0.8f, 4), material);
  Material other;
  other.baseColorFactor = {0.2f, 0.5f, 0.9f, 1};
  scene->materials.push_back(other);
  std::vector<Primitive> lines;
  for (const Topology topology : {Topology::kPoints, Topology::kLines, Topology::kLineStrip, Topology::kLineLoop}) {
    for (const bool indexed : {false, true}) {
      Primitive primitive = linesOf(topology, indexed);
      primitive.material = 1;
      lines.push_back(std::move(primitive));
    }
  }
  Primitive small = spherePrimitive(0.25f, 3);
  small.material = 1;
  scene->meshes.push_back({"lines", std::move(lines)});
  scene->meshes.push_back({"small", {std::move(small)}});
  Instances instances;
  for (int i = 0; i < 5; ++i) {
    instances.matrices.push_back(glm::translate(glm::mat4(1), glm::vec3(0.5f * static_cast<float>(i) - 1, 0.7f, 0.4f)));
    instances.colors.push_back({0.2f * static_cast<float>(i), 1, 0.5f});
  }
  instances.centers = {{0, 0.7, 0.4}};
  scene->nodes.resize(3);
  for (int i = 0; i < 3; ++i) scene->nodes[static_cast<std::size_t>(i)].mesh = i;
  scene->nodes[0].world = glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(1, 1, 0));
  scene->nodes[2].instances = std::make_shared<const Instances>(instances);
  scene->bounds.add(glm::dvec3(-1.3));
  scene->bounds.add(glm::dvec3(1.3));
  return scene;
}

Shot litShot() {
  Shot shot = shotOf(64);
  shot.width = 150;  // of whole tiles neither across nor up
  shot.height = 100;
  shot.samples = 4;
  for (const auto type : {Shot::Light::Type::kDirectional, Shot::Light::Type::kPoint}) {
    Shot::Light light{type};
    light.position = {1.5, 2.5, 2};
    light.intensity = type == Shot::Light::Type::kPoint ? 20 : 2;
    light.castShadow = true;
    light.shadow = {96, 1, 1, -0.002, 0.02, 0.5, 10, -3, 3, -3, 3, 1};
    shot.lights.push_back(light);
  }
  shot.ground = Shot::Ground{};
  shot.ground->opacity = 0.5;
  shot.ground->position = {0, -1, 0};
  shot.ground->size = {4, 4};
  return shot;
}

Material materialOf(AlphaMode mode) {
  Material material;
  material.alphaMode = mode;
  material.baseColorFactor = {0.9f, 0.4f, 0.3f, mode == AlphaMode::kOpaque ? 1.0f : 0.6f};
  return material;
}

class SlicesOf : public testing::TestWithParam<int> {};

TEST_P(SlicesOf, ChangeNoByte) {
  Material material = materialOf(GetParam() == 1 ? AlphaMode::kBlend : AlphaMode::kOpaque);
  Shot shot = litShot();
  if (GetParam() == 2) {
    material.physical = true;
    material.layers.transmissionFactor = 0.8f;
  }
  if (GetParam() == 3) shot.samples = 16, shot.resolve = Resolve::kLinear;
  if (GetParam() == 4) shot.samples = 1, shot.shading = ShadingModel::kFabric;
  const auto scene = everything(material);
  const Frame whole = drawn(*rendererWith(UNCUT), scene, shot);
  const Frame cut = drawn(*rendererWith(FINEST), scene, shot);
  ASSERT_EQ(whole.pixels.size(), cut.pixels.size());
  EXPECT_TRUE(whole.pixels == cut.pixels);
  EXPECT_GT(std::set<std::byte>(whole.pixels.begin(), whole.pixels.end()).size(), 50u)
      << "an empty picture says nothing";
}

INSTANTIATE_TEST_SUITE_P(AllKinds, SlicesOf, testing::Range(0, 5));

/// `count` squares over the whole picture that blend, one behind the other.
std::shared_ptr<Scene> stack(std::uint32_t count, std::size_t instances = 0) {
  auto scene = sceneOf(test::stackedSquares(count), materialOf(AlphaMode::kBlend));
  if (instances > 0) {
    Instances places;
    places.matrices.assign(instances, glm::mat4(1));
    places.centers = {{0, 0, 0}};
    scene->nodes[0].instances = std::make_shared<const Instances>(places);
  }
  return scene;
}

Shot stackShot() {
  Shot shot = shotOf(256);
  shot.samples = 4;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {0, 0, 3};
  shot.lights = {light};
  return shot;
}

/// A number of squares that take a second or two on this machine as it is now, and how long of CPU time.
struct Load {
  std::uint32_t squares;
  CpuClock::duration cpu;
};

Load measuredLoad() {
  constexpr std::uint32_t PROBE = 60;
  constexpr double WANTED = 1.5;
  const auto renderer = rendererWith(UNCUT);
  const auto scene = stack(PROBE);
  drawn(*renderer, scene, stackShot());
  const auto begin = std::chrono::steady_clock::now();
  const auto cpuBegin = CpuClock::now();
  drawn(*renderer, scene, stackShot());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const double many = WANTED / took.count();
  return {static_cast<std::uint32_t>(PROBE * many), (CpuClock::now() - cpuBegin) * many};
}

/// Returns when this process has computed for so long since `begin`.
void waitUntilComputed(CpuClock::time_point begin, CpuClock::duration cpu) {
  while (CpuClock::now() - begin < cpu) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// How much a renderer computes on when it is told to stop after a tenth of the load; nothing = it was done before.
CpuClock::duration workToStop(double sliceMs, const std::shared_ptr<const Scene>& scene, const Load& load) {
  const auto renderer = rendererWith(sliceMs);
  drawn(*renderer, stack(1), stackShot());
  const CancelToken cancel;
  std::promise<CpuClock::time_point> told;
  std::thread caller([&, begin = CpuClock::now()] {
    waitUntilComputed(begin, load.cpu / 10);
    told.set_value(CpuClock::now());
    cancel.cancel();
  });
  std::string code;
  try {
    drawn(*renderer, scene, stackShot(), cancel);
  } catch (const Error& error) {
    code = error.code;
  }
  const auto ended = CpuClock::now();
  caller.join();
  EXPECT_EQ(code, "X_CANCELLED");
  // What was stopped leaves a renderer that draws.
  EXPECT_EQ(drawn(*renderer, stack(1), stackShot()).pixels, drawn(*rendererWith(UNCUT), stack(1), stackShot()).pixels);
  return ended - told.get_future().get();
}

TEST(SlicedDraw, EndsSoonAfterItIsCancelled) {
  const Load load = measuredLoad();
  EXPECT_LT(workToStop(50, stack(load.squares), load), load.cpu / 4);
  // The same check sees a renderer that cuts nothing.
  EXPECT_GT(workToStop(UNCUT, stack(load.squares), load), load.cpu / 4);
}

TEST(SlicedDraw, EndsInTheMidstOfInstances) {
  const Load load = measuredLoad();
  EXPECT_LT(workToStop(50, stack(2, load.squares), load), load.cpu / 4);
}

TEST(SlicedDraw, ALateJobEndsWithATimeout) {
  const Load load = measuredLoad();
  const auto renderer = rendererWith(50);
  const CancelToken cancel(std::chrono::milliseconds(200));
  const CancelToken::Work work(cancel);
  const auto begin = CpuClock::now();
  try {
    drawn(*renderer, stack(load.squares), stackShot(), cancel);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "X_TIMEOUT");
  }
  EXPECT_LT(CpuClock::now() - begin, load.cpu / 2);
}

/// What is made of an environment is kept: it must not be read through what a stopped picture has left.
TEST(SlicedDraw, AStoppedPictureLeavesNothingToTheNextEnvironment) {
  const auto lit = [](Renderer& renderer) {
    Material metal;
    metal.roughnessFactor = 0.3f;
    metal.metallicFactor = 1;
    Shot shot = shotOf(96);
    shot.shading = ShadingModel::kFabric;
    shot.environment.source = Shot::Environment::Source::kStudio;
    shot.environmentSize = 128;  // not the one that is there already
    return drawn(renderer, sceneOf(spherePrimitive(0.8f, 4), metal), shot).pixels;
  };
  const Load load = measuredLoad();
  RendererOptions options;
  options.sliceMs = 20;
  options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  const auto expected = lit(*Renderer::create(options));
  const auto renderer = Renderer::create(options);
  // With a texture of which levels are not read, and which is looked up without blending.
  Material material = materialOf(AlphaMode::kBlend);
  material.baseColorTexture.image = 0;
  material.baseColorTexture.sampler.minFilter = material.baseColorTexture.sampler.magFilter = 9728;
  const auto textured = [&](std::uint32_t count) {
    Primitive squares = test::stackedSquares(count);
    squares.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    auto scene = sceneOf(std::move(squares), material);
    scene->images = SharedList<Image8>{test::imageOf(8, 8, [](double u, double) { return glm::vec4(u, 0.5, 0.5, 1); })};
    scene->fileImages = 1;
    return scene;
  };
  drawn(*renderer, textured(1), stackShot());  // so that its programs are there
  const auto scene = textured(load.squares);
  const CancelToken late(std::chrono::milliseconds(200));
  {
    const CancelToken::Work work(late);
    EXPECT_ERROR(drawn(*renderer, scene, stackShot(), late), "X_TIMEOUT");
  }
  EXPECT_TRUE(lit(*renderer) == expected);
}

/// How much is computed until a small picture is done while another renderer draws a large load.
CpuClock::duration workBeside(double sliceMs, const Load& load) {
  const auto renderer = rendererWith(50);
  drawn(*renderer, stack(1), stackShot());
  const CancelToken cancel;
  std::promise<void> begun;
  std::thread other([&] {
    const auto loaded = rendererWith(sliceMs);
    begun.set_value();
    try {
      drawn(*loaded, stack(load.squares), stackShot(), cancel);
    } catch (const Error& error) {
      EXPECT_EQ(error.code, "X_CANCELLED");
    }
  });
  begun.get_future().wait();
  waitUntilComputed(CpuClock::now(), load.cpu / 10);
  const auto begin = CpuClock::now();
  drawn(*renderer, stack(1), stackShot());
  const auto took = CpuClock::now() - begin;
  cancel.cancel();
  other.join();
  return took;
}

TEST(SlicedDraw, AnotherRendererDrawsMeanwhile) {
  const Load load = measuredLoad();
  // Beside one that cuts nothing it waits for all of that.
  EXPECT_LT(2 * workBeside(50, load), workBeside(UNCUT, load));
}

TEST(SlicedDraw, WhatIsTooMuchIsRefusedBeforeItIsDrawn) {
  RendererOptions options;
  options.limits.fragments = 1'000'000;
  const auto renderer = Renderer::create(options);
  const int objects = renderer->liveObjects();
  try {
    drawn(*renderer, stack(100), stackShot());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "L_FRAGMENTS");
  }
  EXPECT_EQ(renderer->liveObjects(), objects);
  EXPECT_NO_THROW(drawn(*renderer, stack(1), stackShot()));
}

}  // namespace
}  // namespace telar::sliced_draw_test
