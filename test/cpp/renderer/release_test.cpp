// What a release of three.js reads, sorts and draws otherwise than 0.187 besides its shading: one test a slot, in which
// the term of 0.187 fails.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "brdf/brdf.h"
#include "frame/release_material.h"
#include "pass/plan/draw_list.h"
#include "pass/target/transmission_target.h"
#include "renderer/scenes.h"

namespace telar {
namespace {

using frame::ReleaseMaterials;
using pass::TransmissionTarget;
using test::pixel8;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using test::stackedSquares;
using Terms = ThreeTerms;

Shot shotWith(int Terms::*slot, int term, int size = 8) {
  Shot shot = shotOf(size);
  shot.three.*slot = term;
  return shot;
}

Terms termsWith(int Terms::*slot, int term) {
  Terms terms;
  terms.*slot = term;
  return terms;
}

Frame drawn(const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  return Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
}

constexpr double TURN = 0.5, SX = 2, SY = 3;

/// KHR_texture_transform turns by TURN and scales by (SX, SY): T R S, as TextureReader writes it.
TextureRef turnedTexture() {
  TextureRef texture;
  texture.image = 0;
  const double c = std::cos(TURN), s = std::sin(TURN);
  texture.uvTransform = glm::mat3(SX * c, -SX * s, 0, SY * s, SY * c, 0, 0.1f, 0.2f, 1);
  return texture;
}

TEST(ReleaseMaterials, TodayReadsMaterialsAsTheyStand) {
  Material material;
  EXPECT_EQ(ReleaseMaterials().of(material, Primitive(), Terms()), nullptr);
}

TEST(ReleaseMaterials, ATransformTurnsBeforeItScales) {
  Material material;
  material.baseColorTexture = material.layers.sheenColorTexture = turnedTexture();
  ReleaseMaterials materials;
  const auto read =
      materials.of(material, Primitive(), termsWith(&Terms::textureTransform, Terms::THREE_TEXTURE_TRANSFORM_TSR));
  ASSERT_TRUE(read);
  // T S R of (1, 0) and of (0, 1): turned by R, then scaled along the axes.
  const double c = std::cos(TURN), s = std::sin(TURN);
  for (const TextureRef* texture : {&read->baseColorTexture, &read->layers.sheenColorTexture}) {
    const glm::mat3& t = texture->uvTransform;
    EXPECT_FLOAT_EQ(t[0][0], static_cast<float>(SX * c));
    EXPECT_FLOAT_EQ(t[0][1], static_cast<float>(-SY * s));
    EXPECT_FLOAT_EQ(t[1][0], static_cast<float>(SX * s));
    EXPECT_FLOAT_EQ(t[1][1], static_cast<float>(SY * c));
    EXPECT_EQ(t[2], glm::vec3(0.1f, 0.2f, 1));
  }
}

TEST(ReleaseMaterials, TheMatrixOfAClothStands) {
  Material material;
  material.normalTexture = turnedTexture();
  material.normalTexture.placed = true;
  const auto read = ReleaseMaterials().of(material, Primitive(),
                                          termsWith(&Terms::textureTransform, Terms::THREE_TEXTURE_TRANSFORM_TSR));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->normalTexture.uvTransform, material.normalTexture.uvTransform);
}

TEST(ReleaseMaterials, AllMapsHaveTheCoordinatesOfTheFirst) {
  Material material;
  material.normalTexture.image = material.emissiveTexture.image = material.occlusionTexture.image = 0;
  material.normalTexture.uvTransform[2] = glm::vec3(0.5f, 0, 1);
  material.emissiveTexture.uvTransform[2] = glm::vec3(0.25f, 0, 1);
  material.emissiveTexture.texCoord = 1;
  material.occlusionTexture.uvTransform[2] = glm::vec3(0.75f, 0, 1);
  const Terms terms = termsWith(&Terms::textureCoordinates, Terms::THREE_TEXTURE_COORDINATES_FIRST_MAP);
  ReleaseMaterials materials;
  Primitive one, two;
  two.uvs[1] = {glm::vec2(0)};
  const auto first = materials.of(material, one, terms), second = materials.of(material, two, terms);
  EXPECT_EQ(first->emissiveTexture.uvTransform[2].x, 0.5f);
  EXPECT_EQ(first->emissiveTexture.texCoord, 0);
  EXPECT_EQ(first->occlusionTexture.uvTransform[2].x, 0.75f);
  EXPECT_EQ(first->occlusionTexture.texCoord, 0);
  EXPECT_EQ(second->occlusionTexture.texCoord, 1);
  EXPECT_EQ(materials.of(material, one, terms), first);
}

TEST(ReleaseMaterials, ExtensionsThatALoaderDoesNotKnowAreLeftOut) {
  Material material;
  material.physical = true;
  material.layers.dispersion = material.layers.anisotropyStrength = material.layers.diffuseRoughnessFactor = 0.5f;
  material.layers.transmissionFactor = material.layers.thicknessFactor = 1;
  material.layers.bumpTexture.image = 0;
  const auto scene = sceneOf(spherePrimitive(1, 4), material);
  const auto keyWith = [&](const Shot& shot) {
    return pass::planDraws(*scene, shot, Limits{}, false).draws.transmissive[0].key;
  };
  const shader::VariantKey all = keyWith(shotOf(8));
  EXPECT_TRUE(all.dispersion && all.anisotropy && all.diffuseRoughness && all.bump);
  EXPECT_FALSE(keyWith(shotWith(&Terms::dispersion, Terms::THREE_DISPERSION_NONE)).dispersion);
  EXPECT_FALSE(keyWith(shotWith(&Terms::anisotropyDirection, Terms::THREE_ANISOTROPY_DIRECTION_NONE)).anisotropy);
  EXPECT_FALSE(keyWith(shotWith(&Terms::diffuseRoughness, Terms::THREE_DIFFUSE_ROUGHNESS_NONE)).diffuseRoughness);
  EXPECT_FALSE(keyWith(shotWith(&Terms::bump, Terms::THREE_BUMP_NONE)).bump);
}

/// Two blended squares: `moved` has its middle at z within its mesh.
std::shared_ptr<Scene> squaresAt(double z, double nodeZ) {
  Material material;
  material.alphaMode = AlphaMode::kBlend;
  const auto scene = sceneOf(stackedSquares(1), material);
  Primitive moved = stackedSquares(1);
  moved.material = 0;
  moved.center = glm::dvec3(0, 0, z);
  scene->meshes.push_back({"moved", {moved}});
  scene->nodes.push_back(scene->nodes[0]);
  scene->nodes[1].mesh = 1;
  scene->nodes[1].world[3].z = nodeZ;
  return scene;
}

TEST(Release, ObjectsAreSortedByTheirOrigins) {
  const auto scene = squaresAt(1, -0.5);  // its middle is nearer than the other's, its origin farther away
  const auto farthest = [&](int term) {
    return pass::planDraws(*scene, shotWith(&Terms::sorting, term), Limits{}, false).draws.blended[0].node;
  };
  EXPECT_EQ(farthest(Terms::THREE_SORTING_BOUNDING_SPHERE), &scene->nodes[0]);
  EXPECT_EQ(farthest(Terms::THREE_SORTING_BOUNDING_SPHERE_DIVIDED), &scene->nodes[0]);
  EXPECT_EQ(farthest(Terms::THREE_SORTING_ORIGIN), &scene->nodes[1]);
}

TEST(Release, WhatIsBehindTheCameraIsTheFarthestWhereDepthIsDivided) {
  const auto scene = squaresAt(9, 0);
  const auto farthest = [&](int term) {
    return pass::planDraws(*scene, shotWith(&Terms::sorting, term), Limits{}, false).draws.blended[0].node;
  };
  EXPECT_EQ(farthest(Terms::THREE_SORTING_BOUNDING_SPHERE), &scene->nodes[0]);
  EXPECT_EQ(farthest(Terms::THREE_SORTING_BOUNDING_SPHERE_DIVIDED), &scene->nodes[1]);
}

Material clearGlass() {
  Material material;
  material.metallicFactor = material.roughnessFactor = 0;
  material.physical = true;
  material.layers.transmissionFactor = 1;
  material.layers.specularFactor = 0;
  return material;
}

TEST(Release, BackSidesOfGlassAreNotSeenThroughIt) {
  Material material = clearGlass();
  material.doubleSided = true;
  const auto scene = sceneOf(spherePrimitive(1, 4), material);
  const auto backSides = [&](int term) {
    return pass::planDraws(*scene, shotWith(&Terms::glassBackSides, term), Limits{}, false)
        .draws.behindBackSides.size();
  };
  EXPECT_EQ(backSides(Terms::THREE_GLASS_BACK_SIDES_DRAWN), 1u);
  EXPECT_EQ(backSides(Terms::THREE_GLASS_BACK_SIDES_NONE), 0u);
}

TEST(Release, TheBufferBehindGlassHasItsSizeAndSamples) {
  const auto extent = [](int samples, int Terms::*slot, int term) {
    Shot shot;
    shot.width = 300;
    shot.height = 200;
    shot.samples = samples;
    return TransmissionTarget::extentOf(shot, termsWith(slot, term));
  };
  using Extent = TransmissionTarget::Extent;
  EXPECT_EQ(extent(1, &Terms::glassBuffer, Terms::THREE_GLASS_BUFFER_CANVAS), (Extent{300, 200, 4}));
  EXPECT_EQ(extent(1, &Terms::glassBuffer, Terms::THREE_GLASS_BUFFER_SQUARE_1024), (Extent{1024, 1024, 4}));
  for (const int term : {Terms::THREE_GLASS_SAMPLES_OF_CANVAS, Terms::THREE_GLASS_SAMPLES_OF_ANTIALIAS}) {
    EXPECT_EQ(extent(1, &Terms::glassSamples, term), (Extent{300, 200, 1}));
    EXPECT_EQ(extent(4, &Terms::glassSamples, term), (Extent{300, 200, 4}));
  }
  EXPECT_EQ(extent(1, &Terms::glassSamples, Terms::THREE_GLASS_SAMPLES_FOUR_ALWAYS), (Extent{300, 200, 4}));
}

TEST(Release, ThroughGlassTheBackgroundHasTheColourOfTheBuffer) {
  constexpr float COLOR = 0.5f, TINT = 0.25f;
  Material tinted = clearGlass();
  tinted.baseColorFactor = glm::vec4(TINT, TINT, TINT, 1);
  const auto scene = sceneOf(stackedSquares(1), tinted);
  const auto seen = [&](int term) {
    Shot shot = shotWith(&Terms::glassBackground, term, 16);
    shot.background.type = Shot::Background::Type::kColor;
    shot.background.color = glm::vec3(COLOR);
    const Frame frame = drawn(scene, shot);
    return glm::dvec2(pixel8(frame, 8, 8)[0], pixel8(frame, 8, 8)[3]) / 255.0;
  };
  const auto encoded = [](float x) { return brdf_f::srgbFromLinear(glm::vec3(x)).x; };
  // Half of a step of 8 bits for colour and alpha, by which a pixel is divided, and what half floats round.
  constexpr double STEP = 1.1 / 255;
  const glm::dvec2 linear = seen(Terms::THREE_GLASS_BACKGROUND_LINEAR);
  EXPECT_NEAR(linear.x, encoded(TINT * COLOR), STEP);
  EXPECT_EQ(linear.y, 1);
  const glm::dvec2 canvas = seen(Terms::THREE_GLASS_BACKGROUND_AS_CANVAS);
  EXPECT_NEAR(canvas.x, encoded(TINT * encoded(COLOR)), STEP);
  EXPECT_EQ(canvas.y, 1);
  // Half of the white shows, and glass of this tint hides all but a quarter of what is seen through.
  const glm::dvec2 white = seen(Terms::THREE_GLASS_BACKGROUND_HALF_WHITE);
  EXPECT_NEAR(white.y, 1 - (1 - 0.5) * static_cast<double>(TINT), STEP);
  EXPECT_NEAR(white.x, encoded(TINT * 0.5f) / white.y, STEP);
}

TEST(Release, InstancesHaveNoColours) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  Instances instances;
  instances.matrices = {glm::mat4(1)};
  instances.centers = {{0, 0, 0}};
  instances.colors = {glm::vec3(0.5f)};
  scene->nodes[0].instances = std::make_shared<const Instances>(instances);
  const auto key = [&](int term) {
    return pass::planDraws(*scene, shotWith(&Terms::instanceColor, term), Limits{}, false).draws.opaque[0].key;
  };
  EXPECT_TRUE(key(Terms::THREE_INSTANCE_COLOR_DRAWN).instanceColor);
  EXPECT_FALSE(key(Terms::THREE_INSTANCE_COLOR_NONE).instanceColor ||
               key(Terms::THREE_INSTANCE_COLOR_NONE).vertexColor);
}

TEST(Release, LinesHaveNoMap) {
  Primitive line = stackedSquares(1);
  line.topology = Topology::kLines;
  Material material;
  material.baseColorTexture.image = 0;
  const auto mapped = [&](int term) {
    const auto scene = sceneOf(line, material);
    return pass::planDraws(*scene, shotWith(&Terms::lineMap, term), Limits{}, false).draws.opaque[0].key.baseColorMap;
  };
  EXPECT_TRUE(mapped(Terms::THREE_LINE_MAP_DRAWN));
  EXPECT_FALSE(mapped(Terms::THREE_LINE_MAP_NONE));
  line.topology = Topology::kPoints;
  EXPECT_TRUE(mapped(Terms::THREE_LINE_MAP_NONE));
}

TEST(Release, WhatHasNoProgramIsNotDrawn) {
  Primitive square = stackedSquares(1);
  square.colors.assign(square.positions.size(), glm::vec4(1));
  auto deformers = std::make_shared<Deformers>();
  deformers->targets.resize(1);
  deformers->targets[0].colors.assign(square.positions.size(), glm::vec4(0));
  square.deformers = deformers;
  Material material;
  material.unlit = true;
  const auto scene = sceneOf(square, material);
  const auto alpha = [&](int term) { return pixel8(drawn(scene, shotWith(&Terms::morphColors, term)), 4, 4)[3]; };
  EXPECT_EQ(alpha(Terms::THREE_MORPH_COLORS_DRAWN), 255);
  EXPECT_EQ(alpha(Terms::THREE_MORPH_COLORS_NO_PROGRAM), 0);
  EXPECT_EQ(alpha(Terms::THREE_MORPH_COLORS_DRAWN_BEFORE), 255);
}

TEST(Release, FramesOfFlatFacesAreNotTurned) {
  Primitive flat = stackedSquares(1);
  flat.normals.clear();
  Material material;
  material.doubleSided = true;
  material.normalTexture.image = 0;
  const auto scene = sceneOf(flat, material);
  const auto turned = [&](int term) {
    return pass::planDraws(*scene, shotWith(&Terms::flatFrames, term), Limits{}, false).draws.opaque[0].key.doubleSided;
  };
  EXPECT_TRUE(turned(Terms::THREE_FLAT_FRAMES_TURNED));
  EXPECT_FALSE(turned(Terms::THREE_FLAT_FRAMES_KEPT));
  EXPECT_TRUE(turned(Terms::THREE_FLAT_FRAMES_TURNED_BEFORE));
}

/// A square with a normal map whose texels lean to the right of the tangents by `lean`, in bytes.
std::shared_ptr<Scene> leaningSquare(const glm::vec3& tangent, int lean) {
  Primitive square = stackedSquares(1);
  square.uvs[0].assign(square.positions.size(), glm::vec2(0.5f));
  square.tangents.assign(square.positions.size(), glm::vec4(tangent, 1));
  Material material;
  material.metallicFactor = 0;
  material.roughnessFactor = 1;
  material.normalTexture.image = 0;
  const auto scene = sceneOf(square, material);
  Image8 image;
  image.width = image.height = 1;
  for (const int value : {127 + lean, 128, 220, 255}) image.pixels.push_back(static_cast<std::uint8_t>(value));
  scene->images = std::vector<Image8>{image};
  return scene;
}

Shot shotFromTheSide(int Terms::*slot, int term) {
  Shot shot = shotWith(slot, term);
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {2, 0.5, 1.5};
  shot.lights = {sun};
  return shot;
}

int brightness(const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  return pixel8(drawn(scene, shot), 4, 4)[1];
}

TEST(Release, TangentsDoNotTurnWithInstances) {
  const glm::dmat4 quarter = glm::rotate(glm::dmat4(1), glm::half_pi<double>(), glm::dvec3(0, 0, 1));
  const auto asNode = [&](const glm::vec3& tangent) {
    auto scene = leaningSquare(tangent, 80);
    scene->nodes[0].world = quarter;
    return scene;
  };
  auto scene = leaningSquare({1, 0, 0}, 80);
  Instances instances;
  instances.matrices = {glm::mat4(quarter)};
  instances.centers = {{0, 0, 0}};
  scene->nodes[0].instances = std::make_shared<const Instances>(instances);
  const auto slot = &Terms::instanceTangents;
  const Shot today = shotFromTheSide(slot, Terms::THREE_INSTANCE_TANGENTS_TURNED);
  const Shot older = shotFromTheSide(slot, Terms::THREE_INSTANCE_TANGENTS_OF_MESH);
  const int turned = brightness(scene, today), kept = brightness(scene, older);
  EXPECT_NEAR(turned, brightness(asNode({1, 0, 0}), today), 1);
  // A tangent that the node turns into that of the mesh.
  EXPECT_NEAR(kept, brightness(asNode({0, -1, 0}), today), 1);
  EXPECT_GT(std::abs(turned - kept), 10);
}

TEST(Release, TangentsOfBackSidesThatAreDrawnAsFrontSidesAreTurned) {
  const auto blended = [](int lean) {
    auto scene = leaningSquare({1, 0, 0}, lean);
    scene->nodes[0].world = glm::rotate(glm::dmat4(1), glm::pi<double>(), glm::dvec3(0, 1, 0));
    scene->materials[0].doubleSided = true;
    scene->materials[0].alphaMode = AlphaMode::kBlend;
    return scene;
  };
  const auto slot = &Terms::flippedTangents;
  const Shot today = shotFromTheSide(slot, Terms::THREE_FLIPPED_TANGENTS_KEPT);
  const Shot older = shotFromTheSide(slot, Terms::THREE_FLIPPED_TANGENTS_TURNED);
  // 127 + lean and 127 + 1 - lean are as far from the middle of 0 to 255.
  const int turned = brightness(blended(80), older);
  EXPECT_NEAR(turned, brightness(blended(1 - 80), today), 1);
  EXPECT_GT(std::abs(turned - brightness(blended(80), today)), 10);
}

}  // namespace
}  // namespace telar
