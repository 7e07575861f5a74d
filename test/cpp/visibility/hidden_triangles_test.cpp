#include "visibility/hidden_triangles.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "expect_error.h"
#include "visibility/meshes.h"

// Which triangles of plain scenes are left.

namespace telar::visibility::hidden_triangles_test {
namespace {

using test::gridOf;
using test::rectangle;

constexpr int SIZE = 32;

std::vector<std::uint32_t> left(std::span<const DrawnMesh> meshes, std::size_t of) {
  HiddenTriangles hidden;
  hidden.look(gridOf(SIZE), meshes, {});
  return hidden.visible(of, {}).parts;
}

const std::vector<std::uint32_t> NONE, BOTH{0, 1};

TEST(HiddenTriangles, WhatStandsBehindIsLeftOut) {
  const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  const std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
  EXPECT_EQ(left(meshes, 0), BOTH);
  EXPECT_EQ(left(meshes, 1), NONE);
}

TEST(HiddenTriangles, WhatLooksOutOrStandsInFrontStays) {
  const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0);
  for (const auto& other :
       {rectangle({-0.4f, -0.4f}, {0.4f, 0.6f}, 0.1f), rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, -0.1f)}) {
    const std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {other.positions, other.indices}};
    EXPECT_FALSE(left(meshes, 1).empty());
  }
}

TEST(HiddenTriangles, OneOfTwoInOnePlaceStays) {
  const auto a = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), b = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0);
  const std::vector<DrawnMesh> meshes{{a.positions, a.indices}, {b.positions, b.indices}};
  EXPECT_EQ(left(meshes, 0), BOTH);
  EXPECT_EQ(left(meshes, 1), BOTH) << "the depth test lets through what is as near";
}

TEST(HiddenTriangles, OnlyWhatIsOpaqueHides) {
  const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
  meshes[0].hides = false;
  EXPECT_EQ(left(meshes, 1), BOTH);
}

TEST(HiddenTriangles, FacesThatAreNotDrawnHideNothing) {
  const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
  meshes[0].faces = Faces::kCounterClockwise;
  EXPECT_EQ(left(meshes, 0), BOTH);
  EXPECT_EQ(left(meshes, 1), NONE);
  meshes[0].faces = Faces::kClockwise;
  EXPECT_EQ(left(meshes, 0), NONE);
  EXPECT_EQ(left(meshes, 1), BOTH);
}

TEST(HiddenTriangles, ASeamBetweenTwoTrianglesIsNoHole) {
  // The diagonal of the front, a quarter of a pixel below those of pixels, passes through a sample of each.
  constexpr float DOWN = 0.5f / SIZE;
  const auto front = rectangle({-0.5f, -0.5f - DOWN}, {0.5f, 0.5f - DOWN}, 0),
             back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  const std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
  // Without indices nothing tells that the triangles share corners that the GL puts in one place.
  std::vector<glm::vec3> corners;
  for (const std::uint32_t i : front.indices) corners.push_back(front.positions[i]);
  const std::vector<DrawnMesh> apart{{corners, {}}, {back.positions, back.indices}};
  EXPECT_EQ(left(meshes, 1), NONE);
  EXPECT_FALSE(left(apart, 1).empty());
}

TEST(HiddenTriangles, WhatIsBesideTheWindowIsLeftOut) {
  const auto beside = rectangle({1.2f, -0.4f}, {1.6f, 0.4f}, 0), across = rectangle({0.8f, -0.4f}, {1.6f, 0.4f}, 0);
  const std::vector<DrawnMesh> meshes{{beside.positions, beside.indices}, {across.positions, across.indices}};
  EXPECT_EQ(left(meshes, 0), NONE);
  EXPECT_EQ(left(meshes, 1), BOTH);
}

TEST(HiddenTriangles, WhatHasNoPlaceInTheWindowStays) {
  const auto front = rectangle({-0.9f, -0.9f}, {0.9f, 0.9f}, -0.9f);
  auto through = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.5f);
  through.positions[2].z = 1.5f;  // behind the far plane
  const std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {through.positions, through.indices}};
  EXPECT_EQ(left(meshes, 1), BOTH);
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::vector<DrawnMesh> numberless{{front.positions, front.indices}};
  numberless[0].modelView[0][0] = none;
  EXPECT_EQ(left(numberless, 0), BOTH);
}

TEST(HiddenTriangles, FarFromTheOriginEverythingStays) {
  // Floats of this size are some pixels apart.
  constexpr float AWAY = 1 << 23;
  auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  for (auto* mesh : {&front, &back}) {
    for (glm::vec3& p : mesh->positions) p.x += AWAY;
  }
  std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
  for (DrawnMesh& mesh : meshes) mesh.modelView = glm::translate(glm::mat4(1), glm::vec3(-AWAY, 0, 0));
  EXPECT_EQ(left(meshes, 1), BOTH);
}

TEST(HiddenTriangles, FarFromTheOriginNothingIsKnownToBeBesideTheWindow) {
  constexpr float AWAY = 1 << 23;
  auto beside = rectangle({3, -0.4f}, {4, 0.4f}, 0);
  std::vector<DrawnMesh> meshes{{beside.positions, beside.indices}};
  EXPECT_EQ(left(meshes, 0), NONE);
  for (glm::vec3& p : beside.positions) p.x += AWAY;
  meshes[0].modelView = glm::translate(glm::mat4(1), glm::vec3(-AWAY, 0, 0));
  EXPECT_EQ(left(meshes, 0), BOTH);
}

TEST(HiddenTriangles, OneCornerBesideTheCameraTakesNothingFromTheOthers) {
  auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, -1);
  const auto back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, -8);
  // Its place is off by pixels, those of the others are not.
  for (const glm::vec3& p :
       {glm::vec3(-3e-5f, 0, -1.1e-5f), glm::vec3(-3e-5f, 1e-5f, -1.1e-5f), glm::vec3(-4e-5f, 0, -1.2e-5f)}) {
    front.indices.push_back(static_cast<std::uint32_t>(front.positions.size()));
    front.positions.push_back(p);
  }
  const glm::mat4 projection = glm::perspective(1.2f, 1.0f, 1e-5f, 10.0f);
  const std::vector<DrawnMesh> meshes{{front.positions, front.indices, glm::mat4(1), projection},
                                      {back.positions, back.indices, glm::mat4(1), projection}};
  EXPECT_EQ(left(meshes, 0), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(left(meshes, 1), NONE);
}

TEST(HiddenTriangles, WhatTheNearPlaneMayCutHidesNothing) {
  constexpr float LITTLE = 0x1p-16f;  // some roundings
  const auto back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.5f);
  for (const bool cut : {true, false}) {
    const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, cut ? -1 : LITTLE - 1);
    const std::vector<DrawnMesh> meshes{{front.positions, front.indices}, {back.positions, back.indices}};
    EXPECT_EQ(left(meshes, 0), BOTH);
    EXPECT_EQ(left(meshes, 1), cut ? BOTH : NONE);
  }
}

TEST(HiddenTriangles, TellsIndicesAndPixelsOfWhatIsLeft) {
  const auto one = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0);
  const std::vector<DrawnMesh> meshes{{one.positions, one.indices}};
  HiddenTriangles hidden;
  hidden.look(gridOf(SIZE), meshes, {});
  const VisibleTriangles visible = hidden.visible(0, {});
  EXPECT_EQ(visible.indices, one.indices);
  EXPECT_GE(visible.pixels, 2 * 16 * 16);
  EXPECT_LE(visible.pixels, 2 * 18 * 18);
}

TEST(HiddenTriangles, OneViewAfterAnotherKnowsNothingOfIt) {
  const auto front = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0), back = rectangle({-0.4f, -0.4f}, {0.4f, 0.4f}, 0.1f);
  const std::vector<DrawnMesh> both{{front.positions, front.indices}, {back.positions, back.indices}};
  const std::vector<DrawnMesh> alone{{back.positions, back.indices}};
  HiddenTriangles hidden;
  hidden.look(gridOf(SIZE), both, {});
  EXPECT_EQ(hidden.visible(1, {}).parts, NONE);
  hidden.look(gridOf(SIZE), alone, {});
  EXPECT_EQ(hidden.visible(0, {}).parts, BOTH);
  hidden.look(gridOf(2 * SIZE), both, {});
  EXPECT_EQ(hidden.visible(1, {}).parts, NONE);
  hidden.look(gridOf(SIZE), {}, {});
}

TEST(HiddenTriangles, KeepsLittleMemory) {
  const auto small = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0);
  const std::vector<DrawnMesh> few{{small.positions, small.indices}};
  HiddenTriangles hidden;
  EXPECT_EQ(hidden.memory(), 0u);
  hidden.look(gridOf(SIZE), few, {});
  const std::size_t kept = hidden.memory();
  EXPECT_GT(kept, SIZE * SIZE / 4 * SAMPLES * sizeof(float)) << "the rectangle's part of the window";
  hidden.release();
  EXPECT_EQ(hidden.memory(), kept);
  // Each of these alone is more: vertices and fans of many triangles, and depths of many pixels.
  const std::vector<glm::vec3> positions(HiddenTriangles::KEPT / sizeof(WindowVertex));
  const std::vector<std::uint32_t> indices(HiddenTriangles::KEPT / sizeof(std::uint32_t) / 3 * 3);
  const std::vector<DrawnMesh> vertices{{positions, small.indices}}, fans{{small.positions, indices}};
  for (const auto& [meshes, size] : {std::pair(&vertices, SIZE), {&fans, SIZE}, {&few, 3000}}) {
    hidden.look(gridOf(size), *meshes, {});
    EXPECT_GT(hidden.memory(), HiddenTriangles::KEPT);
    hidden.release();
    EXPECT_EQ(hidden.memory(), 0u);
  }
}

TEST(HiddenTriangles, ALookCanBeStopped) {
  const auto one = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0);
  const std::vector<DrawnMesh> meshes{{one.positions, one.indices}};
  const CancelToken cancel;
  cancel.cancel();
  HiddenTriangles hidden;
  EXPECT_ERROR(hidden.look(gridOf(SIZE), meshes, cancel), "X_CANCELLED");
}

TEST(TriangleFans, FindsTheTriangleOnTheOtherSideOfAnEdge) {
  const std::vector<std::uint32_t> indices{0, 1, 2, 2, 1, 3, 5, 5, 5};
  TriangleFans fans;
  std::int64_t steps = 0;
  fans.read(indices, 7);
  EXPECT_EQ(fans.withEdge(1, 2, steps), 0u);
  EXPECT_EQ(fans.withEdge(2, 1, steps), 1u);
  EXPECT_EQ(fans.withEdge(3, 2, steps), 1u);
  EXPECT_EQ(fans.withEdge(2, 3, steps), std::nullopt);
  EXPECT_EQ(fans.withEdge(6, 0, steps), std::nullopt);
  EXPECT_EQ(fans.withEdge(5, 5, steps), 2u);
  fans.read({}, 7);
  EXPECT_EQ(fans.withEdge(1, 2, steps), std::nullopt);
}

TEST(TriangleFans, AskTheEndOfAnEdgeThatHasFewer) {
  constexpr std::uint32_t COUNT = 10 * TriangleFans::LARGEST;
  std::vector<std::uint32_t> disc, sheets;
  for (std::uint32_t i = 0; i < COUNT; ++i) {
    disc.insert(disc.end(), {i, (i + 1) % COUNT, COUNT});
    sheets.insert(sheets.end(), {COUNT, COUNT + 1, i});
  }
  TriangleFans fans;
  fans.read(disc, COUNT + 1);
  for (std::uint32_t i = 0; i < COUNT; ++i) {
    std::int64_t steps = 0;
    EXPECT_EQ(fans.withEdge(COUNT, i, steps), i);
    EXPECT_EQ(fans.withEdge((i + 1) % COUNT, COUNT, steps), i);
    EXPECT_LE(steps, 4);
  }
  fans.read(sheets, COUNT + 2);
  std::int64_t steps = 0;
  EXPECT_EQ(fans.withEdge(COUNT + 1, COUNT, steps), std::nullopt);
  EXPECT_EQ(steps, 0);
}

}  // namespace
}  // namespace telar::visibility::hidden_triangles_test
