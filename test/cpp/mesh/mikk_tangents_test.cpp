#include "mesh/mikk_tangents.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <random>

namespace telar {
namespace {

/// Unit square in the xy plane facing +z, u along +x, v along -y as an image lies on it.
Primitive square() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  p.normals.assign(4, glm::vec3(0, 0, 1));
  p.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

void expectOrthonormal(const Primitive& p) {
  ASSERT_EQ(p.tangents.size(), p.positions.size());
  for (std::size_t i = 0; i < p.tangents.size(); ++i) {
    const glm::vec3 t(p.tangents[i]);
    ASSERT_NEAR(glm::length(t), 1, 1e-5) << i;
    ASSERT_NEAR(glm::dot(t, p.normals[i]), 0, 1e-5) << i;
    ASSERT_EQ(std::abs(p.tangents[i].w), 1) << i;
  }
}

/// n triangles between random points with random unit normals and UVs on coarse grids, so that vertices, edges and
/// whole triangles coincide or collapse.
Primitive soup(std::uint32_t seed, std::size_t triangles) {
  std::mt19937 engine(seed);
  const auto grid = [&](unsigned steps) {
    return static_cast<float>(engine() % steps) / static_cast<float>(steps - 1);
  };
  Primitive p;
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    p.positions.emplace_back(grid(4), grid(4), grid(4));
    p.normals.push_back(glm::normalize(glm::vec3(grid(3) - 0.4f, grid(3) - 0.3f, grid(3) - 0.45f)));
    p.uvs[0].emplace_back(grid(4), grid(4));
  }
  return p;
}

TEST(MikkTangents, SquareHasUAlongXAndVDown) {
  const Primitive result = withMikkTangents(square());
  EXPECT_EQ(result.indices, square().indices);
  ASSERT_EQ(result.tangents.size(), 4u);
  for (const glm::vec4& tangent : result.tangents) {
    EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
    // glTF: the bitangent shows to the top of the image, here +y.
    EXPECT_EQ(glm::cross(glm::vec3(0, 0, 1), glm::vec3(tangent)) * tangent.w, glm::vec3(0, 1, 0));
  }
}

TEST(MikkTangents, MirroredHalfGetsItsOwnVerticesAndTheOtherSign) {
  Primitive p = square();
  // A second square to the left, its UVs mirrored about the shared edge x = 0.
  p.positions.insert(p.positions.end(), {{-1, 0, 0}, {-1, 1, 0}});
  p.normals.resize(6, glm::vec3(0, 0, 1));
  p.uvs[0].insert(p.uvs[0].end(), {{1, 1}, {1, 0}});
  p.colors.assign(6, glm::vec4(0.5f));
  p.colors[3] = glm::vec4(0.25f);
  p.indices.insert(p.indices.end(), {4, 0, 3, 4, 3, 5});
  const Primitive result = withMikkTangents(p);
  ASSERT_EQ(result.positions.size(), 8u) << "vertices 0 and 3 are repeated";
  EXPECT_EQ(result.colors.size(), 8u);
  EXPECT_EQ(result.uvs[0].size(), 8u);
  EXPECT_TRUE(result.uvs[1].empty());
  for (std::size_t corner = 0; corner < p.indices.size(); ++corner) {
    const std::uint32_t vertex = result.indices[corner];
    EXPECT_EQ(result.positions[vertex], p.positions[p.indices[corner]]) << corner;
    EXPECT_EQ(result.colors[vertex], p.colors[p.indices[corner]]) << corner;
    EXPECT_EQ(result.tangents[vertex], corner < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1)) << corner;
  }
}

TEST(MikkTangents, UnindexedGivesTheSameCorners) {
  const Primitive indexed = square();
  Primitive unindexed;
  for (const std::uint32_t i : indexed.indices) {
    unindexed.positions.push_back(indexed.positions[i]);
    unindexed.normals.push_back(indexed.normals[i]);
    unindexed.uvs[1].push_back(indexed.uvs[0][i]);
  }
  const Primitive a = withMikkTangents(indexed), b = withMikkTangents(unindexed, 1);
  EXPECT_TRUE(b.indices.empty());
  ASSERT_EQ(b.tangents.size(), 6u);
  for (std::size_t corner = 0; corner < 6; ++corner) EXPECT_EQ(b.tangents[corner], a.tangents[a.indices[corner]]);
}

TEST(MikkTangents, AngleAtTheVertexIsTheWeight) {
  // Two triangles at one vertex: 90 degrees with u along +x, 45 degrees with u turned by 90 degrees.
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
  p.normals.assign(4, glm::vec3(0, 0, 1));
  p.uvs[0] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  p.indices = {0, 1, 2, 0, 2, 3};
  const Primitive result = withMikkTangents(p);
  // Triangle 0-2-3 has UV (0,0) (0,1) (1,1): it turns the other way, so it stands alone with u along -x.
  EXPECT_EQ(result.tangents[result.indices[0]], glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(result.tangents[result.indices[3]], glm::vec4(-1, 0, 0, 1));
  p.uvs[0] = {{0, 0}, {1, 0}, {0, 1}, {-1, 0.5f}};
  const Primitive joined = withMikkTangents(p);
  // d/du of the second: u = -x, v = x/2 + y => position (-1, 0.5) per u at constant v: tan = 0.5 against +x.
  const glm::vec3 second = glm::normalize(glm::vec3(1, -0.5f, 0));
  const glm::vec3 expected = glm::normalize(glm::radians(90.0f) * glm::vec3(1, 0, 0) + glm::radians(45.0f) * second);
  EXPECT_LT(glm::distance(glm::vec3(joined.tangents[joined.indices[0]]), expected), 1e-6f);
  EXPECT_EQ(joined.indices[0], joined.indices[3]);
}

TEST(MikkTangents, OpposedTangentsOfOneFanStayApart) {
  // Quarter discs 0-1-2 with u along +x and 0-4-5 with u along -x, joined by triangles whose UVs have no area.
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  p.normals.assign(6, glm::vec3(0, 0, 1));
  p.uvs[0] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}};
  p.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5};
  const Primitive result = withMikkTangents(p);
  EXPECT_EQ(result.tangents[result.indices[0]], glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(result.tangents[result.indices[9]], glm::vec4(-1, 0, 0, -1));
  expectOrthonormal(result);
}

TEST(MikkTangents, RandomSoupIsOrthonormalEverywhere) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const Primitive result = withMikkTangents(soup(seed, 300));
    ASSERT_NO_FATAL_FAILURE(expectOrthonormal(result)) << "seed " << seed;
  }
}

TEST(MikkTangents, CollapsedUvsStillGiveAFrame) {
  Primitive p = square();
  p.uvs[0].assign(4, glm::vec2(0.5f));
  for (const glm::vec3& normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(0, -1, 0)}) {
    p.normals.assign(4, normal);
    ASSERT_NO_FATAL_FAILURE(expectOrthonormal(withMikkTangents(p)));
  }
}

TEST(MikkTangents, CollapsedTriangleTakesOverFromItsNeighbour) {
  Primitive p = square();
  p.indices.insert(p.indices.end(), {1, 1, 2});
  const Primitive result = withMikkTangents(p);
  EXPECT_EQ(result.positions.size(), 4u) << "nothing needs repeating";
  EXPECT_EQ(result.indices, p.indices);
}

TEST(MikkTangents, HugeCoordinatesGiveFiniteTangents) {
  Primitive p = square();
  for (glm::vec3& position : p.positions) position = (2.0f * position - 1.0f) * 3e38f;  // a side overflows
  p.normals.assign(4, glm::vec3(0, 0, 1e30f));
  for (const glm::vec4& tangent : withMikkTangents(p).tangents) {
    EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-5);
  }
}

TEST(MikkTangents, NormalsNeedNotBeUnit) {
  Primitive p = square();
  p.normals.assign(4, glm::normalize(glm::vec3(0.3f, 0.2f, 1)));
  const Primitive unit = withMikkTangents(p);
  for (glm::vec3& normal : p.normals) normal *= 4.0f;
  const Primitive scaled = withMikkTangents(p);
  ASSERT_EQ(scaled.tangents.size(), unit.tangents.size());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(glm::distance(scaled.tangents[i], unit.tangents[i]), 1e-6f);
}

TEST(MikkTangents, SameInputGivesTheSameBytes) {
  const Primitive a = withMikkTangents(soup(7, 2000)), b = withMikkTangents(soup(7, 2000));
  ASSERT_EQ(a.tangents.size(), b.tangents.size());
  EXPECT_EQ(std::memcmp(a.tangents.data(), b.tangents.data(), a.tangents.size() * sizeof(glm::vec4)), 0);
}

TEST(MikkTangents, LeavesAloneWhatHasNoSurface) {
  Primitive lines = square();
  lines.topology = Topology::kLines;
  EXPECT_TRUE(withMikkTangents(lines).tangents.empty());
  Primitive flat = square();
  flat.normals.clear();
  EXPECT_TRUE(withMikkTangents(flat).tangents.empty());
  EXPECT_TRUE(withMikkTangents(square(), 1).tangents.empty()) << "no second UV set";
  EXPECT_TRUE(withMikkTangents(Primitive{}).tangents.empty());
}

/// All triangles share one vertex: a fan that closes, or leaves that only touch there.
Primitive star(std::uint32_t triangles, bool closed) {
  Primitive p;
  p.positions.emplace_back(0, 0, 0);
  p.uvs[0].emplace_back(0, 0);
  const std::uint32_t rim = closed ? triangles : 2 * triangles;
  for (std::uint32_t i = 0; i < rim; ++i) {
    const double angle = 6.283185307179586 * i / rim;
    p.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    p.uvs[0].emplace_back(std::cos(angle + 0.3 * (i / 2)), std::sin(angle + 0.3 * (i / 2)));
  }
  p.normals.assign(rim + 1, glm::vec3(0, 0, 1));
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const std::uint32_t a = closed ? i : 2 * i, b = closed ? (i + 1) % rim : 2 * i + 1;
    p.indices.insert(p.indices.end(), {0, a + 1, b + 1});
  }
  return p;
}

TEST(MikkTangents, AVertexOfVeryManyTrianglesTakesNoSquareOfTheTime) {
  for (const bool closed : {true, false}) {
    const auto started = std::chrono::steady_clock::now();
    const Primitive result = withMikkTangents(star(200'000, closed));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
    EXPECT_EQ(result.indices.size(), 600'000u);
    // The square would be 4e10 steps, minutes; this takes a fraction of a second.
    EXPECT_LT(seconds.count(), 10) << (closed ? "closed" : "open");
  }
}

}  // namespace
}  // namespace telar
