#include <gtest/gtest.h>

#include <cmath>

#include "visibility/hidden_triangles.h"
#include "visibility/meshes.h"

// What a look costs stays in proportion to triangles and to the pixels that they cover, whatever their shape. Counted
// in steps, which no machine's load changes.

namespace telar::visibility::look_steps_test {
namespace {

using test::gridOf;
using test::Triangles;

struct Steps {
  std::int64_t look, find;
  std::size_t left;
};

Steps stepsOf(const Triangles& mesh, int size) {
  const std::vector<DrawnMesh> meshes{{mesh.positions, mesh.indices}};
  HiddenTriangles hidden;
  const std::int64_t look = hidden.look(gridOf(size), meshes, {});
  const VisibleTriangles visible = hidden.visible(0, {});
  return {look, visible.steps, visible.parts.size()};
}

/// A disc of triangles around its centre, or around a centre for each triangle.
Triangles disc(std::uint32_t count, bool shared) {
  Triangles mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double turn = 2 * 3.14159265358979 * i / count;
    mesh.positions.emplace_back(0.9 * std::cos(turn), 0.9 * std::sin(turn), 0);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == 0 || !shared) mesh.positions.emplace_back(0, 0, 0);
    const auto center = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.indices.insert(mesh.indices.end(), {i, (i + 1) % count, center});
  }
  return mesh;
}

TEST(LookSteps, ADiscCostsNoMoreThanItsTriangles) {
  constexpr std::uint32_t COUNT = 4000;
  const std::int64_t shared = stepsOf(disc(COUNT, true), 2048).look, apart = stepsOf(disc(COUNT, false), 2048).look;
  // A few samples near each edge ask for its other triangle: of two at the rim.
  EXPECT_GT(shared, apart) << "nobody asked";
  EXPECT_LT(shared, 2 * apart);
}

TEST(LookSteps, ANeedleCostsItsLength) {
  constexpr int SIZE = 1024, COUNT = 40;
  Triangles mesh;
  for (int i = 0; i < COUNT; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const float off = 0.004f * static_cast<float>(i - COUNT / 2);
    const float turned = i % 2 == 0 ? 1.0f : -1.0f;
    mesh.positions.insert(
        mesh.positions.end(),
        {{-0.9f * turned + off, -0.9f, 0}, {0.9f * turned + off, 0.89f, 0}, {0.9f * turned + off, 0.9f, 0}});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  const Steps steps = stepsOf(mesh, SIZE);
  EXPECT_EQ(steps.left, static_cast<std::size_t>(COUNT));
  // Rows of some ten pixels each, in place of as many as the box is wide.
  EXPECT_GT(steps.look, std::int64_t{COUNT} * SIZE);
  EXPECT_LT(steps.look, std::int64_t{COUNT} * SIZE * 16);
  EXPECT_LT(steps.find, std::int64_t{COUNT} * SIZE * 16);
}

TEST(LookSteps, ALargeTriangleCostsItsPixels) {
  constexpr int SIZE = 512;
  const Triangles mesh{{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}, {0, 1, 2}};
  const std::int64_t look = stepsOf(mesh, SIZE).look;
  EXPECT_GE(look, SIZE * SIZE / 2);
  EXPECT_LT(look, SIZE * SIZE * 5 / 9);
}

}  // namespace
}  // namespace telar::visibility::look_steps_test
