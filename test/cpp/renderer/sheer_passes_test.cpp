#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "pass/plan/draw_list.h"
#include "renderer/cloth_images.h"
#include "telar/renderer.h"

/// Passes over sheer cloth whose threads are finer than the cells of a pixel.
namespace telar::sheer_passes_test {
namespace {

using test::flatShot;
using test::imageOf;
using test::pixel8;
using test::sceneOf;
using test::squareCloth;

constexpr int SIZE = 64;
constexpr double THREADS = 4;       ///< of the image
constexpr double PER_PIXEL = 3.06;  ///< places that all pixels share beat with them: coverage errs by 0.065

Image8 voile() {
  return imageOf(64, 64, [](double u, double v) {
    const double wave = std::cos(glm::two_pi<double>() * THREADS * u) + std::cos(glm::two_pi<double>() * THREADS * v);
    return glm::vec4(glm::vec3(1), 0.5 + 0.25 * wave);
  });
}

std::shared_ptr<Scene> clothOf(Image8 image, AlphaMode mode = AlphaMode::kBlend) {
  Material material;
  material.metallicFactor = 0;
  material.alphaMode = mode;
  material.baseColorTexture.image = 0;
  auto scene = sceneOf(squareCloth(static_cast<float>(PER_PIXEL * SIZE / THREADS)), std::move(material));
  scene->images = std::vector<Image8>{std::move(image)};
  return scene;
}

Shot shotWith(int samples) {
  Shot shot = flatShot(SIZE, 2);
  shot.samples = samples, shot.resolve = Resolve::kLinear;
  return shot;
}

/// Coverage of the picture less its mean.
struct Error {
  double mean = 0, square = 0;
  double ofNeighbours = 0;  ///< mean of the products of neighbours in a row
};

Error errorOf(const Frame& frame) {
  Error error;
  const auto alpha = [&](std::uint32_t x, std::uint32_t y) { return pixel8(frame, x, y)[3] / 255.0 - 0.5; };
  for (std::uint32_t y = 0; y < SIZE; ++y) {
    for (std::uint32_t x = 0; x + 1 < SIZE; ++x) {
      error.mean += alpha(x, y);
      error.square += alpha(x, y) * alpha(x, y);
      error.ofNeighbours += alpha(x, y) * alpha(x + 1, y);
    }
  }
  constexpr double COUNT = SIZE * (SIZE - 1);
  return {error.mean / COUNT, error.square / COUNT, error.ofNeighbours / COUNT};
}

TEST(SheerPasses, ThreadsFinerThanCellsAreNoiseAndNoRings) {
  const auto renderer = Renderer::create({});
  FrameInfo info;
  const Error error = errorOf(renderer->draw(clothOf(voile()), shotWith(16), {}, CancelToken(), info));
  EXPECT_LT(std::abs(error.mean), 0.002);
  EXPECT_LT(std::sqrt(error.square), 0.03) << "16 independent places would err by 0.063";
  EXPECT_LT(std::abs(error.ofNeighbours), 0.2 * error.square) << "errors of neighbours go together";
}

bool haveOwnPlaces(const std::shared_ptr<Scene>& scene, const Shot& shot) {
  const pass::FramePlan plan = pass::planDraws(*scene, shot, Limits(), false);
  const auto& draws = plan.draws.blended.empty() ? plan.draws.opaque : plan.draws.blended;
  return draws.at(0).key.ownPlaces;
}

TEST(SheerPasses, OnlyTheseHavePlacesOfTheirOwn) {
  EXPECT_TRUE(haveOwnPlaces(clothOf(voile()), shotWith(16)));
  EXPECT_FALSE(haveOwnPlaces(clothOf(voile()), shotWith(64))) << "scattered passes";
  EXPECT_FALSE(haveOwnPlaces(clothOf(voile()), shotWith(Shot::SAMPLES_OF_A_PASS))) << "one pass";
  EXPECT_FALSE(haveOwnPlaces(clothOf(voile(), AlphaMode::kMask), shotWith(16))) << "cut-out cloth";
  EXPECT_FALSE(haveOwnPlaces(clothOf(voile(), AlphaMode::kOpaque), shotWith(16))) << "no alpha";
  Shot three = shotWith(16);
  three.shading = ShadingModel::kThree;
  EXPECT_FALSE(haveOwnPlaces(clothOf(voile()), three)) << "no cloth";
}

}  // namespace
}  // namespace telar::sheer_passes_test
