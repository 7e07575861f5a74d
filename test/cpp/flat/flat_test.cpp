#include "flat/flat.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "expect_error.h"
#include "flat/truth.h"
#include "measure/shapes.h"
#include "telar/load.h"

namespace telar::flat {
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

TEST(Flat, StopsWhenItIsCancelled) {
  const Surface sphere = buildSurface(test::sphere(64, 32), {}, {});
  const CancelToken cancel;
  const View view(sphere, frontOf(400, 4, {0, 0, 0}), cancel);
  cancel.cancel();
  EXPECT_ERROR(visiblePieces(sphere, view, {}, cancel), "X_CANCELLED");
}

/// The bundled T-shirt against the edges of a z-buffer of the same view.
class Shirt : public testing::TestWithParam<double> {
 protected:
  static constexpr int SIZE = 1200;
  static constexpr double HEIGHT = 0.9, FOLD = 0.008;

  void SetUp() override {
    const auto scene = loadPath(std::filesystem::path(TELAR_SOURCE_DIR) / "js/assets/tshirt.glb", {}, {});
    surface_ = buildSurface(*scene, {}, {});
    shot_ = frontOf(SIZE, HEIGHT, {0, 0.36, 0}, GetParam());
    options_.foldDepth = FOLD;
    options_.foldLength = 0.02 * SIZE;
  }

  /// Written anew, so that a fault of View or of its camera shows.
  glm::dvec3 project(const glm::dvec3& p) const {
    const double pixels = SIZE / HEIGHT;
    return {SIZE / 2.0 + GetParam() * p.x * pixels, SIZE / 2.0 - (p.y - 0.36) * pixels, 10 - GetParam() * p.z};
  }

  Surface surface_;
  Shot shot_;
  FlatOptions options_;
};

TEST_P(Shirt, LinesAreTheEdgesOfPartsAndDepths) {
  const auto strokes = strokesOf(surface_, shot_, options_);
  const test::Picture picture(surface_, SIZE, SIZE, [this](const glm::dvec3& p) { return project(p); });
  const auto isOutline = [&](std::size_t i, std::size_t k) { return (picture.part[i] < 0) != (picture.part[k] < 0); };
  const auto isSeam = [&](std::size_t i, std::size_t k) { return picture.part[i] != picture.part[k]; };
  const auto isEdge = [&](std::size_t i, std::size_t k) {
    // Lines are found by the depths 1.2 pixels apart, and these pixels are one apart.
    return isSeam(i, k) || std::abs(picture.depth[i] - picture.depth[k]) > 0.8 * FOLD ||
           glm::dot(picture.normal[i], picture.normal[k]) < std::cos(glm::radians(options_.creaseAngle));
  };
  const test::Mask lines = test::drawn(strokes, SIZE, SIZE, [](Kind) { return true; });
  const test::Mask silhouettes = test::drawn(strokes, SIZE, SIZE, [](Kind kind) { return kind == Kind::kSilhouette; });
  const test::Mask outline = picture.edges(isOutline), seams = picture.edges(isSeam), edges = picture.edges(isEdge);
  EXPECT_GE(lines.near(edges, 1.5), 0.99);
  EXPECT_GE(outline.near(silhouettes, 1.5), 0.97);
  EXPECT_GE(seams.near(lines, 1.5), 0.97);
  EXPECT_LE(test::widestGap(outline, silhouettes, 1.5), 3);
  RecordProperty("lines", std::to_string(lines.near(edges, 1.5)));
  RecordProperty("strokes", static_cast<int>(strokes.size()));
  // Planted: a picture moved by three pixels has its lines beside these.
  test::Mask moved(SIZE, SIZE);
  for (int y = 0; y < SIZE; ++y) {
    for (int x = 3; x < SIZE; ++x) moved.at(x, y) = lines.at(x - 3, y);
  }
  EXPECT_LT(moved.near(edges, 1.5), 0.9);
}

INSTANTIATE_TEST_SUITE_P(Sides, Shirt, testing::Values(1.0, -1.0));

}  // namespace
}  // namespace telar::flat
