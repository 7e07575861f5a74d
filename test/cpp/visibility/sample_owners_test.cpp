#include "visibility/sample_owners.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "visibility/meshes.h"

// The owner of each sample, beside a search through all triangles in whole numbers.

namespace telar::visibility::sample_owners_test {
namespace {

using test::gridOf;
using test::placed;
using test::Placed;
using test::rectangle;
using test::Triangles;

constexpr int SIZE = 40;

/// Corners in 1/256 px, and depths of 0..1.
struct Corner {
  std::int64_t x, y;
  double z;
};

Corner cornerOf(const glm::vec3& p, int size) {
  const auto step = [&](float v) { return std::lrint((v * 0.5f + 0.5f) * static_cast<float>(size) * 256); };
  return {step(p.x), step(p.y), p.z * 0.5 + 0.5};
}

/// Depth of a triangle at a sample, where it covers it; else infinity.
/// @param edgeIsIn  whether it has what lies on the edge from u to v
double depthAt(const Corner& a, Corner b, Corner c, Faces faces, std::int64_t x, std::int64_t y) {
  const auto cross = [](const Corner& u, const Corner& v, std::int64_t px, std::int64_t py) {
    return (v.x - u.x) * (py - u.y) - (v.y - u.y) * (px - u.x);
  };
  const double infinite = std::numeric_limits<double>::infinity();
  std::int64_t area = cross(a, b, c.x, c.y);
  if (area == 0 || (faces != Faces::kBoth && (area > 0) != (faces == Faces::kCounterClockwise))) return infinite;
  if (area < 0) {
    std::swap(b, c);
    area = -area;
  }
  const auto inside = [&](const Corner& u, const Corner& v) {
    const std::int64_t e = cross(u, v, x, y);
    const bool keeps = v.y < u.y || (v.y == u.y && v.x > u.x);
    return e > 0 || (e == 0 && keeps);
  };
  if (!inside(a, b) || !inside(b, c) || !inside(c, a)) return infinite;
  const double wa = static_cast<double>(cross(b, c, x, y)), wb = static_cast<double>(cross(c, a, x, y));
  const double whole = static_cast<double>(area);
  return (wa * a.z + wb * b.z + (whole - wa - wb) * c.z) / whole;
}

glm::vec3 positionOf(const PlacedMesh& mesh, std::uint32_t vertex) {
  const float* at = mesh.outputs.of(vertex);
  return {at[0], at[1], at[2]};
}

/// What is wrong with the owners, counted.
int faultsOf(const SampleOwners& owners, const std::vector<PlacedMesh>& meshes, const SampleGrid& grid) {
  int faults = 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const int cellX = x / grid.cell * grid.cell, cellY = y / grid.cell * grid.cell;
      for (std::size_t i = 0; i < SAMPLES; ++i) {
        const auto sx = static_cast<std::int64_t>((static_cast<float>(cellX) + grid.places[i].x + grid.offset) * 256);
        const auto sy = static_cast<std::int64_t>((static_cast<float>(cellY) + grid.places[i].y + grid.offset) * 256);
        double nearest = std::numeric_limits<double>::infinity(), owned = nearest;
        const Pixels& covered = owners.covered();
        const bool in = x >= covered.fromX && x <= covered.toX && y >= covered.fromY && y <= covered.toY;
        const Owner owner = in ? owners.of(x, y)[i] : NO_OWNER;
        std::uint32_t number = 0;
        for (const PlacedMesh& mesh : meshes) {
          for (std::size_t t = 0; t < trianglesOf(mesh); ++t, ++number) {
            const Corners at = cornersOf(mesh, t);
            const double depth =
                depthAt(cornerOf(positionOf(mesh, at[0]), grid.width), cornerOf(positionOf(mesh, at[1]), grid.width),
                        cornerOf(positionOf(mesh, at[2]), grid.width), mesh.faces, sx, sy);
            nearest = std::min(nearest, depth);
            if (owner != NO_OWNER && number == numberOf(owner)) owned = depth;
          }
        }
        if (owner == NO_OWNER ? std::isfinite(nearest) : !(owned <= nearest + 4e-7)) ++faults;
      }
    }
  }
  return faults;
}

Triangles scattered(std::mt19937& engine, int count, float reach, float size) {
  const auto between = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(engine()) * 0x1p-32f;
  };
  Triangles out;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 middle(between(-reach, reach), between(-reach, reach), between(-0.8f, 0.8f));
    for (int corner = 0; corner < 3; ++corner) {
      out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
      out.positions.push_back(middle + glm::vec3(between(-size, size), between(-size, size), between(-0.1f, 0.1f)));
    }
  }
  return out;
}

TEST(SampleOwners, AreTheNearestTrianglesThatCoverASample) {
  std::mt19937 engine(1);
  for (const auto& [reach, size] : {std::pair(0.9f, 0.09f), {0.6f, 0.35f}, {0.2f, 0.75f}}) {
    for (int turn = 0; turn < 8; ++turn) {
      const Triangles first = scattered(engine, 30, reach, size), second = scattered(engine, 10, reach, size);
      const Placed a = placed(first), b = placed(second, turn % 2 == 0 ? Faces::kClockwise : Faces::kCounterClockwise);
      const std::vector<PlacedMesh> meshes{a.mesh, b.mesh};
      SampleOwners owners;
      for (const SampleGrid& grid : {gridOf(SIZE), SampleGrid::ofOneSample(SIZE, SIZE)}) {
        ASSERT_TRUE(owners.look(grid, meshes, {}, {}));
        EXPECT_EQ(faultsOf(owners, meshes, grid), 0) << "reach " << reach << ", turn " << turn;
      }
    }
  }
}

TEST(SampleOwners, AreNotToldOfTrianglesThatTheWindowCuts) {
  for (const auto& [x, isTold] : {std::pair(0.5f, true), {1.0f, false}, {2.0f, true}}) {
    const Triangles one{{{x - 0.3f, 0, 0}, {x + 0.3f, 0, 0}, {x, 0.3f, 0}}, {0, 1, 2}};
    const Placed at = placed(one);
    SampleOwners owners;
    EXPECT_EQ(owners.look(gridOf(SIZE), std::vector{at.mesh}, {}, {}), isTold) << x;
  }
}

TEST(SampleOwners, OfAShiftedViewAreSeenToBeWrong) {
  std::mt19937 engine(2);
  Triangles mesh = scattered(engine, 30, 0.65f, 0.3f);
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(mesh).mesh}, {}, {}));
  for (glm::vec3& p : mesh.positions) p.x += 0.2f / SIZE;  // a tenth of a pixel
  const Placed shifted = placed(mesh);
  EXPECT_GT(faultsOf(owners, {shifted.mesh}, gridOf(SIZE)), 20);
}

TEST(SampleOwners, OfLargeAndSmallTrianglesFollowTheSameRule) {
  // Through the middle of samples: an edge at 20.375 px, and both parts of a rectangle that it cuts.
  const float edge = 2 * 20.375f / 128 - 1;
  for (const float low : {-1.0f, 2 * 15.0f / 128 - 1}) {
    const Triangles left = rectangle({low, low}, {edge, 0.9f}, 0), right = rectangle({edge, low}, {0.9f, 0.9f}, 0);
    const Placed a = placed(left), b = placed(right);
    const std::vector<PlacedMesh> meshes{a.mesh, b.mesh};
    SampleOwners owners;
    ASSERT_TRUE(owners.look(gridOf(128), meshes, {}, {}));
    EXPECT_EQ(owners.triangle(owners.of(20, 50)[0]).mesh, 1u);
    EXPECT_EQ(faultsOf(owners, meshes, gridOf(128)), 0);
  }
}

TEST(SampleOwners, LaterTrianglesWinAtTheSameDepth) {
  const Triangles square = rectangle({-0.9f, -0.9f}, {0.9f, 0.9f}, 0.25f);
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh, placed(square).mesh}, {}, {}));
  EXPECT_EQ(owners.triangle(owners.of(20, 20)[0]).mesh, 1u);
}

TEST(SampleOwners, TellTheWindingAndTheTriangle) {
  Triangles square = rectangle({-0.9f, -0.9f}, {0.9f, 0.9f}, 0);
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh}, {}, {}));
  EXPECT_NE(owners.of(20, 5)[0] & COUNTER_CLOCKWISE, 0u);
  EXPECT_EQ(owners.triangle(owners.of(30, 5)[0]).number, 0u);
  EXPECT_EQ(owners.triangle(owners.of(5, 30)[0]).number, 1u);
  std::swap(square.indices[1], square.indices[2]);
  std::swap(square.indices[4], square.indices[5]);
  ASSERT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh}, {}, {}));
  EXPECT_EQ(owners.of(20, 5)[0] & COUNTER_CLOCKWISE, 0u);
}

TEST(SampleOwners, AreNotFoundWhereATriangleReachesBehindTheCamera) {
  Triangles square = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0.25f);
  SampleOwners owners;
  EXPECT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh}, {}, {}));
  square.positions[0].z = -1.5f;
  EXPECT_FALSE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh}, {}, {}));
}

TEST(SampleOwners, AreInFrontOfAPlaneOrNot) {
  const Triangles square = rectangle({-0.5f, -0.5f}, {0.5f, 0.5f}, 0.2f);  // depth 0.6
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), std::vector{placed(square).mesh}, {}, {}));
  EXPECT_TRUE(owners.inFrontOf({0, 0, 0.61f}));
  EXPECT_TRUE(owners.inFrontOf({0, 0, 0.6f}));
  EXPECT_FALSE(owners.inFrontOf({0, 0, 0.59f}));
  // From 0.7 on the left to 0.58 on the right: only the last columns of the square lie behind.
  EXPECT_FALSE(owners.inFrontOf({-0.12f / (0.75f * SIZE), 0, 0.7f}));
  EXPECT_TRUE(owners.inFrontOf({-0.12f / (1.5f * SIZE), 0, 0.7f}));
}

TEST(SampleOwners, OfNothingAreNone) {
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), {}, {}, {}));
  EXPECT_GT(owners.covered().fromX, owners.covered().toX);
  EXPECT_EQ(owners.triangles(), 0u);
}

}  // namespace
}  // namespace telar::visibility::sample_owners_test
