#include "telar/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace telar::simplify_test {
namespace {

constexpr int SIDE = 40;

/// A square in x and y of SIDE x SIDE cells, 1 m wide, z by a formula.
template <class Height>
Primitive sheet(const Height& height) {
  Primitive p;
  for (int y = 0; y <= SIDE; ++y) {
    for (int x = 0; x <= SIDE; ++x) {
      const glm::vec2 at(static_cast<float>(x) / SIDE, static_cast<float>(y) / SIDE);
      p.positions.push_back({at, height(at)});
      p.normals.push_back({0, 0, 1});
      p.uvs[0].push_back(at);
      p.bounds.add(glm::dvec3(p.positions.back()));
    }
  }
  for (std::uint32_t y = 0; y < SIDE; ++y) {
    for (std::uint32_t x = 0; x < SIDE; ++x) {
      const std::uint32_t i = y * (SIDE + 1) + x;
      p.indices.insert(p.indices.end(), {i, i + 1, i + SIDE + 1, i + 1, i + SIDE + 2, i + SIDE + 1});
    }
  }
  return p;
}

float flat(const glm::vec2&) { return 0; }
float wave(const glm::vec2& at) { return 0.05f * std::sin(12 * at.x); }

/// Each triangle has vertices of its own, and there are no indices.
Primitive apart(const Primitive& p) {
  Primitive out = p;
  out.indices.clear();
  out.positions.clear();
  out.normals.clear();
  out.uvs[0].clear();
  for (const std::uint32_t i : p.indices) {
    out.positions.push_back(p.positions[i]);
    out.normals.push_back(p.normals[i]);
    out.uvs[0].push_back(p.uvs[0][i]);
  }
  return out;
}

using Vertex = std::tuple<float, float, float, float, float>;

std::set<Vertex> verticesOf(const Primitive& p) {
  std::set<Vertex> out;
  for (std::size_t i = 0; i < p.positions.size(); ++i) {
    const glm::vec3 at = p.positions[i];
    out.insert({at.x, at.y, at.z, p.uvs[0][i].x, p.uvs[0][i].y});
  }
  return out;
}

double areaOf(const Primitive& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(p.positions[p.indices[i + k]]); };
    sum += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return sum;
}

TEST(Simplify, AFlatSheetKeepsItsBorder) {
  const auto out = simplified(sheet(flat), 1e-3);
  ASSERT_TRUE(out);
  EXPECT_LT(out->indices.size(), 3u * 64);
  EXPECT_NEAR(areaOf(*out), 1, 1e-3);
}

TEST(Simplify, MoreErrorLeavesFewerTriangles) {
  const Primitive p = sheet(wave);
  const auto fine = simplified(p, 1e-3), coarse = simplified(p, 1e-2);
  ASSERT_TRUE(fine && coarse);
  EXPECT_LT(2 * coarse->indices.size(), fine->indices.size());
  EXPECT_LT(fine->indices.size(), p.indices.size());
  for (const std::uint32_t index : coarse->indices) ASSERT_LT(index, coarse->positions.size());
}

TEST(Simplify, VerticesAreSomeOfTheGivenOnesWithAllTheyHave) {
  const Primitive p = sheet(wave);
  const auto out = simplified(p, 3e-3);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->normals.size(), out->positions.size());
  EXPECT_EQ(out->uvs[0].size(), out->positions.size());
  EXPECT_TRUE(out->tangents.empty() && out->colors.empty() && out->uvs[1].empty());
  EXPECT_EQ(verticesOf(*out).size(), out->positions.size()) << "none is left over";
  const auto all = verticesOf(p), some = verticesOf(*out);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  EXPECT_EQ(out->bounds.max, p.bounds.max);
}

TEST(Simplify, TrianglesWithVerticesOfTheirOwnAreOneSurface) {
  const auto out = simplified(apart(sheet(flat)), 1e-3);
  ASSERT_TRUE(out);
  EXPECT_LT(out->indices.size(), 3u * 64);
  EXPECT_NEAR(areaOf(*out), 1, 1e-3);
}

TEST(Simplify, ASeamStays) {
  // The right half has other texture coordinates, its left border vertices of its own.
  Primitive p = sheet(flat);
  constexpr std::uint32_t MIDDLE = SIDE / 2;
  std::vector<std::uint32_t> twin(p.positions.size());
  for (std::uint32_t y = 0; y <= SIDE; ++y) {
    const std::uint32_t i = y * (SIDE + 1) + MIDDLE;
    twin[i] = static_cast<std::uint32_t>(p.positions.size());
    p.positions.push_back(p.positions[i]);
    p.normals.push_back(p.normals[i]);
    p.uvs[0].push_back(p.uvs[0][i] + glm::vec2(5, 0));
  }
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    std::uint32_t right = 0;
    for (std::size_t k = 0; k < 3; ++k) right = std::max(right, p.indices[i + k] % (SIDE + 1));
    for (std::size_t k = 0; right > MIDDLE && k < 3; ++k) {
      if (p.indices[i + k] % (SIDE + 1) == MIDDLE) p.indices[i + k] = twin[p.indices[i + k]];
    }
  }
  const auto out = simplified(p, 1e-3);
  ASSERT_TRUE(out);
  EXPECT_LT(out->indices.size(), 3u * 128);
  for (std::size_t i = 0; i < out->indices.size(); i += 3) {
    float least = 1, most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      least = std::min(least, out->positions[out->indices[i + k]].x);
      most = std::max(most, out->positions[out->indices[i + k]].x);
    }
    EXPECT_FALSE(least < 0.5f && most > 0.5f) << "a triangle across the seam";
  }
  EXPECT_NEAR(areaOf(*out), 1, 1e-3);
}

TEST(Simplify, WhatWouldNotBeSmallerIsNone) {
  Primitive one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(simplified(one, 1e-3));
  EXPECT_FALSE(simplified(one, 1e6)) << "nothing is left out whole";
  one.positions.assign(300, glm::vec3(1));
  EXPECT_FALSE(simplified(one, 1e-3)) << "of no extent";
  EXPECT_FALSE(simplified(sheet(flat), 1e-60));
  Primitive huge = sheet(wave);
  for (glm::vec3& at : huge.positions) at *= 1e37f;
  const auto out = simplified(huge, 1e34);
  EXPECT_TRUE(!out || out->indices.size() < huge.indices.size());
}

}  // namespace
}  // namespace telar::simplify_test
