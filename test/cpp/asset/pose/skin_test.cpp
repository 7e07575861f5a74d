#include <cmath>
#include <limits>

#include "asset/model_builder.h"

namespace telar::test::skin_test {
namespace {

constexpr float NAN_F = std::numeric_limits<float>::quiet_NaN();

/// A quad whose lower edge (y = 0) hangs on the first joint and whose upper edge (y = 1) on the second. Nodes: 0 the
/// mesh's, 1 and 2 the joints; the second stands at the upper edge, bound there.
ModelBuilder skinned(const std::vector<float>& weights = {1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}) {
  ModelBuilder model;
  json& primitive = model.quad();
  primitive["attributes"]["NORMAL"] =
      model.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3");
  primitive["attributes"]["JOINTS_0"] =
      model.accessor(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 5121, "VEC4");
  primitive["attributes"]["WEIGHTS_0"] = model.accessor(weights, 5126, "VEC4");
  std::vector<float> bind(32, 0.0f);
  for (const int i : {0, 5, 10, 15, 16, 21, 26, 31}) bind[static_cast<std::size_t>(i)] = 1;
  bind[16 + 13] = -1;  // the second joint's bind pose is 1 up
  model.doc["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", model.accessor(bind, 5126, "MAT4")}}};
  model.doc["nodes"][0]["skin"] = 0;
  model.doc["nodes"].push_back({{"children", {2}}});
  model.doc["nodes"].push_back({{"translation", {0, 1, 0}}});
  model.doc["scenes"][0]["nodes"] = {0, 1};
  return model;
}

/// The first primitive as it is drawn, in world space.
std::vector<glm::vec3> drawn(const Scene& scene) {
  const Node& node = scene.nodes[0];
  std::vector<glm::vec3> out;
  for (const auto& p : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives[0].positions) {
    out.emplace_back(node.world * glm::dvec4(glm::dvec3(p), 1.0));
  }
  return out;
}

const Primitive& primitiveOf(const Scene& scene) {
  return scene.meshes[static_cast<std::size_t>(scene.nodes[0].mesh)].primitives[0];
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-6) << i;
}

TEST(Skin, InItsBindPoseTheMeshStandsAsInTheFile) {
  const auto scene = load(skinned());
  EXPECT_EQ(drawn(*scene), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(scene->fileMeshes, 1u);
}

TEST(Skin, VerticesFollowTheirJoints) {
  ModelBuilder model = skinned();
  // Half a turn about y at the upper edge, moved by 2 in z.
  model.doc["nodes"][2] = {{"translation", {0, 1, 2}}, {"rotation", {0, 1, 0, 0}}};
  const auto scene = load(model);
  const auto positions = drawn(*scene);
  expectNear(positions[1], {1, 0, 0});
  expectNear(positions[2], {-1, 1, 2});
  expectNear(positions[3], {0, 1, 2});
  expectNear(primitiveOf(*scene).normals[0], {0, 0, 1});
  expectNear(primitiveOf(*scene).normals[2], {0, 0, -1});
  EXPECT_EQ(scene->bounds.min, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(scene->bounds.max, glm::dvec3(1, 1, 2));
}

TEST(Skin, TheNodeOfTheMeshDoesNotMoveIt) {
  ModelBuilder model = skinned();
  model.doc["nodes"][0]["translation"] = {5, 6, 7};
  model.doc["nodes"][0]["scale"] = {2, 1, 3};
  const auto scene = load(model);
  expectNear(drawn(*scene)[2], {1, 1, 0});
}

TEST(Skin, NormalsTurnWithTheMatrixItself) {
  ModelBuilder model = skinned({0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  model.doc["nodes"][2]["scale"] = {1, 1, 3};
  const auto scene = load(model);
  expectNear(primitiveOf(*scene).normals[2], {0, 0, 3});  // not 1/3: no inverse transpose, as in three.js
  expectNear(primitiveOf(*scene).normals[0], {0, 0, 2});
}

TEST(Skin, WeightsAreDividedByTheirSum) {
  ModelBuilder model = skinned({1, 3, 0, 0, 0, 0, 0, 0, 0, -2, 0, 0, NAN_F, 1, 0, 0});
  model.doc["nodes"][2]["translation"] = {0, 1, 4};
  const auto scene = load(model);
  const auto positions = drawn(*scene);
  expectNear(positions[0], {0, 0, 3});     // a quarter and three quarters
  expectNear(positions[1], {1, 0, 0});     // no weight: the first joint
  expectNear(positions[2], {-1, -1, -4});  // the sum of the sizes: -1
  expectNear(positions[3], {0, 1, 0});     // not finite: the first joint
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
}

TEST(Skin, IntegerWeightsKeepTheirSteps) {
  ModelBuilder model = skinned();
  model.doc["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = model.accessor(
      std::vector<std::uint8_t>{100, 100, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0}, 5121, "VEC4", true);
  const auto scene = load(model);
  // 100 of 200 comes out just below a half, in JavaScript's doubles too: 127 of 255, not 128.
  const auto& weights = scene->meshes[0].primitives[0].deformers->weights[0];
  EXPECT_FLOAT_EQ(weights.x, 127.0f / 255);
  EXPECT_FLOAT_EQ(weights.y, 127.0f / 255);
}

TEST(Skin, AJointOutsideOfTheSceneStandsAtTheOrigin) {
  ModelBuilder model = skinned();
  model.doc["nodes"][1] = json::object();
  model.doc["nodes"][2]["translation"] = {0, 50, 0};
  model.doc["scenes"][0]["nodes"] = {0, 1};
  const auto scene = load(model);
  expectNear(drawn(*scene)[2], {1, 0, 0});  // only the bind matrix is left
  EXPECT_TRUE(hasWarning(*scene, "W_SKIN"));
}

TEST(Skin, MeshesWithoutAllStreamsAndLinesAreDrawnAsTheyAre) {
  ModelBuilder model = skinned();
  model.doc["nodes"][2]["translation"] = {0, 1, 9};
  model.doc["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  expectNear(drawn(*load(model))[2], {1, 1, 0});
  ModelBuilder lines = skinned();
  lines.doc["nodes"][2]["translation"] = {0, 1, 9};
  lines.doc["meshes"][0]["primitives"][0]["mode"] = 1;
  expectNear(drawn(*load(lines))[2], {1, 1, 0});
}

TEST(Skin, OnlyTheFirstFourJointsCount) {
  ModelBuilder model = skinned();
  json& attributes = model.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] = attributes["JOINTS_0"];
  attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
  const auto scene = load(model);
  expectNear(drawn(*scene)[2], {1, 1, 0});
  EXPECT_TRUE(hasWarning(*scene, "W_SKIN"));
}

TEST(Skin, WhatContradictsItsMeshIsRefused) {
  ModelBuilder model = skinned();
  const auto with = [&model](const char* pointer, const json& value) {
    ModelBuilder changed = model;
    changed.doc[json::json_pointer(pointer)] = value;
    return errorOf(changed);
  };
  const std::string where = "/meshes/0/primitives/0/attributes/";
  const int far = model.accessor(std::vector<std::uint8_t>(16, 2), 5121, "VEC4");
  EXPECT_EQ(with("/meshes/0/primitives/0/attributes/JOINTS_0", far), "E_SKIN at " + where + "JOINTS_0");
  EXPECT_EQ(with("/meshes/0/primitives/0/attributes/JOINTS_0", 1), "E_SKIN at " + where + "JOINTS_0");
  EXPECT_EQ(with("/meshes/0/primitives/0/attributes/WEIGHTS_0", 0), "E_SKIN at " + where + "WEIGHTS_0");
  const int few = model.accessor(std::vector<float>(12, 0.5f), 5126, "VEC4");
  EXPECT_EQ(with("/meshes/0/primitives/0/attributes/WEIGHTS_0", few), "E_ACCESSOR at " + where + "WEIGHTS_0");
  const int one = model.accessor(std::vector<float>(16, 0.5f), 5126, "MAT4");
  EXPECT_EQ(with("/skins/0/inverseBindMatrices", one), "E_SKIN at /skins/0/inverseBindMatrices");
  EXPECT_EQ(with("/skins/0/inverseBindMatrices", 0), "E_SKIN at /skins/0/inverseBindMatrices");
  EXPECT_EQ(with("/skins/0/joints", json::array()), "E_SKIN at /skins/0/joints");
  EXPECT_EQ(with("/skins/0/joints/1", 9), "E_REF at /skins/0/joints/1");
  EXPECT_EQ(with("/nodes/0/skin", 1), "E_REF at /nodes/0/skin");
  EXPECT_EQ(with("/nodes/2/children", {1}), "E_GRAPH at /nodes/1");
}

TEST(Skin, MatricesOfAHugeCountAreReadOnlyWhereThereAreJoints) {
  ModelBuilder model = skinned();
  model.doc["skins"][0]["inverseBindMatrices"] = model.doc["accessors"].size();
  model.doc["accessors"].push_back({{"componentType", 5126}, {"count", 1ull << 50}, {"type", "MAT4"}});
  EXPECT_EQ(errorOf(model), "E_NO_GEOMETRY");  // all of them zero
}

TEST(Skin, BindMatricesThatAreNotFiniteDropTheirElements) {
  ModelBuilder model = skinned();
  std::vector<float> bind(32, NAN_F);
  for (std::size_t i = 0; i < 16; ++i) bind[i] = i % 5 == 0 ? 1.0f : 0.0f;
  model.doc["skins"][0]["inverseBindMatrices"] = model.accessor(bind, 5126, "MAT4");
  EXPECT_EQ(errorOf(model), "E_NO_GEOMETRY");
  // Where only an unused joint is not finite, nothing is lost.
  ModelBuilder unused = skinned(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  unused.doc["skins"][0]["inverseBindMatrices"] = unused.accessor(bind, 5126, "MAT4");
  expectNear(drawn(*load(unused))[2], {1, 1, 0});
}

TEST(Skin, DeformedCopiesCountAsVertices) {
  Limits limits;
  limits.vertices = 7;
  EXPECT_EQ(errorOf(skinned(), limits), "L_VERTICES at /meshes/0/primitives/0");
  limits.vertices = 8;
  EXPECT_EQ(errorOf(skinned(), limits), "");
}

}  // namespace
}  // namespace telar::test::skin_test
