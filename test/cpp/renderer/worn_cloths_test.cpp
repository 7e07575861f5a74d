#include <gtest/gtest.h>

#include "renderer/cloth_images.h"
#include "telar/dress.h"

// What a renderer has of a cloth stays for the next models that wear it.

namespace telar::worn_cloths_test {
namespace {

using namespace test;

constexpr std::uint32_t SIDE = 64;

Image8 stripes(double count, glm::vec3 dark) {
  return imageOf(SIDE, SIDE, [=](double u, double) {
    return std::fmod(u * count, 1.0) < 0.5 ? glm::vec4(dark, 1) : glm::vec4(0.9, 0.8, 0.7, 1);
  });
}

/// A square of cloth with a relief, woven of metal and other yarns.
std::shared_ptr<const Scene> clothOf(double threads) {
  const Image8 metalness = imageOf(SIDE, SIDE, [](double u, double v) { return glm::vec4(1, 0.4, u > v, 1); });
  const Image8 weave = imageOf(SIDE, SIDE, [=](double u, double) {
    return glm::vec4(1, 0.5, 0.5 + 0.3 * std::sin(glm::two_pi<double>() * threads * u),
                     std::fmod(u * threads, 1.0) < 0.5);
  });
  Material material;
  material.baseColorTexture.image = 0;
  material.normalTexture.image = 1;
  material.metallicRoughnessTexture.image = 2;
  material.fabric.weave = true;
  material.fabric.warp.coverage = material.fabric.weft.coverage = 0.5f;
  material.fabric.weaveTexture.image = 3;
  auto scene = sceneOf(squareCloth(1), material);
  std::vector<Image8> images{stripes(threads, {0.1, 0.2, 0.6}), weaveNormals(SIDE, SIDE, threads, 0.8), metalness,
                             weave};
  scene->fileImages = images.size();
  scene->fileMaterials = 1;
  scene->images = SharedList<Image8>(std::move(images));
  return scene;
}

/// A cloth without a colour, which leaves that of the part: a relief alone.
std::shared_ptr<const Scene> uncolored() {
  Material material;
  material.normalTexture.image = 0;
  auto scene = sceneOf(squareCloth(1), material);
  scene->fileImages = scene->fileMaterials = 1;
  scene->images = SharedList<Image8>{weaveNormals(SIDE, SIDE, 5, 0.6)};
  return scene;
}

/// A square with two materials, of which the second has the net of the file.
std::shared_ptr<const Scene> garmentOf(float repeats, double meshes = 4) {
  Material net;
  net.alphaMode = AlphaMode::kMask;
  net.baseColorTexture.image = 0;
  auto scene = sceneOf(squareCloth(repeats));
  scene->materials.push_back(net);
  Primitive other = squareCloth(2 * repeats);
  for (glm::vec3& position : other.positions) position += glm::vec3(0.3, 0.2, 0.1);
  other.material = 1;
  scene->meshes.push_back({"other", {std::move(other)}});
  Node node = scene->nodes[0];
  node.mesh = 1;
  scene->nodes.push_back(node);
  scene->fileMaterials = 2;
  scene->fileMeshes = 2;
  scene->fileImages = 1;
  scene->images = SharedList<Image8>{netImage(SIDE, meshes, 0.5)};
  return scene;
}

Dressing dressingOf(int material, std::shared_ptr<const Scene> cloth) {
  Dressing dressing;
  dressing.materials = {material};
  dressing.cloth = std::move(cloth);
  return dressing;
}

Shot litShot() {
  Shot shot = flatShot(64, 2.6);
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  shot.samples = 4;
  return shot;
}

class WornCloths : public ::testing::Test {
 protected:
  std::vector<std::byte> drawn(const std::shared_ptr<const Scene>& scene, int textureSize = 0) {
    Shot shot = litShot();
    shot.textureSize = textureSize;
    FrameInfo info;
    return renderer_->draw(scene, shot, {}, {}, info).pixels;
  }

  /// With textures of its own for all that it wears.
  std::vector<std::byte> drawnAlone(const std::shared_ptr<const Scene>& scene, int textureSize = 0) {
    auto own = std::make_shared<Scene>(*scene);
    own->cloths.clear();
    auto picture = drawn(own, textureSize);
    renderer_->release(*own);
    return picture;
  }

  std::shared_ptr<const Scene> dressed(float repeats, const std::vector<Dressing>& dressings, double meshes = 4) {
    return dressScene(garmentOf(repeats, meshes), dressings, CancelToken());
  }

  /// Names that a draw makes and that stay while its model is there.
  int namesOf(const std::shared_ptr<const Scene>& scene) {
    const int before = renderer_->liveObjects();
    drawn(scene);
    return renderer_->liveObjects() - before;
  }

  std::unique_ptr<Renderer> renderer_ = Renderer::create({});
};

TEST_F(WornCloths, ArePicturesOfTheSameTexelsWhereverTheirImagesStand) {
  const auto a = clothOf(3), b = clothOf(7), bare = uncolored();
  for (const auto& scene : {dressed(1, {dressingOf(0, a)}), dressed(2, {dressingOf(0, b), dressingOf(1, a)}),
                            dressed(1.5f, {dressingOf(1, b)}), dressed(1, {dressingOf(1, bare), dressingOf(0, b)}),
                            dressed(0.5f, {dressingOf(1, bare)}), dressed(0.5f, {dressingOf(1, bare)}, 7)}) {
    EXPECT_TRUE(drawn(scene) == drawnAlone(scene));
    EXPECT_TRUE(drawn(scene, 16) == drawnAlone(scene, 16)) << "of smaller levels";
  }
}

TEST_F(WornCloths, AreUploadedAndMadeOnce) {
  const auto cloth = clothOf(3);
  const auto first = dressed(1, {dressingOf(0, cloth)}), second = dressed(2, {dressingOf(0, cloth)});
  const auto plain = dressed(3, {});
  const int shared = namesOf(first) - namesOf(plain);
  EXPECT_GE(shared, 4) << "the cloth's images, and what is made of them";
  EXPECT_EQ(namesOf(second), namesOf(dressed(4, {}))) << "nothing but its meshes and the net";
}

TEST_F(WornCloths, StayWhenTheirModelGoesButNotAllOfThem) {
  std::vector<int> names;
  std::vector<std::shared_ptr<const Scene>> cloths;
  for (int i = 0; i < 12; ++i) {
    cloths.push_back(clothOf(2 + i));
    const auto scene = dressed(1, {dressingOf(0, cloths.back())});
    const auto picture = drawn(scene);
    renderer_->release(*scene->model);
    names.push_back(renderer_->liveObjects());
    EXPECT_TRUE(picture == drawnAlone(scene)) << i;
  }
  for (std::size_t i = 1; i < 8; ++i) EXPECT_GT(names[i], names[i - 1]) << i;
  for (std::size_t i = 8; i < names.size(); ++i) EXPECT_EQ(names[i], names[7]) << i;
  // One that went is made again, and those that nobody keeps go.
  const auto again = dressed(1, {dressingOf(0, cloths[0])});
  EXPECT_TRUE(drawn(again) == drawnAlone(again));
  const int kept = renderer_->liveObjects();
  cloths.clear();
  drawn(again);
  EXPECT_LT(renderer_->liveObjects(), kept);
}

/// What is made of a cut-out cloth depends on the alpha of the part, which any file may have as it likes.
TEST_F(WornCloths, KeepNothingForEachGarmentThatCutsThemOutElsewhere) {
  auto cloth = std::make_shared<Scene>(*clothOf(3));
  cloth->materials[0].alphaMode = AlphaMode::kMask;
  cloth->images = SharedList<Image8>{netImage(SIDE, 4, 0.5), cloth->images[1], cloth->images[2], cloth->images[3]};
  std::vector<int> names;
  for (const float alpha : {1.0f, 0.9f, 0.8f, 0.7f, 1.0f}) {
    auto garment = std::make_shared<Scene>(*garmentOf(1));
    garment->materials[0].baseColorFactor.a = alpha;
    const auto scene = dressScene(garment, {dressingOf(0, cloth)}, CancelToken());
    const auto picture = drawn(scene);
    EXPECT_TRUE(picture == drawnAlone(scene)) << alpha;
    renderer_->release(*garment);
    names.push_back(renderer_->liveObjects());
  }
  for (std::size_t i = 1; i < names.size(); ++i) EXPECT_EQ(names[i], names[0]) << i;
}

TEST_F(WornCloths, OfOnePictureAreAllThere) {
  std::vector<std::shared_ptr<const Scene>> cloths;
  auto garment = std::make_shared<Scene>(*garmentOf(1));
  std::vector<Dressing> dressings;
  for (int i = 0; i < 12; ++i) {
    garment->materials.push_back(garment->materials[0]);
    Primitive part = squareCloth(1);
    for (glm::vec3& position : part.positions) position = position * 0.1f + glm::vec3(0.2 * i - 1.1, 0, 0.5);
    part.material = 2 + i;
    garment->meshes.push_back({"part", {std::move(part)}});
    Node node = garment->nodes[0];
    node.mesh = 2 + i;
    garment->nodes.push_back(node);
    dressings.push_back(dressingOf(2 + i, clothOf(2 + i)));
  }
  garment->fileMaterials = garment->materials.size();
  garment->fileMeshes = garment->meshes.size();
  const auto scene = dressScene(garment, dressings, CancelToken());
  const auto alone = drawnAlone(scene);
  EXPECT_TRUE(drawn(scene) == alone);
  EXPECT_TRUE(drawn(scene) == alone) << "again";
}

/// The material that the first part has after a dressing in red, of a cloth with a picture and a back.
Material dyedWithBack(bool hasColor, bool isCloth) {
  auto cloth = std::make_shared<Scene>(*clothOf(3));
  FabricLayers& fabric = cloth->materials[0].fabric;
  fabric.back = true;
  fabric.backHasColor = hasColor;
  fabric.backColorFactor = {0.1f, 0.6f, 0.2f};
  Dressing dressing = dressingOf(0, isCloth ? cloth : nullptr);
  dressing.color = glm::vec3(0.7f, 0.1f, 0.1f);
  return dressScene(isCloth ? garmentOf(1) : cloth, {dressing}, CancelToken())->materials[0];
}

TEST(DyedCloth, HasABackInTheSameColourUnlessThatHasOneOfItsOwn) {
  for (const bool isCloth : {false, true}) {
    const Material dyed = dyedWithBack(false, isCloth);
    EXPECT_EQ(dyed.fabric.backColorFactor, glm::vec3(dyed.baseColorFactor)) << isCloth;
    EXPECT_EQ(dyed.fabric.backColorTexture.image, dyed.baseColorTexture.image) << isCloth;
    EXPECT_GT(dyed.fabric.backColorFactor.r, 2 * dyed.fabric.backColorFactor.g) << isCloth;
    EXPECT_EQ(dyedWithBack(true, isCloth).fabric.backColorFactor, glm::vec3(0.1f, 0.6f, 0.2f)) << isCloth;
  }
}

}  // namespace
}  // namespace telar::worn_cloths_test
