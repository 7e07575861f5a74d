#include <gtest/gtest.h>

#include <iostream>
#include <numeric>

#include "renderer/cloth_images.h"

/// What the textures of the shading "fabric" do to pictures: cloth covers as much from far as from near, and its
/// highlights do not shimmer.
namespace telar::cloth_texture_test {
namespace {

using test::flatShot;
using test::imageOf;
using test::netImage;
using test::pixelF;
using test::sceneOf;
using test::squareCloth;
using test::unevenNormals;
using test::weaveNormals;

constexpr int SIZE = 128;

std::shared_ptr<Scene> clothOf(const Image8& image, TextureRef Material::*slot, float repeats, Material material) {
  material.metallicFactor = 0;
  (material.*slot).image = 0;
  auto scene = sceneOf(squareCloth(repeats), std::move(material));
  scene->images = std::vector<Image8>{image};
  return scene;
}

class ClothTexture : public testing::Test {
 protected:
  Frame draw(const std::shared_ptr<const Scene>& scene, Shot shot) {
    shot.output.bitDepth = 32;
    FrameInfo info;
    return renderer_->draw(scene, shot, {}, CancelToken(), info);
  }
  std::unique_ptr<Renderer> renderer_ = Renderer::create({});
};

/// Mean of one channel over the middle of the frame.
double meanOf(const Frame& frame, int channel, std::uint32_t border = 0) {
  double sum = 0;
  for (std::uint32_t y = border; y < frame.height - border; ++y) {
    for (std::uint32_t x = border; x < frame.width - border; ++x) sum += pixelF(frame, x, y)[channel];
  }
  const double side = frame.width - 2.0 * border;
  return sum / (side * side);
}

class Net : public ClothTexture, public testing::WithParamInterface<int> {};

TEST_P(Net, CoversAsMuchFromFarAsFromNear) {
  Material material;
  material.alphaMode = AlphaMode::kMask;
  const auto scene = clothOf(netImage(64, 4, 0.25), &Material::baseColorTexture, 16, material);
  const double expected = 1 - 0.75 * 0.75;
  double worst = 0;
  constexpr double MESH = 2.0 / (16 * 4);  // metres
  for (const int meshes : {3, 6, 12, 20, 33, 47, 64}) {
    Shot shot = flatShot(SIZE, meshes * MESH);
    shot.samples = GetParam();
    shot.lights.push_back({Shot::Light::Type::kAmbient});
    const Frame frame = draw(scene, shot);
    const double share = meanOf(frame, 3);
    worst = std::max(worst, std::abs(share / expected - 1));
    std::cout << GetParam() << " samples, " << double(SIZE) / meshes << " px a mesh: covers " << share << "\n";
    // What is covered is as white as from near: the black of the holes does not bleed into it.
    EXPECT_NEAR(meanOf(frame, 1) / share, meanOf(frame, 0) / share, 1e-6);
  }
  EXPECT_LT(worst, GetParam() == 1 ? 0.05 : 0.025) << "of " << expected;
}

INSTANTIATE_TEST_SUITE_P(Samples, Net, testing::Values(1, 4));

/// Variance over all pixels of what a net covers of them, as areas have it: of threads both ways that cover a part of each mesh.
/// @param pixels  that a mesh is wide
double varianceOfAreas(double thread, double pixels) {
  constexpr int PLACES = 4096;
  const double width = 1 / pixels;
  double mean = 0, squares = 0;
  for (int i = 0; i < PLACES; ++i) {
    const double from = double(i) / PLACES;
    const auto covered = [&](double x) { return std::floor(x) * thread + std::min(x - std::floor(x), thread); };
    const double open = 1 - (covered(from + width) - covered(from)) / width;
    mean += open / PLACES;
    squares += open * open / PLACES;
  }
  // Of the product of two that are independent.
  return squares * squares - std::pow(mean, 4);
}

/// Read once, at the level of the sampler, the narrowest have 0.77 of this contrast; read at that level for each quarter of a pixel, 0.54.
TEST_F(ClothTexture, ThreadsAsWideAsAPixelAreSeen) {
  Material material;
  material.alphaMode = AlphaMode::kMask;
  const auto scene = clothOf(netImage(64, 4, 0.25), &Material::baseColorTexture, 16, material);
  for (const int meshes : {23, 33, 41, 47}) {
    Shot shot = flatShot(SIZE, meshes * 2.0 / (16 * 4));
    shot.samples = 4;
    shot.lights.push_back({Shot::Light::Type::kAmbient});
    const Frame frame = draw(scene, shot);
    const double mean = meanOf(frame, 3);
    double variance = 0;
    for (std::uint32_t y = 0; y < SIZE; ++y) {
      for (std::uint32_t x = 0; x < SIZE; ++x) variance += std::pow(pixelF(frame, x, y)[3] - mean, 2) / (SIZE * SIZE);
    }
    const double pixels = double(SIZE) / meshes;
    const double expected = varianceOfAreas(0.25, pixels);
    std::cout << pixels << " px a mesh: contrast " << std::sqrt(variance) << " of " << std::sqrt(expected) << "\n";
    EXPECT_NEAR(std::sqrt(variance / expected), 1, 0.1);
  }
}

TEST_F(ClothTexture, HolesDoNotBleedTheirColour) {
  Material material;
  material.alphaMode = AlphaMode::kMask;
  const auto scene = clothOf(netImage(64, 4, 0.25), &Material::baseColorTexture, 64, material);
  Shot shot = flatShot(SIZE, 2);
  shot.samples = 4;
  shot.lights.push_back({Shot::Light::Type::kAmbient});
  const Frame frame = draw(scene, shot);
  const auto solid = clothOf(netImage(64, 1, 1.1), &Material::baseColorTexture, 64, material);
  const double white = meanOf(draw(solid, shot), 1);
  EXPECT_NEAR(meanOf(frame, 1) / meanOf(frame, 3), white, 0.02 * white);
}

/// The same of what is blended: threads are white, and what does not show has no blue or no red. At its own texels too,
/// which the sampler mixes.
TEST_F(ClothTexture, HolesOfWhatIsBlendedDoNotBleedTheirColour) {
  const auto net = [](const glm::vec4& hole) {
    Image8 image = netImage(64, 4, 0.25);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      for (int c = 0; c < 4 && image.pixels[i + 3] == 0; ++c)
        image.pixels[i + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(255 * hole[c]);
    }
    return image;
  };
  Material material;
  material.alphaMode = AlphaMode::kBlend;
  for (const double metres : {0.1, 0.5, 2.0, 4.0, -0.1}) {
    Shot shot = flatShot(SIZE, std::abs(metres));
    if (metres < 0) shot.samples = 16, shot.resolve = Resolve::kLinear;  // maps are read in full
    shot.lights = {{Shot::Light::Type::kAmbient}};
    const auto colour = [&](const Image8& image) {
      const Frame frame = draw(clothOf(image, &Material::baseColorTexture, 16, material), shot);
      return glm::dvec3(meanOf(frame, 0), meanOf(frame, 1), meanOf(frame, 2)) / meanOf(frame, 3);
    };
    const glm::dvec3 white = colour(netImage(64, 1, 1.1));
    for (const glm::vec4& hole : {glm::vec4(1, 1, 0, 0), glm::vec4(0, 1, 1, 0), glm::vec4(0)}) {
      const glm::dvec3 shown = colour(net(hole));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], white[c], 0.02 * white[c]) << metres << ", channel " << c;
    }
  }
}

/// Mean of the green channel of squares of `side` pixels: the picture that so many samples a pixel give.
std::vector<double> shrunk(const Frame& frame, std::uint32_t side) {
  std::vector<double> out;
  for (std::uint32_t y = 0; y + side <= frame.height; y += side) {
    for (std::uint32_t x = 0; x + side <= frame.width; x += side) {
      double sum = 0;
      for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) sum += pixelF(frame, x + i, y + j)[1];
      }
      out.push_back(sum / (side * side));
    }
  }
  return out;
}

double meanOf(const std::vector<double>& list) {
  return std::accumulate(list.begin(), list.end(), 0.0) / double(list.size());
}

/// How far two pictures are apart, as a part of their light.
double change(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / double(a.size()) / meanOf(a);
}

TEST_F(ClothTexture, HighlightsOfAWeaveStandStillAndKeepTheirLight) {
  Material material;
  material.roughnessFactor = 0.25f;
  material.baseColorFactor = {0, 0, 0, 1};
  const auto scene = clothOf(unevenNormals(64, 3, 0.15), &Material::normalTexture, 60, material);
  // Half a pixel aside, and half vectors that tilt by up to 25 degrees.
  const auto shotAt = [&](ShadingModel shading, int size, double shift) {
    Shot shot = flatShot(size, 1.2);
    shot.camera.position.x = shot.camera.target.x = shift * 1.2 / SIZE;
    shot.camera.position.y = shot.camera.target.y = 0.37 * shift * 1.2 / SIZE;
    shot.shading = shading;
    shot.samples = 1;
    for (const double tilt : {0.05, 0.25, 0.45, 0.65, 0.85}) {
      Shot::Light sun{Shot::Light::Type::kDirectional};
      sun.position = {std::sin(tilt) * std::cos(5 * tilt), std::sin(tilt) * std::sin(5 * tilt), std::cos(tilt)};
      sun.intensity = tilt;  // as much as there is of the sky at this tilt
      shot.lights.push_back(sun);
    }
    return shot;
  };
  // 16 x 16 samples of every pixel, of normals that are hardly filtered.
  const auto truth = [&](double shift) {
    return shrunk(draw(scene, shotAt(ShadingModel::kThree, 16 * SIZE, shift)), 16);
  };
  const auto exact = truth(0);
  std::cout << "supersampled: half a pixel changes " << 100 * change(exact, truth(0.5)) << " %\n";
  double moves[2], errors[2], lights[2];
  for (const auto shading : {ShadingModel::kThree, ShadingModel::kFabric}) {
    const auto a = shrunk(draw(scene, shotAt(shading, SIZE, 0)), 1),
               b = shrunk(draw(scene, shotAt(shading, SIZE, 0.5)), 1);
    const int i = shading == ShadingModel::kFabric;
    moves[i] = change(a, b), errors[i] = change(exact, a), lights[i] = meanOf(a) / meanOf(exact);
    std::cout << (i ? "fabric" : "three") << ": half a pixel changes " << 100 * moves[i] << " %, light x" << lights[i]
              << ", from the supersampled picture " << 100 * errors[i] << " %\n";
  }
  EXPECT_LT(moves[1], 0.35 * moves[0]);
  EXPECT_LT(errors[1], 0.6 * errors[0]);
  EXPECT_NEAR(lights[1], 1, 0.25);
}

TEST_F(ClothTexture, YarnsFinerThanTwoPixelsShowTheirMeanAlone) {
  constexpr int THREADS = 6;
  const Image8 plainWeave = imageOf(96, 96, [](double u, double v) {
    const bool warp = (int(u * THREADS) + int(v * THREADS)) % 2 == 0;
    return glm::vec4(1, 0.5f, 0.5f, warp ? 1 : 0);
  });
  Material material;
  material.metallicFactor = 0;
  material.baseColorFactor = {0, 0, 0, 1};
  material.fabric.weave = true;
  material.fabric.warp = {0.5f, 0.3f, 0.7f, glm::vec3(1)};
  material.fabric.weft = {0.5f, 0.3f, 0.7f, glm::vec3(1)};
  material.fabric.threadsPerUv = glm::vec2(THREADS);
  material.fabric.weaveTexture.image = 0;
  auto scene = sceneOf(squareCloth(20), material);
  scene->images = std::vector<Image8>{plainWeave};
  // 60 threads a metre.
  const auto changeAt = [&](double threadsPerPixel) {
    const double height = threadsPerPixel * SIZE / 60;
    const auto frameAt = [&](double shift) {
      Shot shot = flatShot(SIZE, height);
      shot.camera.position.x = shot.camera.target.x = shift * height / SIZE;
      shot.samples = 1;
      Shot::Light sun{Shot::Light::Type::kDirectional};
      sun.position = {0.9, 0.1, 1};  // off the highlight of the weft, within that of the warp
      shot.lights = {sun};
      return shrunk(draw(scene, shot), 1);
    };
    return change(frameAt(0), frameAt(0.5));
  };
  const double near = changeAt(0.1), far = changeAt(0.55);
  std::cout << "a weave: half a pixel changes " << 100 * near << " % from near, " << 100 * far << " % from far\n";
  EXPECT_GT(near, 0.02);
  EXPECT_LT(far, 0.02);
}

/// A polished relief under white light from everywhere, as a dome and as lights so wide that they fill the sky.
TEST_F(ClothTexture, PolishedReliefsReflectAreaLightsAsTheyDoDomes) {
  Material polished;
  polished.roughnessFactor = 0.18f;
  // Three quarters are steep: edges, of which more than half of the light is lost.
  const Image8 ridges = imageOf(64, 64, [](double u, double) {
    const int column = int(u * 64) % 4;
    const glm::vec3 n =
        glm::normalize(glm::vec3(column == 0 ? 0.0f : 0.9f * float(column - 2), column == 2 ? 0.9f : 0, 1));
    return glm::vec4(n * 0.5f + 0.5f, 1);
  });
  const auto scene = clothOf(ridges, &Material::normalTexture, 60, polished);
  scene->materials.back().metallicFactor = 1;
  const auto under = [&](Shot::Light light) {
    light.position = {0, 0, 1};
    light.target = {0, 0, 0};
    light.width = light.height = 2000;
    light.radius = 1000;
    light.intensity = light.type == Shot::Light::Type::kAmbient ? glm::pi<double>() : 1;  // radiance 1 of each
    Shot shot = flatShot(16, 0.5);
    shot.lights = {light};
    return meanOf(draw(scene, shot), 1);
  };
  const double dome = under({Shot::Light::Type::kAmbient});
  EXPECT_LT(dome, 0.8);  // the edges matter: of the facets alone an area light would be darker by a sixth or more
  EXPECT_GT(dome, 0.42);
  // The light ends a thousandth above the horizon; the tables' own sums are 1 within 1 %.
  EXPECT_NEAR(under({Shot::Light::Type::kRect}) / dome, 1, 0.015);
  EXPECT_NEAR(under({Shot::Light::Type::kDisk}) / dome, 1, 0.015);
}

/// Gold weft on a warp of red silk, from so near that each yarn is seen and from so far that none is: the same light.
TEST_F(ClothTexture, MetalOfOneSetOfYarnsKeepsItsColourAndItsLightFromAfar) {
  constexpr int THREADS = 4;
  const auto isWarp = [](double u, double v) { return (int(u * THREADS) + int(v * THREADS)) % 2 == 0; };
  const glm::vec3 gold(0.97f, 0.83f, 0.58f), silk(0.46f, 0.15f, 0.25f);  // as sRGB has them
  Material brocade;
  brocade.roughnessFactor = 0.6f;
  brocade.fabric.weave = true;
  brocade.fabric.warp = {0.5f, 0.5f, 0, glm::vec3(1)};
  brocade.fabric.weft = {0.5f, 0.5f, 0, glm::vec3(0.94f, 0.66f, 0.3f)};
  brocade.fabric.threadsPerUv = glm::vec2(THREADS);
  brocade.baseColorTexture.image = 0, brocade.metallicRoughnessTexture.image = 1, brocade.fabric.weaveTexture.image = 2;
  const auto clothWith = [&](bool apart) {
    auto scene = sceneOf(squareCloth(40), brocade);
    scene->images = {
        imageOf(64, 64, [&](double u, double v) { return glm::vec4(isWarp(u, v) ? silk : gold, 1); }),
        imageOf(64, 64, [&](double u, double v) { return glm::vec4(1, 1, isWarp(u, v) ? 0 : 1, 1); }),
        imageOf(64, 64, [&](double u, double v) { return glm::vec4(1, 0.5f, 0.5f, isWarp(u, v) ? 1 : 0); })};
    // With another place of the metalness its products with the colour are not known.
    if (apart) scene->materials.back().metallicRoughnessTexture.uvTransform[0][0] = 1.0001f;
    return scene;
  };
  const auto lightOf = [&](double height, bool apart) {
    Shot shot = flatShot(SIZE, height);
    shot.samples = 1;
    shot.lights.push_back({Shot::Light::Type::kAmbient});
    const Frame frame = draw(clothWith(apart), shot);
    return glm::dvec3(meanOf(frame, 0), meanOf(frame, 1), meanOf(frame, 2));
  };
  const glm::dvec3 near = lightOf(2.0 / 40, false), far = lightOf(2, false), mixed = lightOf(2, true);
  std::cout << "brocade: green of red from near " << near.g / near.r << ", from far " << far.g / far.r
            << ", of means alone " << mixed.g / mixed.r << "; light x" << far.g / near.g << ", x" << mixed.g / near.g
            << "\n";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(far[c] / near[c], 1, 0.02) << c;
  EXPECT_GT(std::abs(mixed.b / near.b - 1), 0.1);  // what it is without
}

TEST_F(ClothTexture, NothingIsPaidWhereItIsNotAskedFor) {
  const auto features = [&](ShadingModel shading, const Material& material) {
    auto scene = clothOf(weaveNormals(16, 16, 4, 0.5), &Material::normalTexture, 4, material);
    scene->materials.back().metallicFactor = material.metallicFactor;
    scene->materials.back().roughnessFactor = material.roughnessFactor;
    Shot shot = flatShot(16, 2);
    shot.shading = shading;
    return planFrame(*scene, shot, Limits());
  };
  EXPECT_NE(features(ShadingModel::kFabric, {}).find("normal-variance"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kThree, {}).find("normal-variance"), std::string::npos);
  Material polished;
  polished.roughnessFactor = 0.2f;
  EXPECT_NE(features(ShadingModel::kFabric, polished).find("normal-facets"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kThree, polished).find("normal-facets"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kFabric, {}).find("normal-facets"), std::string::npos);
  polished.metallicFactor = 0;
  EXPECT_EQ(features(ShadingModel::kFabric, polished).find("normal-facets"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kFabric, {}).find("metal-means"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kFabric, {}).find("yarn-relief"), std::string::npos);
  Material woven;
  woven.fabric.weave = true;
  woven.fabric.weaveTexture.image = woven.baseColorTexture.image = woven.metallicRoughnessTexture.image = 0;
  EXPECT_NE(features(ShadingModel::kFabric, woven).find("yarn-relief"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kThree, woven).find("yarn-relief"), std::string::npos);
  woven.metallicFactor = 0.5f;
  EXPECT_NE(features(ShadingModel::kFabric, woven).find("metal-means"), std::string::npos);
  EXPECT_EQ(features(ShadingModel::kThree, woven).find("metal-means"), std::string::npos);
  Material mask;
  mask.alphaMode = AlphaMode::kMask;
  EXPECT_EQ(features(ShadingModel::kFabric, mask).find("alpha-to-coverage"), std::string::npos);
}

}  // namespace
}  // namespace telar::cloth_texture_test
