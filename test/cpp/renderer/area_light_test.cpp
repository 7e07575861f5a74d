#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pass/plan/draw_list.h"
#include "renderer/scenes.h"

/// Area lights by what closed forms say of them, and where three.js 0.187 or their own numbers have an edge.
namespace telar {
namespace {

using test::pixelF;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

constexpr std::uint32_t SIZE = 48;

Shot::Light rect(const glm::dvec3& position, const glm::dvec3& target, double width, double height) {
  Shot::Light light{Shot::Light::Type::kRect};
  light.position = position;
  light.target = target;
  light.width = width;
  light.height = height;
  light.intensity = 10;
  return light;
}

Shot::Light disk(const glm::dvec3& position, const glm::dvec3& target, double radius) {
  Shot::Light light{Shot::Light::Type::kDisk};
  light.position = position;
  light.target = target;
  light.radius = radius;
  light.intensity = 10;
  return light;
}

Shot litBy(const Shot::Light& light) {
  Shot shot = shotOf(SIZE);
  shot.output.bitDepth = 32;
  shot.lights = {light};
  return shot;
}

/// White that reflects as a cosine alone.
Material matt() {
  Material material;
  material.physical = true;
  material.metallicFactor = 0;
  material.layers.specularFactor = 0;
  return material;
}

/// A square of 2 x 2 that faces +Z.
Primitive facing() {
  Primitive p;
  for (const glm::vec3 v : {glm::vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}) {
    p.positions.push_back(v);
    p.normals.push_back({0, 0, 1});
    p.bounds.add(glm::dvec3(v));
  }
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

Frame draw(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot) {
  FrameInfo info;
  return renderer.draw(scene, shot, {}, CancelToken(), info);
}

/// Largest radiance; fails on a pixel that is negative or not a number.
float brightest(const Frame& frame) {
  float most = 0;
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    for (std::uint32_t x = 0; x < frame.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        EXPECT_TRUE(std::isfinite(pixelF(frame, x, y)[c]) && pixelF(frame, x, y)[c] >= 0) << x << ", " << y;
      }
      most = std::max(most, pixelF(frame, x, y)[0]);
    }
  }
  return most;
}

TEST(RectLight, IsCompiledOnlyWhereThereIsOne) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  const auto with = pass::planDraws(*scene, litBy(rect({0, 1, 3}, {}, 1, 1)), Limits{}, false);
  EXPECT_EQ(with.draws.opaque[0].key.features(), (std::vector<std::string>{"linear-output", "1 rect-light"}));
  Shot::Light black = rect({0, 1, 3}, {}, 1, 1);
  black.intensity = 0;
  EXPECT_EQ(pass::planDraws(*scene, litBy(black), Limits{}, false).draws.opaque[0].key.lights.rect, 0);
}

TEST(RectLight, TablesAreUploadedForTheFirstFrameThatNeedsThem) {
  const auto renderer = Renderer::create({});
  const auto scene = sceneOf(spherePrimitive(1, 4));
  const auto glObjects = [&](const Shot& shot) {
    FrameInfo info;
    renderer->draw(scene, shot, {}, CancelToken(), info);
    return nlohmann::json::parse(info.json).at("glObjects").get<int>();
  };
  Shot::Light point{Shot::Light::Type::kPoint};
  point.position = {0, 1, 3};
  const int none = glObjects(litBy(point)), first = glObjects(litBy(rect({0, 1, 3}, {}, 1, 1)));
  EXPECT_EQ(first, none + 3) << "two tables and a program";
  EXPECT_EQ(glObjects(litBy(rect({1, 1, 3}, {}, 2, 1))), first);
}

TEST(RectLight, StaysFiniteWhereverItLiesAndHoweverLargeItIs) {
  const auto renderer = Renderer::create({});
  const auto ball = sceneOf(spherePrimitive(1));
  // On the ball's pole with a corner, through it, in the plane of points, behind.
  for (const glm::dvec3 position :
       {glm::dvec3(0, 0, 1), {0.5, 0.5, 1}, {0, 0, 0}, {0, 0, 1e-9}, {1e30, 0, 1}, {0, 2, 0}}) {
    for (const glm::dvec3 target : {glm::dvec3(0, 0, 0), {0, 0, 5}, {1, 0, 1}}) {
      for (const double edge : {1.0, 1e-12, 1e6}) {
        SCOPED_TRACE(testing::PrintToString(position.z) + " " + testing::PrintToString(edge));
        brightest(draw(*renderer, ball, litBy(rect(position, target, edge, edge))));
      }
    }
  }
  EXPECT_EQ(brightest(draw(*renderer, ball, litBy(rect({0, 0, 3}, {}, 0, 1)))), 0) << "a line gives nothing";
  EXPECT_EQ(brightest(draw(*renderer, ball, litBy(rect({0, 0, 3}, {0, 0, 4}, 1, 1)))), 0) << "it shines to one side";
  EXPECT_GT(brightest(draw(*renderer, ball, litBy(rect({0, 0, 3}, {}, 1, 1)))), 0.01f);
}

TEST(RectLight, IsSeenHeadOnAsItIsBesideThat) {
  Material material;
  material.metallicFactor = 0;
  material.roughnessFactor = 0.5f;
  const auto scene = sceneOf(facing(), material);
  Shot shot = litBy(rect({0.5, 0.5, 1.5}, {}, 1, 1));
  shot.camera.projection = Projection::kOrthographic;
  shot.camera.height = 1.9;
  const auto renderer = Renderer::create({});
  const Frame headOn = draw(*renderer, scene, shot);
  for (const double aside : {1e-7, 1e-5, 1e-4, 1e-3}) {
    shot.camera.position.x = aside * 5;
    const Frame beside = draw(*renderer, scene, shot);
    for (std::uint32_t y = 0; y < SIZE; ++y) {
      for (std::uint32_t x = 0; x < SIZE; ++x)
        ASSERT_NEAR(pixelF(beside, x, y)[0], pixelF(headOn, x, y)[0], 0.01) << aside << " at " << x << ", " << y;
    }
  }
  EXPECT_GT(pixelF(headOn, SIZE / 2, SIZE / 2)[0], 0.5f);
}

TEST(RectLight, LightsAMattSurfaceByItsFormFactor) {
  const auto renderer = Renderer::create({});
  const auto scene = sceneOf(facing(), matt());
  for (const glm::dvec3 light : {glm::dvec3(1, 1, 1.5), {4, 0.5, 0.5}, {0.1, 0.1, 2}}) {  // width, height, distance
    // A quarter of it, as seen from below its corner.
    const double a = light.x / 2 / light.z, b = light.y / 2 / light.z;
    const double A = a / std::sqrt(1 + a * a), B = b / std::sqrt(1 + b * b);
    const double quarter =
        (A * std::atan(b / std::sqrt(1 + a * a)) + B * std::atan(a / std::sqrt(1 + b * b))) / (2 * 3.14159265358979);
    const Frame frame = draw(*renderer, scene, litBy(rect({0, 0, light.z}, {}, light.x, light.y)));
    const double expected = 10 * 4 * quarter;
    EXPECT_NEAR(pixelF(frame, SIZE / 2, SIZE / 2)[0], expected, 0.005 * expected);
  }
}

TEST(DiskLight, LightsAMattSurfaceByItsFormFactor) {
  const auto renderer = Renderer::create({});
  const auto scene = sceneOf(facing(), matt());
  for (const glm::dvec2 light : {glm::dvec2(1, 1.5), {3, 0.5}, {0.05, 2}}) {  // radius, distance
    const Frame frame = draw(*renderer, scene, litBy(disk({0, 0, light.y}, {}, light.x)));
    const double expected = 10 * light.x * light.x / (light.x * light.x + light.y * light.y);
    EXPECT_NEAR(pixelF(frame, SIZE / 2, SIZE / 2)[0], expected, 0.01 * expected);
  }
}

TEST(DiskLight, IsCompiledOnlyWhereThereIsOne) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  Shot::Light light = disk({0, 1, 3}, {}, 1);
  const auto with = pass::planDraws(*scene, litBy(light), Limits{}, false);
  EXPECT_EQ(with.draws.opaque[0].key.features(), (std::vector<std::string>{"linear-output", "1 disk-light"}));
  light.intensity = 0;
  EXPECT_EQ(pass::planDraws(*scene, litBy(light), Limits{}, false).draws.opaque[0].key.lights.disk, 0);
}

TEST(DiskLight, StaysFiniteWhereverItLiesAndHoweverLargeItIs) {
  const auto renderer = Renderer::create({});
  const auto ball = sceneOf(spherePrimitive(1));
  for (const glm::dvec3 position : {glm::dvec3(0, 0, 1), {0.5, 0.5, 1}, {0, 0, 0}, {1e30, 0, 1}, {0, 2, 0}}) {
    for (const double radius : {1.0, 1e-12, 1e6}) {
      SCOPED_TRACE(testing::PrintToString(position.z) + " " + testing::PrintToString(radius));
      brightest(draw(*renderer, ball, litBy(disk(position, {0, 0, 5}, radius))));
    }
  }
  EXPECT_EQ(brightest(draw(*renderer, ball, litBy(disk({0, 0, 3}, {}, 0)))), 0) << "a point gives nothing";
  EXPECT_EQ(brightest(draw(*renderer, ball, litBy(disk({0, 0, 3}, {0, 0, 4}, 1)))), 0) << "it shines to one side";
  EXPECT_GT(brightest(draw(*renderer, ball, litBy(disk({0, 0, 3}, {}, 1)))), 0.01f);
}

TEST(AreaLight, RectangleAndDiskAddUpInEveryShading) {
  const auto renderer = Renderer::create({});
  Material material;
  material.physical = true;
  material.metallicFactor = 0;
  material.roughnessFactor = 0.4f;
  material.layers.sheenColorFactor = glm::vec3(0.3f, 0.2f, 0.1f);
  material.layers.sheenRoughnessFactor = 0.5f;
  material.layers.clearcoatFactor = 0.5f;
  const auto scene = sceneOf(spherePrimitive(1, 16), material);
  const Shot::Light left = rect({-2, 1, 2}, {}, 1, 2), right = disk({2, 0, 1}, {}, 0.8);
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kDisney2012, ShadingModel::kFabric}) {
    Shot shot = litBy(left);
    shot.shading = shading;
    const auto pictureOf = [&](std::vector<Shot::Light> lights) {
      shot.lights = std::move(lights);
      return draw(*renderer, scene, shot);
    };
    const Frame a = pictureOf({left}), b = pictureOf({right}), both = pictureOf({left, right});
    for (std::uint32_t y = 0; y < SIZE; ++y) {
      for (std::uint32_t x = 0; x < SIZE; ++x) {
        const float sum = pixelF(a, x, y)[0] + pixelF(b, x, y)[0];
        ASSERT_NEAR(pixelF(both, x, y)[0], sum, 1e-5f * sum + 1e-6f) << x << ", " << y;
      }
    }
    EXPECT_GT(brightest(a), 0.1f);
    EXPECT_GT(brightest(b), 0.1f);
  }
}

}  // namespace
}  // namespace telar
