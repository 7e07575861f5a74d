#include "flat/flat.h"

#include <gtest/gtest.h>

#include "cpu_clock.h"
#include "expect_error.h"
#include "flat/lines.h"
#include "measure/shapes.h"

namespace telar::flat::flat_test {
namespace {

using surface::buildSurface;
using surface::Surface;

/// From +z, orthographic, `height` metres over `pixels`.
Shot frontOf(int pixels, double height, const glm::dvec3& target, double side = 1) {
  Shot shot;
  shot.width = shot.height = pixels;
  shot.camera.projection = Projection::kOrthographic;
  shot.camera.target = target;
  shot.camera.position = target + glm::dvec3(0, 0, 10 * side);
  shot.camera.height = height;
  shot.camera.near = 1;
  shot.camera.far = 20;
  return shot;
}

std::vector<Stroke> strokesOf(const Surface& surface, const Shot& shot, const FlatOptions& options) {
  const CancelToken cancel;
  const View view(surface, shot, cancel);
  return strokesOf(visiblePieces(surface, view, options, cancel), options, cancel);
}

std::vector<Stroke> ofKind(const std::vector<Stroke>& strokes, Kind kind) {
  std::vector<Stroke> out;
  for (const Stroke& stroke : strokes) {
    if (stroke.kind == kind) out.push_back(stroke);
  }
  return out;
}

double lengthOf(const Stroke& stroke) {
  double sum = stroke.closed ? glm::distance(stroke.points.front(), stroke.points.back()) : 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) sum += glm::distance(stroke.points[i - 1], stroke.points[i]);
  return sum;
}

/// A square of `size` about a place, in front of others by its z.
void addSquare(Scene& scene, const glm::dvec3& at, double size) {
  const Scene one =
      test::sceneOf({{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}}, {0, 1, 2, 0, 2, 3});
  scene.meshes.push_back(one.meshes[0]);
  Node node = one.nodes[0];
  node.mesh = static_cast<int>(scene.meshes.size()) - 1;
  node.world = glm::dmat4(size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, at.x, at.y, at.z, 1);
  scene.nodes.push_back(node);
}

TEST(Flat, OfASphereIsOneCircle) {
  const Surface sphere = buildSurface(test::sphere(64, 32), {}, {});
  const auto strokes = strokesOf(sphere, frontOf(400, 4, {0, 0, 0}), {});
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].kind, Kind::kSilhouette);
  EXPECT_TRUE(strokes[0].closed);
  for (const glm::dvec2& p : strokes[0].points) EXPECT_NEAR(glm::distance(p, glm::dvec2(200, 200)), 100, 0.6);
}

TEST(Flat, WhatASquareHidesOfAnotherIsNotDrawn) {
  Scene scene;
  addSquare(scene, {0, 0, 0}, 1);
  addSquare(scene, {0.5, 0.5, 1}, 1);
  const auto strokes = strokesOf(buildSurface(scene, {}, {}), frontOf(400, 4, {0, 0, 0}), {});
  double silhouette = 0, contour = 0;
  for (const Stroke& stroke : ofKind(strokes, Kind::kSilhouette)) silhouette += lengthOf(stroke);
  for (const Stroke& stroke : ofKind(strokes, Kind::kContour)) contour += lengthOf(stroke);
  // 100 pixels a side: two halves of sides of the front one lie before the other, and two halves of that one are
  // hidden.
  EXPECT_NEAR(contour, 100, 3);
  EXPECT_NEAR(silhouette, 600, 6);
}

TEST(Flat, PartsThatRunThroughOneAnotherHaveALineThere) {
  Scene scene;
  addSquare(scene, {0, 0, 0}, 2);
  addSquare(scene, {0, 0, 0}, 1);
  // Turned by 45 degrees about the vertical through its middle: half of it lies before the other, half behind.
  const double c = std::sqrt(0.5);
  scene.nodes.back().world = glm::dmat4(c, 0, -c, 0, 0, 1, 0, 0, c, 0, c, 0, 0, 0, 0, 1);
  const auto lines = [&](const Scene& of) {
    FlatOptions options;
    options.foldDepth = 1;
    return ofKind(strokesOf(buildSurface(of, {}, {}), frontOf(400, 4, {0, 0, 0}), options), Kind::kSeam);
  };
  // The visible half is 35 pixels wide and 100 high; its left side is where they cross, in the middle of the picture.
  const auto seams = lines(scene);
  double length = 0, crossed = 0;
  for (const Stroke& stroke : seams) {
    length += lengthOf(stroke);
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      const glm::dvec2 a = stroke.points[i - 1], b = stroke.points[i];
      if (std::abs(a.x - 200) < 0.5 && std::abs(b.x - 200) < 0.5) crossed += glm::distance(a, b);
    }
  }
  EXPECT_NEAR(crossed, 100, 3);
  EXPECT_NEAR(length, 200 + 2 * 35.4, 8);
}

TEST(Flat, AFoldBelowTheDepthIsNotDrawn) {
  Scene scene;
  addSquare(scene, {0, 0, 0}, 2);
  addSquare(scene, {0, 0, 0.5}, 1);
  const Surface surface = buildSurface(scene, {}, {});
  FlatOptions options;
  EXPECT_EQ(ofKind(strokesOf(surface, frontOf(400, 4, {0, 0, 0}), options), Kind::kContour).size(), 1u);
  options.foldDepth = 0.6;
  const auto strokes = strokesOf(surface, frontOf(400, 4, {0, 0, 0}), options);
  EXPECT_EQ(ofKind(strokes, Kind::kContour).size(), 0u);
  EXPECT_EQ(ofKind(strokes, Kind::kSeam).size(), 1u);  // a part's border still is one
  options.stitched = {0, 1};
  EXPECT_EQ(ofKind(strokesOf(surface, frontOf(400, 4, {0, 0, 0}), options), Kind::kStitch).size(), 1u);
}

TEST(Flat, ACreaseIsDrawnAboveItsAngle) {
  // A roof of two planes, 90 degrees between them, seen from above its ridge.
  const Surface roof = buildSurface(
      test::sheet(2, 4, 0, [](double u, double v) { return glm::dvec3(2 * u - 1, v, -std::abs(2 * u - 1)); }), {}, {});
  FlatOptions options;
  options.creaseAngle = 80;
  ASSERT_EQ(ofKind(strokesOf(roof, frontOf(400, 4, {0, 0, 0}), options), Kind::kCrease).size(), 1u);
  EXPECT_NEAR(lengthOf(ofKind(strokesOf(roof, frontOf(400, 4, {0, 0, 0}), options), Kind::kCrease)[0]), 100, 3);
  options.creaseAngle = 100;
  EXPECT_EQ(ofKind(strokesOf(roof, frontOf(400, 4, {0, 0, 0}), options), Kind::kCrease).size(), 0u);
}

/// Strokes of a pixel on top of each other, as of embroidery in a thumbnail.
std::vector<Stroke> stitches(int count) {
  std::vector<Stroke> strokes;
  std::uint32_t random = 1;
  const auto next = [&random] {
    random = random * 1664525u + 1013904223u;
    return 12.0 * (random >> 8) / (1 << 24);
  };
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 at(next(), next()), direction(next() - 6, next() - 6);
    strokes.push_back({Kind::kSeam, false, false, {at, at + glm::normalize(direction)}});
  }
  return strokes;
}

TEST(Strokes, AsManyAsThereAreTakeNotTheSquareOfThatTime) {
  const auto timeOf = [](int count) {
    std::vector<Stroke> strokes = stitches(count);
    const auto start = test::CpuClock::now();
    closeGaps(strokes, {});
    return test::CpuClock::now() - start;
  };
  EXPECT_LT(timeOf(16'000), 8 * timeOf(4'000)) << "its square is 16";
  std::vector<Stroke> strokes = stitches(10);
  const CancelToken cancelled;
  cancelled.cancel();
  EXPECT_ERROR(closeGaps(strokes, cancelled), "X_CANCELLED");
}

TEST(Flat, StopsWhenItIsCancelled) {
  const Surface sphere = buildSurface(test::sphere(64, 32), {}, {});
  const CancelToken cancel;
  const View view(sphere, frontOf(400, 4, {0, 0, 0}), cancel);
  cancel.cancel();
  EXPECT_ERROR(visiblePieces(sphere, view, {}, cancel), "X_CANCELLED");
}

}  // namespace
}  // namespace telar::flat::flat_test
