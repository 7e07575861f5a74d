#include "pass/plan/fragment_estimate.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "renderer/scenes.h"

namespace telar::fragment_estimate_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using test::stackedSquares;

constexpr int SIZE = 32, SUBSAMPLES = 8;

float edge(const glm::vec2& a, const glm::vec2& b, const glm::vec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Pixels of which a triangle holds one of a grid of points. Corners in normalized device coordinates.
int touchedPixels(const std::vector<glm::vec3>& triangle) {
  const glm::vec2 corners[] = {glm::vec2(triangle[0]), glm::vec2(triangle[1]), glm::vec2(triangle[2])};
  const glm::vec2 least = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const glm::vec2 most = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  int touched = 0;
  for (int pixel = 0; pixel < SIZE * SIZE; ++pixel) {
    bool holds = false;
    const glm::vec2 low = glm::vec2(pixel % SIZE, pixel / SIZE) / (SIZE * 0.5f) - 1.0f;
    if (glm::any(glm::greaterThan(low, most)) || glm::any(glm::lessThan(low + 2.0f / SIZE, least))) continue;
    for (int i = 0; i < SUBSAMPLES * SUBSAMPLES && !holds; ++i) {
      const glm::vec2 in((static_cast<float>(i % SUBSAMPLES) + 0.5f) / SUBSAMPLES,
                         (static_cast<float>(i / SUBSAMPLES) + 0.5f) / SUBSAMPLES);
      const glm::vec2 p = (glm::vec2(pixel % SIZE, pixel / SIZE) + in) / (SIZE * 0.5f) - 1.0f;
      const float a = edge(corners[0], corners[1], p), b = edge(corners[1], corners[2], p),
                  c = edge(corners[2], corners[0], p);
      holds = (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
    }
    touched += holds;
  }
  return touched;
}

TEST(FragmentEstimate, IsNeverLessThanThePixelsThatATriangleTouches) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> anywhere(-1.6f, 1.6f), little(-0.2f, 0.2f);
  double sum = 0, touchedSum = 0;
  for (int i = 0; i < 600; ++i) {
    Primitive triangle;
    const glm::vec3 first(anywhere(random), anywhere(random), 0);
    const bool small = i % 2 == 0;
    for (int corner = 0; corner < 3; ++corner) {
      triangle.positions.push_back(small ? first + glm::vec3(little(random), little(random), 0)
                                         : glm::vec3(anywhere(random), anywhere(random), 0));
    }
    const pass::FragmentEstimate estimate(triangle, glm::dmat4(1), SIZE, SIZE);
    const int touched = touchedPixels(triangle.positions);
    ASSERT_EQ(estimate.parts(), 1u);
    EXPECT_GE(estimate.of(0), touched);
    sum += estimate.of(0);
    touchedSum += touched;
  }
  EXPECT_LT(sum, 2 * touchedSum) << "an estimate that is far too high refuses what can be drawn";
}

TEST(FragmentEstimate, TheQuickBoundIsNeverLessThanTheCount) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> inside(-1, 1), depth(-4, 2.9f);
  const frame::Camera camera = frame::cameraOf(shotOf(SIZE));
  for (const Topology topology : {Topology::kTriangles, Topology::kLines, Topology::kLineLoop, Topology::kPoints}) {
    for (int i = 0; i < 200; ++i) {
      Primitive primitive;
      primitive.topology = topology;
      const glm::vec3 at(inside(random), inside(random), depth(random));
      for (int corner = 0; corner < 60; ++corner) {
        primitive.positions.push_back(at + glm::vec3(inside(random), inside(random), inside(random)));
        primitive.bounds.add(glm::dvec3(primitive.positions.back()));
      }
      const pass::PartExtents extents(primitive);
      pass::FragmentEstimate estimate(primitive, camera.projection * camera.view, SIZE, SIZE);
      EXPECT_LE(estimate.all(1e9), estimate.atMost(extents.all) * (1 + 1e-6));
      estimate.moveTo(glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1, 0.5f, 2)), 0.5f, glm::vec3(1, 1, 0)));
      EXPECT_LE(estimate.all(1e9), estimate.atMost(extents.all) * (1 + 1e-6));
    }
  }
}

TEST(FragmentEstimate, TheQuickBoundOfABallIsOfUse) {
  const Primitive ball = spherePrimitive(1, 32);
  const frame::Camera camera = frame::cameraOf(shotOf(256));
  const pass::FragmentEstimate estimate(ball, camera.projection * camera.view, 256, 256);
  EXPECT_LT(estimate.atMost(pass::PartExtents(ball).all), 4 * estimate.all(1e9));
}

TEST(FragmentEstimate, WhatLiesOutsideIsNotCounted) {
  Primitive triangle;
  triangle.positions = {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
  EXPECT_EQ(pass::FragmentEstimate(triangle, glm::dmat4(1), SIZE, SIZE).of(0), 0);
}

TEST(FragmentEstimate, ATriangleThroughTheEyeMayFillThePicture) {
  Primitive triangle;
  triangle.positions = {{0, 0, -5}, {1, 0, 5}, {0, 1, 5}};
  const glm::dmat4 toClip = frame::cameraOf(shotOf(SIZE)).projection;
  EXPECT_EQ(pass::FragmentEstimate(triangle, toClip, SIZE, SIZE).of(0), SIZE * SIZE);
}

TEST(FragmentEstimate, InstancesAreCountedWhereTheyStand) {
  Primitive triangle;
  triangle.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
  pass::FragmentEstimate estimate(triangle, glm::dmat4(1), SIZE, SIZE);
  EXPECT_GE(estimate.all(1e9), SIZE * SIZE);
  estimate.moveTo(glm::translate(glm::mat4(1), glm::vec3(9, 0, 0)));
  EXPECT_EQ(estimate.all(1e9), 0);
}

TEST(FragmentEstimate, PartsOfEachTopology) {
  const std::pair<Topology, std::size_t> expected[] = {{Topology::kPoints, 6},
                                                       {Topology::kLines, 3},
                                                       {Topology::kLineStrip, 5},
                                                       {Topology::kLineLoop, 6},
                                                       {Topology::kTriangles, 2}};
  for (const auto& [topology, parts] : expected) {
    Primitive primitive;
    primitive.topology = topology;
    for (int i = 0; i < 6; ++i) primitive.positions.push_back({static_cast<float>(i) / 6, 0.1f * (i % 2), 0});
    const pass::FragmentEstimate estimate(primitive, glm::dmat4(1), SIZE, SIZE);
    EXPECT_EQ(estimate.parts(), parts);
    EXPECT_GE(estimate.all(1e9), static_cast<double>(parts));
  }
}

void check(const Scene& scene, const Shot& shot, std::uint64_t most, const CancelToken& cancel = {}) {
  Limits limits;
  limits.fragments = most;
  std::map<const Primitive*, pass::PartExtents> extents;
  const auto extentsOf = [&](const Primitive& primitive) -> const pass::PartExtents& {
    return extents.try_emplace(&primitive, primitive).first->second;
  };
  pass::checkFragments(pass::planDraws(scene, shot, limits, false), shot, extentsOf, limits, cancel);
}

TEST(CheckFragments, StacksOverTheLimitAreRefusedWithWhatWasCounted) {
  const Shot shot = shotOf(64);
  const auto scene = sceneOf(stackedSquares(100));
  EXPECT_NO_THROW(check(*scene, shot, 2 * 100 * 66 * 66));
  try {
    check(*scene, shot, 100 * 64 * 64);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "L_FRAGMENTS");
    ASSERT_TRUE(error.limit);
    EXPECT_EQ(error.limit->max, 100.0 * 64 * 64);
    EXPECT_GT(error.limit->actual, error.limit->max);
  }
}

TEST(CheckFragments, FineTrianglesArePlacesNotPictures) {
  // 130,000 triangles of a ball: each could fill the picture, together they cover it about three times.
  const Shot shot = shotOf(256);
  const auto scene = sceneOf(spherePrimitive(1, 256));
  EXPECT_NO_THROW(check(*scene, shot, 3'000'000));
}

TEST(CheckFragments, CountingEndsWithTheJob) {
  const CancelToken cancelled;
  cancelled.cancel();
  try {
    check(*sceneOf(stackedSquares(10)), shotOf(64), 1, cancelled);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "X_CANCELLED");
  }
}

TEST(PlanFrame, TellsTheFragments) {
  const auto json = nlohmann::json::parse(planFrame(*sceneOf(stackedSquares(3)), shotOf(64), Limits{}));
  EXPECT_GE(json["fragments"], 3 * 64 * 64);
  EXPECT_LE(json["fragments"], 3 * 2 * 66 * 66);
}

}  // namespace
}  // namespace telar::fragment_estimate_test
