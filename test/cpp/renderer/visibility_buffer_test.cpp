#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "renderer/scenes.h"

// Pictures that are shaded by the visibility buffer, beside those that are drawn triangle by triangle.

namespace telar::visibility_buffer_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using LeaveOut = RendererOptions::LeaveOut;

std::unique_ptr<Renderer> rendererWith(LeaveOut use, double sliceMs = 50) {
  RendererOptions options;
  options.visibilityBuffer = use;
  options.sliceMs = sliceMs;
  return Renderer::create(options);
}

struct Drawn {
  Frame frame;
  nlohmann::json told;
  bool buffered() const { return told.contains("shadedFragments"); }
};

Drawn drawn(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  Drawn out{renderer.draw(scene, shot, {}, {}, info), {}};
  out.told = nlohmann::json::parse(info.json);
  return out;
}

Material colored(const glm::vec3& color, float roughness) {
  Material material;
  material.baseColorFactor = {color, 1};
  material.roughnessFactor = roughness;
  material.metallicFactor = 0;
  return material;
}

Image8 checkered(int size) {
  Image8 image{static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(size)};
  for (int i = 0; i < size * size; ++i) {
    const auto value = static_cast<std::uint8_t>(((i / 8 + i / size / 8) % 2) * 120 + 60);
    image.pixels.insert(image.pixels.end(), {value, static_cast<std::uint8_t>(255 - value), 128, 255});
  }
  return image;
}

/// A ring about the axis that the camera looks along.
Primitive ringPrimitive(float radius, float tube, int steps) {
  Primitive p;
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (2 * steps + 1) + x); };
  for (int y = 0; y <= steps; ++y) {
    for (int x = 0; x <= 2 * steps; ++x) {
      const float v = glm::two_pi<float>() * static_cast<float>(y) / static_cast<float>(steps);
      const float u = glm::pi<float>() * static_cast<float>(x) / static_cast<float>(steps);
      p.normals.emplace_back(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      p.positions.push_back(glm::vec3(std::cos(u), std::sin(u), 0) * radius + p.normals.back() * tube);
      p.bounds.add(glm::dvec3(p.positions.back()));
      if (x == 0 || y == 0) continue;
      for (const std::uint32_t i : {at(x - 1, y - 1), at(x, y - 1), at(x, y), at(x - 1, y - 1), at(x, y), at(x - 1, y)})
        p.indices.push_back(i);
    }
  }
  return p;
}

/// Three balls: one of a texture by the second UV set with tangents, one mirrored with vertex colours, one behind them,
/// seen from both sides.
std::shared_ptr<Scene> balls(bool unlit) {
  Primitive textured = spherePrimitive(0.55f, 24);
  for (const glm::vec2& uv : textured.uvs[0]) textured.uvs[1].push_back(uv * 2.0f + 0.1f);
  for (const glm::vec3& n : textured.normals)
    textured.tangents.emplace_back(glm::vec3(n.z, 0, -n.x) + glm::vec3(1e-4f, 0, 0), 1.0f);
  auto scene = sceneOf(textured, colored({0.9f, 0.8f, 0.7f}, 0.5f));
  scene->images = SharedList<Image8>{std::vector<Image8>{checkered(64)}};
  scene->fileImages = 1;
  if (!unlit) {
    scene->materials[0].baseColorTexture.image = 0;
    scene->materials[0].baseColorTexture.texCoord = 1;
    scene->materials[0].normalTexture.image = 0;
    scene->materials[0].normalScale = 0.2f;
    // Three maps of the same coordinates, two of them in one texture.
    scene->materials[0].metallicRoughnessTexture = scene->materials[0].baseColorTexture;
    scene->materials[0].occlusionTexture = scene->materials[0].baseColorTexture;
  }
  scene->materials.push_back(colored({0.3f, 0.6f, 0.9f}, 0.3f));
  scene->materials.push_back(colored({0.7f, 0.3f, 0.3f}, 0.8f));
  scene->materials[2].doubleSided = true;
  for (Material& material : scene->materials) material.unlit = unlit;
  Primitive painted = spherePrimitive(0.5f, 20), far = spherePrimitive(0.9f, 30);
  for (const glm::vec3& n : painted.normals) painted.colors.emplace_back(unlit ? glm::vec3(1) : glm::abs(n), 1);
  painted.material = 1;
  far.material = 2;
  far.indices.resize(far.indices.size() / 2);  // open below: its inside is seen
  scene->meshes.push_back({"painted", {painted}});
  scene->meshes.push_back({"far", {far}});
  Node node;
  node.mesh = 1;
  node.world =
      glm::translate(glm::dmat4(1), glm::dvec3(0.5, 0.3, 0.4)) * glm::scale(glm::dmat4(1), glm::dvec3(-1, 0.8, 1));
  scene->nodes.push_back(node);
  node.mesh = 2;
  node.world = glm::translate(glm::dmat4(1), glm::dvec3(0, -0.2, -0.6));
  scene->nodes.push_back(node);
  scene->nodes[0].world = glm::translate(glm::dmat4(1), glm::dvec3(-0.4, 0, 0.5));
  scene->fileMeshes = scene->meshes.size();
  scene->bounds.add(glm::dvec3(-1.5));
  scene->bounds.add(glm::dvec3(1.5));
  return scene;
}

Shot litShot(int size) {
  Shot shot = shotOf(size);
  shot.samples = 4;
  shot.camera.fovY = 40;
  Shot::Light light{Shot::Light::Type::kDirectional};
  light.position = {1.5, 2.5, 2};
  light.intensity = 3;
  shot.lights = {light};
  return shot;
}

void expectSameBytes(const std::shared_ptr<const Scene>& scene, const Shot& shot, const std::string& what) {
  const Drawn a = drawn(*rendererWith(LeaveOut::kAlways), scene, shot);
  const Drawn b = drawn(*rendererWith(LeaveOut::kNever), scene, shot);
  ASSERT_TRUE(a.buffered()) << what;
  ASSERT_FALSE(b.buffered()) << what;
  EXPECT_TRUE(a.frame.pixels == b.frame.pixels) << what;
}

TEST(VisibilityBuffer, KeepsTheBytesOfUnlitPictures) {
  for (const int size : {64, 151, 256}) expectSameBytes(balls(true), litShot(size), std::to_string(size));
}

TEST(VisibilityBuffer, ReadsOcclusionWithRoughnessAsByItself) {
  auto apart = balls(false);
  apart->images = SharedList<Image8>{std::vector<Image8>{checkered(64), checkered(64)}};
  apart->fileImages = 2;
  apart->materials[0].occlusionTexture.image = 1;
  auto none = balls(false);
  none->materials[0].occlusionStrength = 0;
  const auto renderer = rendererWith(LeaveOut::kAlways);
  Shot shot = litShot(100);
  shot.lights.push_back({Shot::Light::Type::kAmbient});  // occlusion is of indirect light
  const Frame together = drawn(*renderer, balls(false), shot).frame;
  EXPECT_TRUE(drawn(*renderer, apart, shot).frame.pixels == together.pixels);
  EXPECT_FALSE(drawn(*renderer, none, shot).frame.pixels == together.pixels);
}

TEST(VisibilityBuffer, KeepsTheBytesOfLitPictures) {
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kFabric, ShadingModel::kDisney2012}) {
    Shot shot = litShot(200);
    shot.shading = shading;
    expectSameBytes(balls(false), shot, std::to_string(static_cast<int>(shading)));
  }
  Shot wide = litShot(100);
  wide.width = 230;
  wide.camera.projection = Shot::Camera::Projection::kOrthographic;
  wide.camera.height = 1.6;  // the model reaches beyond the window
  expectSameBytes(balls(false), wide, "orthographic");
  Shot colored = litShot(128);
  colored.background.type = Shot::Background::Type::kColor;
  expectSameBytes(balls(false), colored, "background");
}

// llvmpipe chooses one filter for several quads at once, which lie elsewhere in the dense rows.
TEST(VisibilityBuffer, KeepsTheBytesOfTexturesThatMagnifyOtherwise) {
  for (const std::uint32_t minFilter : {9729u, 9987u}) {
    auto scene = balls(false);
    Sampler& sampler = scene->materials[0].baseColorTexture.sampler;
    sampler.magFilter = 9728;
    sampler.minFilter = minFilter;
    for (const int size : {64, 100, 200}) expectSameBytes(scene, litShot(size), std::to_string(size));
  }
}

// At a rim the face before and the one behind it lie less than a depth apart: the depths themselves must be the GL's.
TEST(VisibilityBuffer, KeepsTheBytesOfRims) {
  for (const int rings : {16, 40}) {
    auto scene = sceneOf(ringPrimitive(1, 0.4f, rings), colored({0.8f, 0.5f, 0.3f}, 0.5f));
    scene->materials[0].doubleSided = true;
    for (int size = 96; size <= 256; size += 16) expectSameBytes(scene, litShot(size), std::to_string(size));
  }
}

TEST(VisibilityBuffer, KeepsTheBytesOfOneSample) {
  for (const int size : {64, 151}) {
    Shot shot = litShot(size);
    shot.samples = 1;
    expectSameBytes(balls(false), shot, std::to_string(size));
    shot.resolve = Resolve::kLinear;
    expectSameBytes(balls(false), shot, std::to_string(size) + ", floats");
  }
}

TEST(VisibilityBuffer, KeepsTheBytesOfFourSamplesInFloats) {
  for (const int size : {64, 151}) {
    Shot shot = litShot(size);
    shot.resolve = Resolve::kLinear;
    expectSameBytes(balls(false), shot, std::to_string(size));
  }
}

// In passes, of which pixels that are settled take no more. The vertex stage runs once: a pass is moved behind it,
// which rounds some corners to the next step of the rasterizer's grid.
TEST(VisibilityBuffer, KeepsAveragedPictures) {
  Shot shot = litShot(96);
  shot.samples = 64;
  shot.resolve = Resolve::kLinear;
  for (const double noise : {0.0, 4.0}) {
    shot.noise = noise;
    const Drawn a = drawn(*rendererWith(LeaveOut::kAlways), balls(false), shot);
    const Drawn b = drawn(*rendererWith(LeaveOut::kNever), balls(false), shot);
    ASSERT_TRUE(a.buffered());
    int differing = 0, most = 0;
    for (std::size_t i = 0; i < a.frame.pixels.size(); ++i) {
      const int apart = std::abs(static_cast<int>(a.frame.pixels[i]) - static_cast<int>(b.frame.pixels[i]));
      differing += apart > 0;
      most = std::max(most, apart);
    }
    std::printf("noise %g: %d bytes differ, by at most %d\n", noise, differing, most);
    EXPECT_LE(differing, 40) << noise;
    EXPECT_LE(most, 4) << noise;
  }
}

TEST(VisibilityBuffer, MergesTheQuadsOfSmoothSurfaces) {
  const auto renderer = rendererWith(LeaveOut::kAlways);
  Primitive ball = spherePrimitive(1, 64);
  const auto fragmentsOf = [&](const Primitive& primitive, bool merge, Frame& picture) {
    Shot shot = litShot(128);
    shot.samples = 1;
    shot.mergeQuads = merge;
    Drawn out = drawn(*renderer, sceneOf(primitive, colored({0.8f, 0.8f, 0.8f}, 0.5f)), shot);
    picture = std::move(out.frame);
    return out.told.at("shadedFragments").get<int>();
  };
  Frame apart, merged;
  EXPECT_LT(1.5 * fragmentsOf(ball, true, merged), fragmentsOf(ball, false, apart));
  // Each pixel has the varyings of its own triangle.
  int most = 0;
  for (std::size_t i = 0; i < apart.pixels.size(); ++i)
    most = std::max(most, std::abs(static_cast<int>(apart.pixels[i]) - static_cast<int>(merged.pixels[i])));
  EXPECT_LE(most, 1);
  // Normals of faces are derivatives: of two faces in one quad they would be of neither.
  ball.normals.clear();
  EXPECT_EQ(fragmentsOf(ball, true, merged), fragmentsOf(ball, false, apart));
  EXPECT_TRUE(apart.pixels == merged.pixels);
}

TEST(VisibilityBuffer, KeepsTheBytesOfFlatFaces) {
  Primitive faceted = spherePrimitive(1, 12);
  faceted.normals.clear();
  expectSameBytes(sceneOf(faceted, colored({0.8f, 0.8f, 0.8f}, 0.5f)), litShot(200), "facets");
}

TEST(VisibilityBuffer, ADifferenceInLightIsSeen) {
  Shot other = litShot(128);
  other.lights[0].intensity *= 1.02;
  const auto renderer = rendererWith(LeaveOut::kAlways);
  EXPECT_FALSE(drawn(*renderer, balls(false), other).frame.pixels ==
               drawn(*renderer, balls(false), litShot(128)).frame.pixels);
}

TEST(VisibilityBuffer, GroundAndShadowsLieBehind) {
  const auto scene = balls(false);
  Shot shot = litShot(200);
  shot.camera.position = {0, 1.5, 5};
  shot.lights[0].castShadow = true;
  shot.lights[0].shadow = {256, 1, 1, -0.002, 0.02, 0.5, 10, -3, 3, -3, 3, 1};
  shot.ground = Shot::Ground{};
  shot.ground->opacity = 0.5;
  shot.ground->position = {0, -1.2, 0};
  shot.ground->size = {4, 4};
  const Drawn a = drawn(*rendererWith(LeaveOut::kAlways), scene, shot);
  const Drawn b = drawn(*rendererWith(LeaveOut::kNever), scene, shot);
  ASSERT_TRUE(a.buffered());
  // The mean of the ground in a pixel stands in for its samples that show the ground. These differ where the border of
  // the ground runs through the pixel: two pixels of this picture, where it runs behind the rim of a ball.
  int differing = 0, most = 0;
  for (std::size_t i = 0; i < a.frame.pixels.size(); i += 4) {
    int apart = 0;
    for (std::size_t c = i; c < i + 4; ++c)
      apart = std::max(apart, std::abs(static_cast<int>(a.frame.pixels[c]) - static_cast<int>(b.frame.pixels[c])));
    differing += apart > 0;
    most = std::max(most, apart);
  }
  EXPECT_LE(differing, 4);
  EXPECT_LE(most, 32);  // an eighth of the opacity of the ground
  // Ground that cuts through the model hides some of it: that is drawn triangle by triangle.
  shot.ground->position.y = -0.3;
  EXPECT_FALSE(drawn(*rendererWith(LeaveOut::kAlways), scene, shot).buffered());
}

TEST(VisibilityBuffer, SlicesChangeNothing) {
  const auto scene = balls(false);
  const Drawn whole = drawn(*rendererWith(LeaveOut::kAlways), scene, litShot(128));
  const Drawn slices = drawn(*rendererWith(LeaveOut::kAlways, 1e-3), scene, litShot(128));
  EXPECT_TRUE(whole.frame.pixels == slices.frame.pixels);
}

TEST(VisibilityBuffer, DrawsWhatIsOpaqueAndWholeBeforeTheCamera) {
  const auto renderer = rendererWith(LeaveOut::kAlways);
  const auto isBuffered = [&](const std::shared_ptr<Scene>& scene, const Shot& shot) {
    return drawn(*renderer, scene, shot).buffered();
  };
  EXPECT_TRUE(isBuffered(balls(false), litShot(32)));
  Shot inside = litShot(32);
  inside.camera.position = {0, 0, 0.3};
  inside.camera.near = 0.01;
  EXPECT_FALSE(isBuffered(balls(false), inside));
  for (const AlphaMode mode : {AlphaMode::kBlend, AlphaMode::kMask}) {
    auto scene = balls(false);
    scene->materials[1].alphaMode = mode;
    EXPECT_FALSE(isBuffered(scene, litShot(32)));
  }
  auto glass = balls(false);
  glass->materials[1].physical = true;
  glass->materials[1].layers.transmissionFactor = 0.5f;
  EXPECT_FALSE(isBuffered(glass, litShot(32)));
  // Area lights, but for pictures that are others anyway.
  Shot panel = litShot(32);
  panel.lights.push_back({Shot::Light::Type::kRect});
  EXPECT_FALSE(isBuffered(balls(false), panel));
  panel.samples = 1;
  panel.mergeQuads = true;
  EXPECT_TRUE(isBuffered(balls(false), panel));
}

TEST(VisibilityBuffer, IsToldOfItsOwnPictureAlone) {
  const auto renderer = rendererWith(LeaveOut::kAlways);
  EXPECT_TRUE(drawn(*renderer, balls(false), litShot(32)).buffered());
  Shot panel = litShot(32);
  panel.lights.push_back({Shot::Light::Type::kRect});
  EXPECT_FALSE(drawn(*renderer, balls(false), panel).buffered());
}

TEST(VisibilityBuffer, IsLeftOutWhereTrianglesAreFew) {
  const auto few = sceneOf(test::spherePrimitive(0.3f, 5), colored({1, 1, 1}, 0.5f));
  EXPECT_FALSE(drawn(*rendererWith(LeaveOut::kWhereItPays), few, litShot(32)).buffered());
  EXPECT_TRUE(drawn(*rendererWith(LeaveOut::kAlways), few, litShot(32)).buffered());
}

}  // namespace
}  // namespace telar::visibility_buffer_test
