#include "measure/geodesic.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "expect_error.h"
#include "measure/shapes.h"

namespace telar::measure::geodesic_test {
namespace {

using surface::Surface;
using test::sheet;
constexpr double PI = std::numbers::pi;

Surface surfaceOf(const Scene& scene) { return surface::buildSurface(scene, {}, {}); }

double between(const Surface& surface, const glm::dvec3& a, const glm::dvec3& b) {
  const CancelToken cancel;
  Geodesic geodesic(surface, cancel);
  const auto path = geodesic.between(nearestPlace(surface, a, cancel), nearestPlace(surface, b, cancel));
  return path ? path->length : -1;
}

/// A strip of 0.2 x 1 m, folded into a zigzag of `folds` across its length: laid flat it is the rectangle.
glm::dvec3 folded(double u, double v, int folds, double angle) {
  const double at = v * folds, whole = std::min(std::floor(at), folds - 1.0), part = at - whole, step = 1.0 / folds;
  const bool up = static_cast<int>(whole) % 2 == 0;
  return {0.2 * u, v * std::cos(angle), step * std::sin(angle) * (up ? part : 1 - part)};
}

TEST(Geodesic, OnAFoldedStripItIsTheStraightLineOfTheStripLaidFlat) {
  // Ten rows, five folds: what disorder moves near a fold goes back onto it, so that the strip stays the strip.
  const auto strip = [](double u, double v) {
    const double fold = std::round(5 * v);
    return folded(u, std::abs(5 * v - fold) < 0.25 ? fold / 5 : v, 5, 1.1);
  };
  const glm::dvec2 from(0.013, 0.07), to(0.187, 0.93);
  for (const double disorder : {0.0, 0.49}) {
    for (const int columns : {1, 3, 12}) {
      const Surface surface = surfaceOf(sheet(columns, 10, disorder, strip));
      const double length = between(surface, folded(from.x / 0.2, from.y, 5, 1.1), folded(to.x / 0.2, to.y, 5, 1.1));
      // The corners are floats: 1e-7 m.
      EXPECT_NEAR(length, glm::distance(from, to), 3e-7) << columns << " columns, disorder " << disorder;
    }
  }
}

TEST(Geodesic, OnAConeItIsTheStraightLineOfTheUnrolledCone) {
  // Half angle 20 degrees, slant 1 m, apex above. Unrolled, an angle around the axis is smaller by sin(20 degrees).
  const double half = 20 * PI / 180, slantFrom = 0.9, slantTo = 0.6, around = 2.4;
  const auto cone = [half](double u, double v) {
    const double r = v * std::sin(half), phi = 2 * PI * u;
    return glm::dvec3(r * std::cos(phi), -v * std::cos(half), r * std::sin(phi));
  };
  const double wide = around * std::sin(half);
  const double exact = std::sqrt(slantFrom * slantFrom + slantTo * slantTo - 2 * slantFrom * slantTo * std::cos(wide));
  for (const int columns : {24, 96}) {
    for (const double disorder : {0.0, 0.4}) {
      const Surface surface = surfaceOf(sheet(columns, 12, disorder, cone));
      const double length = between(surface, cone(0, slantFrom), cone(around / (2 * PI), slantTo));
      EXPECT_NEAR(length, exact, 0.005 * exact) << columns << " columns, disorder " << disorder;
    }
  }
}

TEST(Geodesic, OnASphereItIsTheGreatCircle) {
  // A chord of the angle a is shorter than its arc by a^2 / 24, and a mesh with edges of a lies inside the sphere by
  // a^2 / 8 at most. So 24 sides around (a = 0.26) cost up to 0.9 %, which is the mesh's; 48 stay below 0.5 %.
  const glm::dvec3 from = glm::normalize(glm::dvec3(0.3, 0.9, 0.5)), to = glm::normalize(glm::dvec3(0.2, -0.4, -0.9));
  const double exact = std::acos(glm::dot(from, to));
  const double coarse = between(surfaceOf(test::sphere(24, 12)), from, to);
  EXPECT_LT(coarse, exact);
  EXPECT_GT(coarse, exact * (1 - 0.009));
  for (const int around : {48, 96}) {
    const double length = between(surfaceOf(test::sphere(around, around / 2)), from, to);
    EXPECT_NEAR(length, exact, 0.005 * exact) << around;
  }
}

TEST(Geodesic, OnABadlyTriangulatedSphereItIsTheGreatCircle) {
  // Corners moved by up to 0.4 of their quad, diagonals either way: the longest edges are some 1.5 times those of the
  // even sphere.
  const auto bent = [](double u, double v) {
    const double phi = 2 * PI * u, theta = PI * (0.1 + 0.8 * v);
    return glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
  };
  const Surface sphere = surfaceOf(sheet(64, 32, 0.4, bent));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> around(0.05, 0.4), height(0.2, 0.8);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 from = bent(around(random), height(random)), to = bent(around(random) + 0.05, height(random));
    const double exact = std::acos(glm::dot(from, to));
    if (exact < 0.3) continue;
    EXPECT_NEAR(between(sphere, from, to), exact, 0.005 * exact) << i;
  }
}

TEST(Geodesic, AroundTheCornerOfABoxItIsTheBestOfTheUnfoldings) {
  // The unit cube's opposite corners: sqrt(5) over two faces.
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  const Surface cube = surfaceOf(test::sceneOf(corners, {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                                         2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5}));
  EXPECT_NEAR(between(cube, {0, 0, 0}, {1, 1, 1}), std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(between(cube, {0.5, 0.5, 0}, {0.5, 0.5, 1}), 2, 1e-12);
}

TEST(Geodesic, GoesAroundAHole) {
  // A square of 3 x 3 without its middle: from one side to the other it bends at two corners of the hole.
  std::vector<glm::vec3> positions;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) positions.emplace_back(i, j, 0);
  std::vector<std::uint32_t> indices;
  for (std::uint32_t j = 0; j < 3; ++j) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = j * 4 + i;
      if (i == 1 && j == 1) continue;
      for (const std::uint32_t index : {a, a + 1, a + 5, a, a + 5, a + 4}) indices.push_back(index);
    }
  }
  const Surface surface = surfaceOf(test::sceneOf(positions, indices));
  EXPECT_NEAR(between(surface, {0.5, 1.5, 0}, {2.5, 1.5, 0}), 1 + 2 * std::sqrt(0.5), 1e-12);
  // Past one corner of it, and on over faces that the corner does not touch.
  EXPECT_NEAR(between(surface, {0.1, 1.5, 0}, {2.9, 2.9, 0}), std::hypot(0.9, 0.5) + std::hypot(1.9, 0.9), 1e-12);
}

TEST(Geodesic, FollowsAnyFaceOfAnEdgeThatHasThree) {
  const Surface fin =
      surfaceOf(test::sceneOf({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 1, 2, 0, 1, 3, 0, 1, 4}));
  EXPECT_NEAR(between(fin, {-0.5, 0.25, 0}, {0, 0.25, 0.5}), 1, 1e-12);
  EXPECT_NEAR(between(fin, {-0.5, 0.25, 0}, {0.5, 0.25, 0}), 1, 1e-12);
}

TEST(Geodesic, PassesAPointThatPartsTouchAt) {
  const Surface bow =
      surfaceOf(test::sceneOf({{0, 0, 0}, {-1, -1, 0}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}}, {0, 1, 2, 0, 3, 4}));
  EXPECT_NEAR(between(bow, {-1, 0.5, 0}, {1, 0.5, 0}), 2 * std::hypot(1, 0.5), 1e-12);
}

TEST(Geodesic, FansThatTouchAtACornerAreLeftByIt) {
  // Two closed pyramids that share their apex alone. All edges have two faces, and neither apex has an angle of 2 pi.
  std::vector<glm::vec3> positions{{0, 0, 0}};
  std::vector<std::uint32_t> indices;
  for (const float y : {-1.0f, 1.0f}) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    for (const glm::vec3& p : {glm::vec3(0.3f, y, 0.3f), {-0.3f, y, 0.3f}, {-0.3f, y, -0.3f}, {0.3f, y, -0.3f}})
      positions.push_back(p);
    for (std::uint32_t k = 0; k < 4; ++k)
      for (const std::uint32_t index : {0u, base + k, base + (k + 1) % 4}) indices.push_back(index);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(base + k);
  }
  const Surface pyramids = surfaceOf(test::sceneOf(positions, indices));
  // Down a side of the one, up a side of the other, and from the middle of its base's edge to the base's middle.
  const glm::dvec3 from(0, -0.5, 0.15);
  EXPECT_NEAR(between(pyramids, from, {0, 1, 0}), glm::length(from) + std::hypot(1, 0.3) + 0.3, 1e-6);
}

TEST(Geodesic, SaysWhereNothingJoinsTwoPoints) {
  const Surface two =
      surfaceOf(test::sceneOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(between(two, {0, 0, 0}, {5, 0, 0}), -1);
}

/// Crumpled cloth: any two triangles differ.
glm::dvec3 crumpled(double u, double v) {
  return {u, v, 0.06 * std::sin(11 * u + 3 * v) + 0.04 * std::sin(5 * u - 17 * v) + 0.03 * std::sin(29 * u * v)};
}

TEST(Geodesic, IsTheSameBothWaysAndNeverLongerThanAWayOverAThirdPoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const Surface cloth = surfaceOf(sheet(30, 30, 0.49, crumpled));
  for (int i = 0; i < 25; ++i) {
    const glm::dvec3 a = crumpled(unit(random), unit(random)), b = crumpled(unit(random), unit(random)),
                     c = crumpled(unit(random), unit(random));
    const double ab = between(cloth, a, b);
    EXPECT_NEAR(between(cloth, b, a), ab, 1e-9);
    EXPECT_LE(ab, between(cloth, a, c) + between(cloth, c, b) + 1e-9);
    EXPECT_GE(ab, glm::distance(nearestPlace(cloth, a, {}).position, nearestPlace(cloth, b, {}).position) - 1e-12);
  }
}

TEST(Geodesic, FlatAndNeedleTrianglesChangeNothing) {
  // A unit square, whose quads are cut by rows 1e-6 high and by corners in the middle of sides (T-junctions closed by
  // triangles without an area).
  std::vector<glm::vec3> positions{{0, 0, 0},         {1, 0, 0},         {1, 0.5f, 0}, {0, 0.5f, 0}, {0.5f, 0.5f, 0},
                                   {1, 0.500004f, 0}, {0, 0.500004f, 0}, {0, 1, 0},    {1, 1, 0}};
  const Surface surface =
      surfaceOf(test::sceneOf(positions, {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 6, 4, 2, 5, 4, 5, 6, 6, 5, 8, 6, 8, 7}));
  const glm::dvec3 from(0.1, 0.05, 0), to(0.83, 0.97, 0);
  EXPECT_NEAR(between(surface, from, to), glm::distance(from, to), 1e-6);
}

TEST(Geodesic, CornersThatFilesSplitAreJoined) {
  // Two quads with corners of their own, as at a seam of UVs, in a node that is scaled and turned.
  const glm::dmat4 world =
      glm::rotate(glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(7, -3, 2)), glm::dvec3(0.01, 0.02, -0.03)), 0.7,
                  glm::dvec3(1, 2, 3));
  const Surface surface =
      surfaceOf(test::sceneOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
                              {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}, world));
  EXPECT_EQ(surface.points.size(), 6u);
  const auto place = [&](double x, double y) { return glm::dvec3(world * glm::dvec4(x, y, 0, 1)); };
  EXPECT_NEAR(between(surface, place(0.1, 0.3), place(1.8, 0.6)), glm::distance(place(0.1, 0.3), place(1.8, 0.6)),
              1e-12);
}

TEST(Geodesic, StopsWhenItIsCancelled) {
  const Surface cloth = surfaceOf(sheet(40, 40, 0.4, crumpled));
  const CancelToken cancel;
  Geodesic geodesic(cloth, cancel);
  const auto a = nearestPlace(cloth, {0, 0, 0}, cancel), b = nearestPlace(cloth, {1, 1, 0}, cancel);
  cancel.cancel();
  EXPECT_ERROR(geodesic.between(a, b), "X_CANCELLED");
}

}  // namespace
}  // namespace telar::measure::geodesic_test
