#include "reference/ambient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace telar::reference {
namespace {

/// A rectangle of two triangles, which shows the side from which its corners run counter-clockwise.
Primitive rectangle(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up, int material = -1) {
  Primitive primitive;
  primitive.positions = {corner, corner + along, corner + along + up, corner + up};
  primitive.indices = {0, 1, 2, 0, 2, 3};
  primitive.material = material;
  return primitive;
}

Scene sceneOf(std::vector<Primitive> primitives, std::vector<Material> materials = {}) {
  Scene scene;
  for (const Primitive& primitive : primitives) {
    for (const glm::vec3& p : primitive.positions) scene.bounds.add(glm::dvec3(p));
  }
  scene.meshes.push_back({"mesh", std::move(primitives)});
  scene.materials = std::move(materials);
  Node node;
  node.mesh = 0;
  scene.nodes.push_back(node);
  return scene;
}

constexpr glm::vec3 UP(0, 1, 0);

/// What is open above a point on a floor at y = 0 whose normal is up.
float openAbove(const Scene& scene, const glm::dvec3& point, const glm::vec3& toViewer = UP, int rays = 4096) {
  const Shot shot;
  const PlacedScene placed(scene, shot, {});
  const Rays from = placed.raysFrom(glm::vec3(point - placed.centre), UP, toViewer);
  return openPart(placed.geometry, from, UP, Random(7, 0, 0), rays);
}

/// A floor, and a wall at x = 0 that is much wider than it is high, 1 m.
Scene floorAndWall(const Material& material) {
  return sceneOf({rectangle({0, 0, 100}, {3, 0, 0}, {0, 0, -200}, 0), rectangle({0, 0, 100}, {0, 0, -200}, UP, 0)},
                 {material});
}

TEST(Ambient, AFloorAloneIsOpenToTheLastBit) {
  EXPECT_EQ(openAbove(sceneOf({rectangle({-1, 0, 1}, {2, 0, 0}, {0, 0, -2})}), {0.3, 0, 0.2}), 1.0f);
}

/// A wall of angle theta above the horizon, endless to both sides, takes (1 - cos theta) / 2 of the weighted
/// hemisphere. src: Siegel and Howell, "Thermal Radiation Heat Transfer", configuration factors of strips
TEST(Ambient, AWallTakesItsPartOfTheHemisphere) {
  const Scene scene = floorAndWall({});
  const auto exact = [](double x) { return 1 - (1 - std::cos(std::atan(1 / x))) / 2; };
  for (const double x : {0.05, 0.4, 1.0, 2.5}) {
    // 4096 rays that fill the disk evenly: a border is off by about 4096 ** -0.75 = 0.002, hardly ever by twice that.
    EXPECT_NEAR(openAbove(scene, {x, 0, 0}), exact(x), 0.004) << x;
  }
  EXPECT_GT(std::abs(openAbove(scene, {0.4, 0, 0}) - exact(0.45)), 0.004) << "the wall 5 cm farther";
  // Not weighted by the cosine, the wall takes theta / pi.
  const double even = 1 - std::atan(1 / 0.4) / std::numbers::pi;
  EXPECT_GT(std::abs(openAbove(scene, {0.4, 0, 0}) - even), 0.004) << "without the cosine";
}

TEST(Ambient, SetsOfRaysFillTheHemisphereTogether) {
  const Scene scene = floorAndWall({});
  const Shot shot;
  const PlacedScene placed(scene, shot, {});
  const Rays from = placed.raysFrom(glm::vec3(glm::dvec3(0.4, 0, 0) - placed.centre), UP, UP);
  const auto of = [&](int first, int rays) {
    return openPart(placed.geometry, from, UP, Random(7, 0, static_cast<std::uint32_t>(first)), rays);
  };
  float sum = 0;
  for (int set = 0; set < 16; ++set) sum += of(set * 16, 16);
  EXPECT_FLOAT_EQ(sum / 16, of(0, 256));
  std::set<float> values;
  for (int set = 0; set < 16; ++set) values.insert(of(set * 16, 16));
  EXPECT_GT(values.size(), 1u) << "they are not the same rays";
}

TEST(Ambient, WhatDoesNotShowHidesNothing) {
  const auto open = [](const Material& material) { return openAbove(floorAndWall(material), {0.4, 0, 0}); };
  Material solid;
  const float walled = open(solid);
  EXPECT_LT(walled, 0.75f);
  Material cutOut;
  cutOut.alphaMode = AlphaMode::kMask, cutOut.baseColorFactor.a = 0.3f;
  EXPECT_EQ(open(cutOut), 1.0f);
  cutOut.alphaCutoff = 0.2f;
  EXPECT_EQ(open(cutOut), walled) << "a cut-off beneath its alpha";
  Material sheer;
  sheer.alphaMode = AlphaMode::kBlend, sheer.baseColorFactor.a = 0.4f;
  EXPECT_EQ(open(sheer), 1.0f);
  sheer.baseColorFactor.a = 0.6f;
  EXPECT_EQ(open(sheer), walled);

  const auto fromBehind = [](bool doubleSided) {
    Material material;
    material.doubleSided = doubleSided;
    // The wall shows its other side.
    return openAbove(
        sceneOf({rectangle({0, 0, 100}, {3, 0, 0}, {0, 0, -200}, 0), rectangle({0, 0, -100}, {0, 0, 200}, UP, 0)},
                {material}),
        {0.4, 0, 0});
  };
  EXPECT_EQ(fromBehind(false), 1.0f);
  EXPECT_EQ(fromBehind(true), walled);
}

/// The viewer looks through the back of a shell, which is culled, onto the floor closely beneath it. From there its
/// front is seen, on all sides: without a rule the floor were black.
TEST(Ambient, WhatIsSeenThroughACulledShellIsNotBlack) {
  const Primitive floor = rectangle({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0);
  const auto under = [&](float height, bool doubleSided) {
    Material material;
    material.doubleSided = doubleSided;
    const Primitive shell = rectangle({-1, height, -1}, {2, 0, 0}, {0, 0, 2}, 0);
    return openAbove(sceneOf({floor, shell}, {material}), {0, 0, 0});
  };
  // Rays so flat that they go farther than 2 % of the radius to it are hidden: cos^2 of that angle.
  const double flat = 0.005 / (SHELL * std::sqrt(2.0));
  EXPECT_NEAR(under(0.005f, false), 1 - flat * flat, 0.004);
  EXPECT_LT(under(0.005f, true), 0.01f) << "no shell: it would hide the floor from the viewer";
  EXPECT_LT(under(0.1f, false), 0.2f) << "no shell of the same cloth: 10 cm";
}

TEST(Ambient, AJobHasTheSameNumbersWithAnyThreads) {
  const Scene scene = floorAndWall({});
  std::vector<SurfacePoint> points;
  points.reserve(600);
  for (int i = 0; i < 600; ++i)
    points.push_back({{0.005 * (i + 1), 0, 0}, UP, UP, 16, static_cast<std::uint32_t>(i % 16 * 16)});
  const Shot shot;
  const CancelToken cancel;
  AmbientJob one{scene, shot, points, 1, cancel}, three{scene, shot, points, 3, cancel};
  findAmbient(one);
  findAmbient(three);
  EXPECT_EQ(one.open, three.open);
  EXPECT_LT(one.open.front(), one.open.back());
}

}  // namespace
}  // namespace telar::reference
