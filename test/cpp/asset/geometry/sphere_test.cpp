#include "asset/geometry/sphere.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace telar::test {
namespace {

using asset::Sphere;

TEST(Sphere, GrowsJustSoFarThatAPointLiesInside) {
  Sphere sphere;
  sphere.add(glm::dvec3(1, 0, 0));
  EXPECT_EQ(sphere.radius, 0);
  sphere.add(glm::dvec3(3, 0, 0));
  EXPECT_EQ(sphere.center, glm::dvec3(2, 0, 0));
  EXPECT_EQ(sphere.radius, 1);
  sphere.add(glm::dvec3(2, 0.5, 0));
  EXPECT_EQ(sphere.radius, 1);
}

TEST(Sphere, HoldsOtherSpheres) {
  Sphere sphere{{0, 0, 0}, 1};
  sphere.add(Sphere{{4, 0, 0}, 2});
  EXPECT_EQ(sphere.center, glm::dvec3(2.5, 0, 0));
  EXPECT_EQ(sphere.radius, 3.5);
  sphere.add(Sphere());
  EXPECT_EQ(sphere.radius, 3.5);
  sphere.add(Sphere{{2.5, 0, 0}, 5});
  EXPECT_EQ(sphere.radius, 5);
}

TEST(Sphere, TakesTheLargestScaleOfAMatrix) {
  const Sphere sphere = Sphere{{1, 0, 0}, 2}.transformed(glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 1)));
  EXPECT_EQ(sphere.center, glm::dvec3(2, 0, 0));
  EXPECT_EQ(sphere.radius, 6);
}

}  // namespace
}  // namespace telar::test
