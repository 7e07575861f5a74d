#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <iostream>

#include "renderer/cloth_images.h"

/// Cut-out cloth of the shading "fabric" over itself, and at the ends of what glTF lets a cutoff be.
namespace telar::cloth_layers_test {
namespace {

using test::flatShot;
using test::imageOf;
using test::netImage;
using test::pixelF;
using test::sceneOf;
using test::squareCloth;

constexpr int SIZE = 128;

/// A net that covers 0.36 has threads of a fifth of a mesh.
constexpr double THREAD = 0.2, COVERS = 1 - (1 - THREAD) * (1 - THREAD);
constexpr int MESHES = 4;                 // of the image
constexpr float FINE = 160, COARSE = 32;  // images along the cloth of 2 m

std::shared_ptr<Scene> cutOut(const Image8& image, float cutoff, float repeats) {
  Material material;
  material.metallicFactor = 0;
  material.alphaMode = AlphaMode::kMask;
  material.alphaCutoff = cutoff;
  material.baseColorTexture.image = 0;
  auto scene = sceneOf(squareCloth(repeats), std::move(material));
  scene->images = std::vector<Image8>{image};
  return scene;
}

/// Layers behind each other.
/// @param gap  metres    @param turn  radians about the view, of each against the one in front of it
/// @param tilt  radians, of all
std::shared_ptr<Scene> layersOf(int count, float repeats, double gap, double turn, double tilt) {
  auto scene = cutOut(netImage(80, MESHES, THREAD), 0.5f, repeats);
  const Node node = scene->nodes.front();
  scene->nodes.clear();
  for (int i = 0; i < count; ++i) {
    scene->nodes.push_back(node);
    scene->nodes.back().world = glm::rotate(glm::dmat4(1), tilt, glm::dvec3(0.6, 0.8, 0)) *
                                glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -gap * i)) *
                                glm::rotate(glm::dmat4(1), turn * i, glm::dvec3(0, 0, 1));
  }
  return scene;
}

/// With glass beside the picture: what is blended is not seen through it, and masks stand in.
std::shared_ptr<Scene> besideGlass(std::shared_ptr<Scene> scene) {
  Material glass;
  glass.layers.transmissionFactor = 1;
  scene->materials.push_back(std::move(glass));
  Primitive pane = *scene->meshes.front().primitives.begin();
  pane.material = static_cast<int>(scene->materials.size()) - 1;
  scene->meshes.emplace_back().primitives = std::vector<Primitive>{std::move(pane)};
  Node node = scene->nodes.front();
  node.mesh = static_cast<int>(scene->meshes.size()) - 1;
  node.world = glm::translate(glm::dmat4(1), glm::dvec3(50, 0, 0));
  scene->nodes.push_back(node);
  return scene;
}

/// Share of the picture's middle that is covered.
double covered(Renderer& renderer, const std::shared_ptr<const Scene>& scene, Shot shot) {
  shot.output.bitDepth = 32;
  FrameInfo info;
  const Frame frame = renderer.draw(scene, shot, {}, CancelToken(), info);
  double sum = 0;
  constexpr std::uint32_t BORDER = 4;
  for (std::uint32_t y = BORDER; y < frame.height - BORDER; ++y) {
    for (std::uint32_t x = BORDER; x < frame.width - BORDER; ++x) sum += pixelF(frame, x, y)[3];
  }
  const double side = frame.width - 2.0 * BORDER;
  return sum / (side * side);
}

class ClothLayers : public testing::TestWithParam<int> {
 protected:
  std::unique_ptr<Renderer> renderer_ = Renderer::create({});
};

// 1.7 meshes to a pixel and more, so that the share is even. The holes of two layers do not know of each other: what
// both leave open is the product of what each does. Pixels of the picture are independent, so that the mean over its
// 14,400 has a standard error below 0.003.
TEST_P(ClothLayers, OverEachOtherCoverWhatIndependentHolesDo) {
  double worst = 0;
  for (const bool glass : {false, true}) {
    const auto scene = [&](int count, double gap, double tilt) {
      const auto layers = layersOf(count, FINE, gap, 0, tilt);
      return glass ? besideGlass(layers) : layers;
    };
    for (const double tilt : {0.0, 0.9}) {
      for (const double gap : {0.0005, 0.003, 0.02, 0.15}) {
        for (const bool perspective : {false, true}) {
          Shot shot = flatShot(SIZE, 0.7);
          shot.camera.projection = perspective ? Projection::kPerspective : Projection::kOrthographic;
          shot.camera.fovY = 8;  // as high, 5 m away
          shot.samples = GetParam();
          const double one = covered(*renderer_, scene(1, gap, tilt), shot);
          EXPECT_NEAR(one, COVERS, 0.01) << gap;
          for (const int count : {2, 3}) {
            const double share = covered(*renderer_, scene(count, gap, tilt), shot);
            const double expected = 1 - std::pow(1 - COVERS, count);
            worst = std::max(worst, std::abs(share - expected));
            EXPECT_NEAR(share, expected, 0.02) << count << " layers " << gap << " m apart, tilt " << tilt;
          }
        }
      }
    }
  }
  std::cout << GetParam() << " samples: two and three layers, worst error of the coverage " << worst << "\n";
}

/// From near the threads are seen, 3 to 12 pixels to a mesh, and their edges take much of the picture.
TEST_P(ClothLayers, CoverSoWhereTheirThreadsAreSeenToo) {
  double worst = 0;
  for (const double pixels : {3.1, 5.3, 8.7, 12.4}) {
    Shot shot = flatShot(SIZE, 2 / (MESHES * COARSE) * SIZE / pixels);
    shot.samples = GetParam();
    for (const int count : {2, 3}) {
      // Turned against each other: threads that lie over threads are no error of the masks.
      const double share = covered(*renderer_, layersOf(count, COARSE, 0.02, 0.55, 0), shot);
      const double expected = 1 - std::pow(1 - COVERS, count);
      worst = std::max(worst, std::abs(share - expected));
      EXPECT_NEAR(share, expected, 0.02) << count << " layers, " << pixels << " px a mesh";
    }
  }
  std::cout << GetParam() << " samples: seen from near, worst error of the coverage " << worst << "\n";
}

TEST_P(ClothLayers, NothingIsThereAboveTheHighestAlpha) {
  const Image8 net = netImage(64, 4, 0.25);
  // Alpha 0.4 all over, and 1 beside 0: no alpha reaches these cutoffs.
  const Image8 faint = imageOf(64, 64, [](double, double) { return glm::vec4(1, 1, 1, 0.4f); });
  for (const double height : {0.02, 0.1, 0.3, 0.7, 1.1, 1.9}) {
    Shot shot = flatShot(SIZE, height);
    shot.samples = GetParam();
    for (const float cutoff : {1.001f, 1.5f, 40.0f})
      EXPECT_EQ(covered(*renderer_, cutOut(net, cutoff, 16), shot), 0) << cutoff << ", " << height << " m";
    EXPECT_EQ(covered(*renderer_, cutOut(faint, 0.5f, 16), shot), 0) << height << " m";
    EXPECT_EQ(covered(*renderer_, cutOut(faint, 0.4f, 16), shot), 1)
        << "alpha as high as the cutoff is there, " << height;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, ClothLayers, testing::Values(1, 4));

}  // namespace
}  // namespace telar::cloth_layers_test
