#include "reference/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "expect_error.h"
#include "telar/visibility.h"

namespace telar::reference {
namespace {

/// A small triangle that faces up at a point of the floor, and one wall beside it.
struct Corner {
  double distance = 0.4;  ///< of the point from the wall, metres
  float height = 1;       ///< of the wall, metres
  glm::dmat4 node{1.0};
  bool doubleSided = true;

  std::shared_ptr<Scene> scene() const {
    const auto x = static_cast<float>(distance);
    Primitive floor, wall;
    floor.positions = {{x, 0, 0}, {x + 1e-3f, 0, 0}, {x, 0, -1e-3f}};
    floor.normals.assign(3, {0, 1, 0});
    wall.positions = {{0, 0, 500}, {0, 0, -500}, {0, height, -500}, {0, height, 500}};
    wall.indices = {0, 1, 2, 0, 2, 3};
    floor.material = wall.material = 0;
    auto out = std::make_shared<Scene>();
    Mesh mesh;
    mesh.primitives = {floor, wall};
    out->meshes.push_back(mesh);
    out->fileMeshes = 1;
    Material material;
    material.doubleSided = doubleSided;
    out->materials = {material};
    Node at;
    at.mesh = at.file.mesh = 0;
    at.world = node;
    out->nodes.push_back(at);
    for (const Primitive& p : out->meshes[0].primitives) {
      for (const glm::vec3& v : p.positions) out->bounds.add(glm::dvec3(node * glm::dvec4(v, 1)));
    }
    return out;
  }
};

VisibilityJob::Sides floorOf(const std::shared_ptr<Scene>& scene, int rays = 4096) {
  Shot shot;
  shot.shading = ShadingModel::kFabric;
  const CancelToken cancel;
  VisibilityJob job{*scene, shot, rays, 2, cancel};
  findVisibility(job);
  return job.sides.at(&scene->meshes[0].primitives[0]);
}

/// Open part of the hemisphere above a floor by an endless wall. src: Siegel and Howell, "Thermal Radiation Heat
/// Transfer", configuration factors of strips
double openBeside(double distance, double height) { return 1 - (1 - distance / std::hypot(distance, height)) / 2; }

// 4096 points that fill the disk evenly: a border is off by about 4096 ** -0.75 = 0.002, hardly ever by twice that.
constexpr double NEAR = 0.004;

TEST(Visibility, OfAFloorBesideAWallIsTheStripsConfigurationFactor) {
  for (const double distance : {0.05, 0.4, 1.0, 2.5}) {
    EXPECT_NEAR(floorOf(Corner{distance}.scene())[0][0].w, openBeside(distance, 1), NEAR) << distance;
  }
  EXPECT_GT(std::abs(floorOf(Corner{0.4}.scene())[0][0].w - openBeside(0.45, 1)), NEAR) << "a wall 5 cm farther";
}

TEST(Visibility, LeansAwayFromAnEndlessWall) {
  // Of the half of the hemisphere that is left, the integral of direction times cosine is (2 / 3, pi / 3).
  const glm::vec4 open = floorOf(Corner{1e-3, 1e4f}.scene())[0][0];
  EXPECT_NEAR(open.w, 0.5, NEAR);
  EXPECT_NEAR(std::atan2(open.x, open.y), std::atan2(2.0 / 3, std::numbers::pi / 3), 0.01);
  EXPECT_NEAR(open.z, 0, 0.01);
  const double even = std::atan2(0.5, 0.5);  // of all directions alike
  EXPECT_GT(std::abs(std::atan2(open.x, open.y) - even), 0.01) << "without the cosine";
}

TEST(Visibility, OfTheBackIsItsOwn) {
  const auto sides = floorOf(Corner{}.scene());
  EXPECT_EQ(sides[1][0].w, 1.0f) << "nothing is below the floor";
  EXPECT_NEAR(sides[1][0].y, -1, 0.01);
  EXPECT_TRUE(floorOf(Corner{.doubleSided = false}.scene())[1].empty()) << "nobody sees it";
}

TEST(Visibility, ANodeTurnsDirectionsBackIntoItsMesh) {
  // Mirrored, turned and squeezed: the direction is stored so that it turns as normals do.
  Corner corner{1e-3, 1e4f};
  corner.node =
      glm::dmat4(glm::dvec4(0, 0, -2, 0), glm::dvec4(0, 0.5, 0, 0), glm::dvec4(3, 0, 0, 0), glm::dvec4(7, -2, 1, 1));
  const auto scene = corner.scene();
  const glm::vec3 open(floorOf(scene)[0][0]);
  const glm::vec3 world = glm::normalize(glm::inverse(glm::transpose(glm::mat3(glm::dmat3(corner.node)))) * open);
  EXPECT_NEAR(std::atan2(-world.z, world.y), std::atan2(2.0 / 3, std::numbers::pi / 3), 0.01);
}

TEST(Visibility, OfAMeshInSeveralPlacesIsTheirMean) {
  auto scene = Corner{}.scene();
  Node apart = scene->nodes[0];
  apart.world = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 50, 0));
  scene->nodes.push_back(apart);
  scene->bounds.add(glm::dvec3(1, 51, 500));
  // The second place sees its own wall, and is too far from the first to see that.
  EXPECT_NEAR(floorOf(scene)[0][0].w, openBeside(0.4, 1), NEAR);
}

TEST(Visibility, OfAMeshThatDeformsHasNoDirection) {
  auto scene = Corner{}.scene();
  std::vector<Primitive> primitives(scene->meshes[0].primitives.begin(), scene->meshes[0].primitives.end());
  primitives[0].deformers = std::make_shared<const Deformers>();
  scene->meshes[0].primitives = primitives;
  const glm::vec4 open = floorOf(scene)[0][0];
  EXPECT_EQ(glm::vec3(open), glm::vec3(0));
  EXPECT_NEAR(open.w, openBeside(0.4, 1), NEAR);
}

TEST(Visibility, AVertexWithinAnotherPartTakesThatOfItsNeighbours) {
  // A strip that comes out of a closed tent: the vertices within see nothing.
  const auto strip = [](bool tented) {
    Primitive cloth, tent;
    for (int i = 0; i < 6; ++i) {
      const float x = 0.1f * static_cast<float>(i);
      cloth.positions.insert(cloth.positions.end(), {{x, 0, 0.01f}, {x, 0, -0.01f}});
      cloth.normals.insert(cloth.normals.end(), 2, {0, 1, 0});
      const auto v = static_cast<std::uint32_t>(2 * i);
      if (i > 0) cloth.indices.insert(cloth.indices.end(), {v - 2, v, v - 1, v - 1, v, v + 1});
    }
    tent.positions = {
        {-0.3f, -0.3f, -0.3f}, {0.23f, -0.3f, -0.3f}, {0.23f, -0.3f, 0.3f}, {-0.3f, -0.3f, 0.3f}, {0, 0.3f, 0}};
    tent.indices = {0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0};
    cloth.material = tent.material = 0;
    auto scene = Corner{}.scene();
    scene->meshes[0].primitives = tented ? std::vector<Primitive>{cloth, tent} : std::vector<Primitive>{cloth};
    return floorOf(scene, 256)[0];
  };
  const auto seen = strip(true), alone = strip(false);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_GT(seen[i].w, 0.3f) << i;
    EXPECT_EQ(alone[i].w, 1.0f) << i;
  }
  EXPECT_LT(seen[11].w, 1.0f) << "the tent hides a part of the sky outside";
}

TEST(Visibility, IsTheSameWithAnyNumberOfThreads) {
  const auto scene = Corner{}.scene();
  Shot shot;
  const CancelToken cancel;
  VisibilityJob one{*scene, shot, 64, 1, cancel}, three{*scene, shot, 64, 3, cancel};
  findVisibility(one);
  findVisibility(three);
  EXPECT_EQ(one.sides, three.sides);
}

TEST(Visibility, IsRefusedBeforeAnyRayWhereItWouldTakeTooMany) {
  const auto scene = Corner{}.scene();
  Limits limits;
  limits.visibilityRays = 7u * 2 * 64 - 1;
  EXPECT_ERROR(withAmbientVisibility(scene, 64, {}, limits, CancelToken()), "L_VISIBILITY_RAYS");
  limits = Limits();
  limits.memoryBytes = 7 * 128 - 1;
  EXPECT_ERROR(withAmbientVisibility(scene, 64, {}, limits, CancelToken()), "L_MEMORY_BYTES");
}

}  // namespace
}  // namespace telar::reference
