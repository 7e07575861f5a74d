#include "asset/scene/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>

namespace telar::asset {
namespace {

/// How far the farthest point lies in a direction.
double farthest(const std::vector<glm::dvec3>& points, const glm::dvec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points) most = std::max(most, glm::dot(p, direction));
  return most;
}

std::vector<glm::dvec3> outlined(const std::vector<glm::dvec3>& points) {
  Outline outline;
  for (const glm::dvec3& p : points) outline.add(p);
  return outline.points();
}

/// All points of a cube of whole numbers that lie on its surface: 98.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> out;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 2) out.emplace_back(x, y, z);
  return out;
}

TEST(Outline, HasTheFarthestPointInEachDirection) {
  std::mt19937 random(7);
  std::normal_distribution<double> place;
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 2000; ++i) points.emplace_back(place(random), 3 * place(random) - 40, 1e-3 * place(random));
  const std::vector<glm::dvec3> kept = outlined(points);
  EXPECT_LE(kept.size(), 98u);
  for (const glm::dvec3& direction : directions()) EXPECT_EQ(farthest(kept, direction), farthest(points, direction));
  for (const glm::dvec3& p : kept) EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
}

TEST(Outline, OfOnePointIsThatPoint) {
  for (const glm::dvec3 p : {glm::dvec3(0), glm::dvec3(-3, 1e-300, 5e20)})
    EXPECT_EQ(outlined({p, p}), (std::vector<glm::dvec3>{p}));
}

TEST(Outline, WhatIsNoNumberIsNotKept) {
  const double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(outlined({}).empty());
  EXPECT_TRUE(outlined({{none, 0, 0}}).empty());
  EXPECT_TRUE(outlined({{infinite, 0, 0}}).empty());
  EXPECT_EQ(outlined({{none, none, none}, {1, 2, 3}}), (std::vector<glm::dvec3>{{1, 2, 3}}));
}

}  // namespace
}  // namespace telar::asset
