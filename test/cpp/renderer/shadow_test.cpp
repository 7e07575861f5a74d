#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "pass/plan/draw_list.h"
#include "renderer/scenes.h"
#include "telar/error.h"

namespace telar::shadow_test {
namespace {

using test::casting;
using test::pixel8;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using Light = Shot::Light;

/// A level square of edge 4 at y = -1.
Primitive floorPrimitive() {
  Primitive p;
  for (const auto& [x, z] : {std::pair(-2.f, -2.f), {-2.f, 2.f}, {2.f, 2.f}, {2.f, -2.f}}) {
    p.positions.push_back({x, -1, z});
    p.normals.push_back({0, 1, 0});
    p.bounds.add(glm::dvec3(p.positions.back()));
  }
  p.indices = {0, 1, 2, 0, 2, 3};
  p.material = 0;
  return p;
}

Material dull() {
  Material material;
  material.metallicFactor = 0;
  return material;
}

/// A ball of radius 0.5, of the scene's last material, over the floor.
std::shared_ptr<Scene> stage(const Material& ball = dull()) {
  auto scene = std::make_shared<Scene>();
  scene->materials = {dull(), ball};
  Primitive sphere = spherePrimitive(0.5f, 24);
  sphere.material = 1;
  scene->meshes.push_back({"mesh", {sphere, floorPrimitive()}});
  Node node;
  node.mesh = 0;
  scene->nodes.push_back(node);
  return scene;
}

/// From above at 45 degrees.
Shot stageShot(std::vector<Light> lights) {
  Shot shot = shotOf(64);
  shot.camera.position = {0, 5, 5};
  shot.camera.near = 1;
  shot.camera.far = 20;
  shot.lights = std::move(lights);
  return shot;
}

struct Drawn {
  Frame frame;
  nlohmann::json info;
};

Drawn draw(const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  Frame frame = Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
  return {std::move(frame), nlohmann::json::parse(info.json)};
}

/// Pixel that shows a point of the world.
const std::uint8_t* at(const Drawn& drawn, const glm::dvec4& point) {
  const auto m = drawn.info["worldToPixel"].get<std::vector<double>>();
  glm::dvec4 p(0);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) p[row] += m[static_cast<std::size_t>(column * 4 + row)] * point[column];
  }
  return pixel8(drawn.frame, static_cast<std::uint32_t>(p.x / p.w), static_cast<std::uint32_t>(p.y / p.w));
}

TEST(Shadow, EachKindOfLightIsHiddenByTheModelAndTheFarSideIsLit) {
  for (const auto type : {Light::Type::kDirectional, Light::Type::kSpot, Light::Type::kPoint}) {
    // The light stands to the left: the ball's shadow falls to the right.
    const Drawn drawn = draw(stage(), stageShot({casting(type, {-2, 3, 0})}));
    EXPECT_EQ(at(drawn, {0.5, -1, 0, 1})[0], 0) << static_cast<int>(type);
    EXPECT_GT(at(drawn, {-0.9, -1, 0, 1})[0], 60) << static_cast<int>(type);
  }
}

TEST(Shadow, IntensityLeavesAPartOfTheLight) {
  Light half = casting(Light::Type::kDirectional, {-2, 3, 0});
  half.shadow.intensity = 0.5;
  const Drawn drawn = draw(stage(), stageShot({half}));
  const int shaded = at(drawn, {0.5, -1, 0, 1})[0], lit = at(drawn, {-0.9, -1, 0, 1})[0];
  EXPECT_GT(shaded, 20);
  EXPECT_LT(shaded, lit - 20);
}

TEST(Shadow, AMaskLetsLightThrough) {
  Material holed = dull();
  holed.alphaMode = AlphaMode::kMask;
  holed.doubleSided = true;
  holed.baseColorTexture.image = 0;
  const auto scene = stage(holed);
  scene->images = {Image8{1, 1, {255, 255, 255, 0}}};
  EXPECT_GT(at(draw(scene, stageShot({casting(Light::Type::kDirectional, {-2, 3, 0})})), {0.5, -1, 0, 1})[0], 60);
}

TEST(Shadow, TheGroundShowsTheShadowAndNothingElse) {
  const auto scene = sceneOf(spherePrimitive(0.5f, 24), dull());
  Shot shot = stageShot({casting(Light::Type::kDirectional, {-2, 3, 0})});
  shot.ground = Shot::Ground{0.5, {0, -1, 0}, {4, 4}};
  const Drawn drawn = draw(scene, shot);
  const std::uint8_t* shadow = at(drawn, {0.5, -1, 0, 1});
  EXPECT_EQ(shadow[0], 0);
  EXPECT_NEAR(shadow[3], 128, 1);
  EXPECT_EQ(at(drawn, {-0.9, -1, 0, 1})[3], 0);
  EXPECT_EQ(drawn.info["passes"], nlohmann::json::array({"shadow-directional", "opaque", "ground", "resolve"}));
}

TEST(Shadow, ALightThatShinesOnNothingShadowsTheGroundAlone) {
  const auto scene = stage();
  Shot shot = stageShot({casting(Light::Type::kDirectional, {-2, 3, 0})});
  shot.lights[0].intensity = 0;
  shot.ground = Shot::Ground{1, {0, -0.99, 0}, {4, 4}};
  const auto plan = pass::planDraws(*scene, shot, Limits{}, false);
  EXPECT_EQ(plan.draws.opaque[0].key.lights.shadows(), 0);
  EXPECT_EQ(plan.shadows.flat.size(), 1u);
  EXPECT_EQ(at(draw(scene, shot), {0.5, -1, 0, 1})[3], 255);
}

TEST(Shadow, WithoutCastersNothingIsPaid) {
  Shot shot = stageShot({Light{Light::Type::kPoint}});
  shot.ground = Shot::Ground{1, {0, -1, 0}, {4, 4}};
  const Drawn drawn = draw(stage(), shot);
  EXPECT_EQ(drawn.info["passes"], nlohmann::json::array({"opaque", "resolve"}));
  EXPECT_FALSE(drawn.info["ms"].contains("shadows"));
}

TEST(Shadow, MapsAreReusedAndFreed) {
  const auto renderer = Renderer::create({});
  const auto scene = stage();
  const auto count = [&](std::vector<Light> lights) {
    FrameInfo info;
    renderer->draw(scene, stageShot(std::move(lights)), {}, CancelToken(), info);
    return renderer->liveObjects();
  };
  const Light sun = casting(Light::Type::kDirectional, {-2, 3, 0}), lamp = casting(Light::Type::kPoint, {-2, 3, 0}, 64);
  count({sun, lamp});
  count({sun});
  const int none = count({});
  const int one = count({sun});
  EXPECT_EQ(one, none + 2);                // texture and framebuffer
  EXPECT_EQ(count({sun, lamp}), one + 7);  // texture and six framebuffers
  EXPECT_EQ(count({sun, lamp}), one + 7);
  EXPECT_EQ(count({}), none);
}

/// As three.js before 0.182.
Shot packed(Shot shot) {
  shot.three.shadowFilter = ThreeTerms::THREE_SHADOW_FILTER_PACKED_GRID;
  shot.three.pointShadow = ThreeTerms::THREE_POINT_SHADOW_RANGE_LIT;
  return shot;
}

TEST(PackedShadow, EachKindOfLightIsHiddenByTheModelAndTheFarSideIsLit) {
  for (const auto type : {Light::Type::kDirectional, Light::Type::kSpot, Light::Type::kPoint}) {
    const Drawn drawn = draw(stage(), packed(stageShot({casting(type, {-2, 3, 0})})));
    EXPECT_EQ(at(drawn, {0.5, -1, 0, 1})[0], 0) << static_cast<int>(type);
    EXPECT_GT(at(drawn, {-0.9, -1, 0, 1})[0], 60) << static_cast<int>(type);
  }
}

TEST(PackedShadow, AMaskLetsLightThrough) {
  Material holed = dull();
  holed.alphaMode = AlphaMode::kMask;
  holed.doubleSided = true;
  holed.baseColorTexture.image = 0;
  const auto scene = stage(holed);
  scene->images = {Image8{1, 1, {255, 255, 255, 0}}};
  for (const auto type : {Light::Type::kDirectional, Light::Type::kPoint})
    EXPECT_GT(at(draw(scene, packed(stageShot({casting(type, {-2, 3, 0})}))), {0.5, -1, 0, 1})[0], 60);
}

TEST(PackedShadow, MapsAreMadeAnewForAnotherFilter) {
  const auto renderer = Renderer::create({});
  const auto scene = stage();
  const auto count = [&](const Shot& shot) {
    FrameInfo info;
    renderer->draw(scene, shot, {}, CancelToken(), info);
    return renderer->liveObjects();
  };
  const Shot shot = stageShot({casting(Light::Type::kPoint, {-2, 3, 0}, 64)});
  count(stageShot({}));
  count(shot), count(packed(shot));  // programs stay
  const int none = count(stageShot({}));
  EXPECT_EQ(count(shot), none + 7);          // texture and six framebuffers
  EXPECT_EQ(count(packed(shot)), none + 3);  // texture, depth and one framebuffer of an atlas
  EXPECT_EQ(count(packed(shot)), none + 3);
  EXPECT_EQ(count(shot), none + 7);
}

TEST(PackedShadow, AnAtlasIsFourFacesWide) {
  FrameInfo info;
  const Shot shot = packed(stageShot({casting(Light::Type::kPoint, {-2, 3, 0}, 1 << 14)}));
  RendererOptions options;
  options.limits.shadowTexels = std::uint64_t{1} << 40;
  const auto renderer = Renderer::create(options);
  EXPECT_ERROR(renderer->draw(stage(), shot, {}, CancelToken(), info), "L_OUTPUT_SIZE");
}

TEST(OlderShadow, IntensityIsNotReadBefore166) {
  Light half = casting(Light::Type::kDirectional, {-2, 3, 0});
  half.shadow.intensity = 0.5;
  Shot shot = stageShot({half});
  shot.three.shadowIntensity = ThreeTerms::THREE_SHADOW_INTENSITY_WHOLE;
  EXPECT_EQ(at(draw(stage(), shot), {0.5, -1, 0, 1})[0], 0);
}

/// The floor has no normals; the ball's shadow would fall on it.
TEST(OlderShadow, WithoutNormalsThereIsNoPlaceInAMap) {
  const auto scene = stage();
  std::vector<Primitive> bare(scene->meshes[0].primitives.begin(), scene->meshes[0].primitives.end());
  for (Primitive& primitive : bare) primitive.normals.clear();
  scene->meshes[0].primitives = bare;
  const auto shadow = [&](Light::Type type, int filter, int pointShadow) {
    Shot shot = stageShot({casting(type, {-2, 3, 0})});
    shot.three.shadowNormalOffset = ThreeTerms::THREE_SHADOW_NORMAL_OFFSET_NO_PLACE;
    shot.three.shadowFilter = filter;
    shot.three.pointShadow = pointShadow;
    const Drawn drawn = draw(scene, shot);
    return std::pair(at(drawn, {0.5, -1, 0, 1})[0], at(drawn, {-0.9, -1, 0, 1})[0]);
  };
  for (const int filter : {ThreeTerms::THREE_SHADOW_FILTER_DEPTH_DISK, ThreeTerms::THREE_SHADOW_FILTER_PACKED_GRID}) {
    for (const auto type : {Light::Type::kDirectional, Light::Type::kSpot, Light::Type::kPoint}) {
      const auto [near, far] = shadow(type, filter, ThreeTerms::THREE_POINT_SHADOW_RANGE_LIT);
      EXPECT_GT(near, 60) << static_cast<int>(type);
      EXPECT_GT(far, 60) << static_cast<int>(type);
    }
  }
  const auto [near, far] = shadow(Light::Type::kPoint, ThreeTerms::THREE_SHADOW_FILTER_PACKED_GRID,
                                  ThreeTerms::THREE_POINT_SHADOW_RANGE_COMPARED);
  EXPECT_EQ(near, 0);
  EXPECT_EQ(far, 0);
}

std::string codeOf(const Scene& scene, const Shot& shot, const Limits& limits = {}) {
  try {
    pass::planDraws(scene, shot, limits, false);
  } catch (const Error& error) {
    return error.code;
  }
  return "none";
}

TEST(Shadow, MapsAreLimitedBeforeTheyAreMade) {
  const auto scene = stage();
  // A cube has six faces: 6 * 2048^2 texels fit, twice as many do not.
  const Light lamp = casting(Light::Type::kPoint, {-2, 3, 0}, 2048);
  EXPECT_EQ(codeOf(*scene, stageShot({lamp})), "none");
  EXPECT_EQ(codeOf(*scene, stageShot({lamp, lamp})), "L_SHADOW_TEXELS");
  EXPECT_EQ(codeOf(*scene, stageShot(std::vector(65, casting(Light::Type::kSpot, {-2, 3, 0}, 16)))), "L_LIGHTS");
}

TEST(Shadow, TextureUnitsAreLimitedToThoseOfWebGl2) {
  const auto scene = stage();
  // One unit is the table of the split sum.
  EXPECT_EQ(codeOf(*scene, stageShot(std::vector(15, casting(Light::Type::kSpot, {-2, 3, 0}, 16)))), "none");
  EXPECT_EQ(codeOf(*scene, stageShot(std::vector(16, casting(Light::Type::kSpot, {-2, 3, 0}, 16)))), "L_TEXTURE_UNITS");
  scene->images = {Image8{1, 1, {255, 255, 255, 255}}};
  scene->materials[0].baseColorTexture.image = scene->materials[0].normalTexture.image = 0;
  EXPECT_EQ(codeOf(*scene, stageShot(std::vector(14, casting(Light::Type::kSpot, {-2, 3, 0}, 16)))), "L_TEXTURE_UNITS");
  EXPECT_EQ(codeOf(*scene, stageShot(std::vector(13, casting(Light::Type::kSpot, {-2, 3, 0}, 16)))), "none");
}

TEST(Shadow, ADozenLightsOfAllKindsCompileAndDraw) {
  std::vector<Light> lights;
  for (int i = 0; i < 4; ++i) {
    for (const auto type : {Light::Type::kPoint, Light::Type::kDirectional, Light::Type::kSpot})
      lights.push_back(casting(type, {-2.0 + i, 3, 0.3 * i}, 32));
  }
  Shot shot = stageShot(lights);
  shot.ground = Shot::Ground{0.5, {0, -1.1, 0}, {4, 4}};
  const Drawn drawn = draw(stage(), shot);
  EXPECT_EQ(drawn.info["features"],
            nlohmann::json::array({"4 directional-lights", "4 directional-shadows", "4 point-lights", "4 point-shadows",
                                   "4 spot-lights", "4 spot-shadows"}));
}

}  // namespace
}  // namespace telar::shadow_test
