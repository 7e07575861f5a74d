#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "renderer/scenes.h"

/// Programs of earlier frames are dropped at times, and none that a frame still draws with.
namespace telar::kept_programs_test {
namespace {

/// Kinds of surfaces that have a program each.
std::vector<std::shared_ptr<const Scene>> kindsOfScenes() {
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (int kind = 0; kind < 8; ++kind) {
    Material material;
    material.physical = true;
    if (kind & 1) material.layers.clearcoatFactor = 0.5f;
    if (kind & 2) material.layers.sheenColorFactor = glm::vec3(0.5f);
    if (kind & 4) material.layers.anisotropyStrength = 0.5f;
    scenes.push_back(test::sceneOf(test::spherePrimitive(1), material));
  }
  return scenes;
}

TEST(KeptPrograms, FramesOfTwoPlansFindTheirsWhenOthersAreDropped) {
  RendererOptions options;
  options.limits.programs = 2;
  options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  const auto renderer = Renderer::create(options);
  Shot plain = test::shotOf(16);
  Shot denoised = plain;
  denoised.samples = 16, denoised.resolve = Resolve::kLinear;
  denoised.environment.source = Shot::Environment::Source::kStudio;
  denoised.environmentSamples = 32;
  denoised.denoise = true;
  const auto compiledFor = [&](const std::shared_ptr<const Scene>& scene, const Shot& shot) {
    FrameInfo info;
    renderer->draw(scene, shot, {}, {}, info);
    return nlohmann::json::parse(info.json).at("programsCompiled").get<int>();
  };
  const auto scenes = kindsOfScenes();
  int compiled = 0;
  for (std::size_t before = 0; before < 4;
       ++before) {  // programs that are kept, so that each of a frame's plans is once the one too many
    for (const auto& scene : scenes) compiled += compiledFor(scene, denoised);
    compiledFor(scenes[before], plain);
  }
  EXPECT_GT(compiled, 2 * 4 * 8) << "programs are dropped";
}

}  // namespace
}  // namespace telar::kept_programs_test
