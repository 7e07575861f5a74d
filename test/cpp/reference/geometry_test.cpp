#include "reference/geometry.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

namespace telar::reference {
namespace {

/// A unit square in the plane z = 0 of a node's space.
Scene squareScene(const glm::dmat4& world, int material = -1) {
  Primitive square;
  square.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  square.indices = {0, 1, 2, 0, 2, 3};
  square.material = material;
  Scene scene;
  scene.meshes.push_back({"square", {square}});
  Node node;
  node.mesh = 0;
  node.world = node.local = world;
  scene.nodes.push_back(node);
  return scene;
}

TEST(Geometry, ARayHitsTheTriangleThatIsThere) {
  const auto meshes = placeMeshes(squareScene(glm::dmat4(1)), -1, glm::dvec3(0));
  const Geometry geometry(meshes);
  Hit hit;
  ASSERT_TRUE(geometry.intersect({{0.25f, -0.4f, 2}, {0, 0, -1}}, hit));
  EXPECT_FLOAT_EQ(hit.distance, 2);
  EXPECT_EQ(hit.triangle, 0u);
  const glm::uvec3 t = meshes[0].triangles[hit.triangle];
  const auto& p = meshes[0].positions;
  const glm::vec3 at =
      p[t.x] * (1 - hit.barycentric.x - hit.barycentric.y) + p[t.y] * hit.barycentric.x + p[t.z] * hit.barycentric.y;
  EXPECT_NEAR(at.x, 0.25f, 1e-6f);
  EXPECT_NEAR(at.y, -0.4f, 1e-6f);
  EXPECT_FALSE(geometry.intersect({{0.75f, 0, 2}, {0, 0, -1}}, hit));
}

TEST(Geometry, NormalsStandOnWhatIsScaledBeyondWhatFloatsSquare) {
  for (const double scale : {1e-12, 1.0, 1e10}) {
    const glm::dmat4 world =
        glm::rotate(glm::scale(glm::dmat4(1), glm::dvec3(scale, scale, 2 * scale)), 0.5, glm::dvec3(1, 0, 0));
    const PlacedMesh mesh = placeMeshes(squareScene(world), -1, glm::dvec3(0))[0];
    const glm::vec3 normal = glm::normalize(mesh.normalMatrix * glm::vec3(0, 0, 1));
    const glm::vec3 expected =
        glm::normalize(glm::vec3(glm::transpose(glm::inverse(glm::dmat3(world) / scale)) * glm::dvec3(0, 0, 1)));
    EXPECT_LT(glm::distance(normal, expected), 1e-6f) << scale;
  }
}

// The normal of a hit points to those who see its corners counter-clockwise, whichever side a ray comes from.
TEST(Geometry, NormalsOfHitsFollowTheOrderOfTheCorners) {
  for (const double side : {1.0, -1.0}) {
    const auto meshes = placeMeshes(squareScene(glm::scale(glm::dmat4(1), glm::dvec3(side, 1, 1))), -1, glm::dvec3(0));
    const Geometry geometry(meshes);
    for (const float from : {2.0f, -2.0f}) {
      const std::array<Ray, 3> rays{Ray{{0.25f, -0.4f, from}, {0, 0, -from / 2}},
                                    Ray{{0.75f, 0, from}, {0, 0, -from / 2}},
                                    Ray{{-0.25f, 0.4f, from}, {0, 0, -from / 2}}};
      std::array<std::optional<Hit>, 3> hits;
      hits[1] = Hit{};
      geometry.intersect(rays, hits);
      EXPECT_FALSE(hits[1]) << "of a ray before";
      for (const std::size_t i : {0u, 2u}) {
        Hit alone;
        ASSERT_TRUE(geometry.intersect(rays[i], alone));
        ASSERT_TRUE(hits[i]);
        EXPECT_EQ(hits[i]->triangle, alone.triangle);
        EXPECT_FLOAT_EQ(hits[i]->distance, alone.distance);
        const glm::uvec3 t = meshes[0].triangles[alone.triangle];
        const auto& p = meshes[0].positions;
        const glm::vec3 normal = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
        EXPECT_GT(glm::dot(alone.normal, normal), 0);
        EXPECT_GT(glm::dot(hits[i]->normal, normal), 0);
      }
    }
  }
}

TEST(Geometry, FarFromTheOriginNothingIsLost) {
  const glm::dvec3 far(1e6, -2e6, 5e5);
  const auto meshes = placeMeshes(squareScene(glm::translate(glm::dmat4(1), far)), -1, far);
  EXPECT_EQ(meshes[0].positions[0], glm::vec3(-0.5f, -0.5f, 0));
}

TEST(Geometry, AMirroredNodeTurnsItsNormalsTheRightWay) {
  const auto meshes = placeMeshes(squareScene(glm::scale(glm::dmat4(1), glm::dvec3(-2, 1, 3))), -1, glm::dvec3(0));
  EXPECT_TRUE(meshes[0].mirrored);
  EXPECT_GT((meshes[0].normalMatrix * glm::vec3(0, 0, 1)).z, 0);
}

TEST(Geometry, InstancesStandWhereTheirMatricesPutThem) {
  Scene scene = squareScene(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 1)));
  auto instances = std::make_shared<Instances>();
  instances->matrices = {glm::mat4(1), glm::translate(glm::mat4(1), glm::vec3(5, 0, 0))};
  instances->colors = {{1, 0, 0}, {0, 1, 0}};
  scene.nodes[0].instances = instances;
  const auto meshes = placeMeshes(scene, -1, glm::dvec3(0));
  ASSERT_EQ(meshes.size(), 2u);
  EXPECT_EQ(meshes[1].tint, glm::vec3(0, 1, 0));
  Hit hit;
  ASSERT_TRUE(Geometry(meshes).intersect({{5.25f, 0, 3}, {0, 0, -1}}, hit));
  EXPECT_EQ(hit.mesh, 1u);
  EXPECT_FLOAT_EQ(hit.distance, 2);
}

TEST(Geometry, MaterialsAreReadAsTheReleaseReadsThem) {
  Scene scene = squareScene(glm::dmat4(1), 0);
  Material material;
  material.layers.dispersion = 1;
  material.baseColorTexture.image = 0;
  material.baseColorTexture.uvTransform = glm::mat3(1, -2, 0, 3, 4, 0, 0, 0, 1);
  scene.materials = {material};
  auto instances = std::make_shared<Instances>();
  instances->matrices = {glm::mat4(1)};
  instances->colors = {{1, 0, 0}};
  scene.nodes[0].instances = instances;
  ThreeTerms older;
  older.textureTransform = ThreeTerms::THREE_TEXTURE_TRANSFORM_TSR;
  older.dispersion = ThreeTerms::THREE_DISPERSION_NONE;
  older.instanceColor = ThreeTerms::THREE_INSTANCE_COLOR_NONE;
  const auto today = placeMeshes(scene, -1, glm::dvec3(0));
  EXPECT_EQ(today[0].material, &scene.materials[0]);
  EXPECT_EQ(today[0].tint, glm::vec3(1, 0, 0));
  const auto meshes = placeMeshes(scene, -1, glm::dvec3(0), {}, ShadingModel::kThree, older);
  EXPECT_EQ(meshes[0].material->layers.dispersion, 0);
  EXPECT_EQ(meshes[0].material->baseColorTexture.uvTransform, glm::mat3(1, -3, 0, 2, 4, 0, 0, 0, 1));
  EXPECT_EQ(meshes[0].tint, glm::vec3(1));
}

TEST(Geometry, AnEmptySceneIsHitByNothing) {
  const Geometry geometry({});
  Hit hit;
  EXPECT_FALSE(geometry.intersect({{0, 0, 2}, {0, 0, -1}}, hit));
}

}  // namespace
}  // namespace telar::reference
