#include <limits>

#include "asset/model_builder.h"

namespace telar::test::morph_test {
namespace {

constexpr float NAN_F = std::numeric_limits<float>::quiet_NaN();

/// A quad with two targets: the first moves every vertex by 2 in z, the second the last vertex by 4 in x.
ModelBuilder morphed(const json& weights = {0.5, 0.25}) {
  ModelBuilder model;
  json& primitive = model.quad();
  const int up = model.accessor(std::vector<float>{0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2}, 5126, "VEC3");
  const int aside = model.accessor(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0}, 5126, "VEC3");
  primitive["targets"] = {{{"POSITION", up}}, {{"POSITION", aside}}};
  model.doc["meshes"][0]["weights"] = weights;
  return model;
}

const Primitive& drawn(const Scene& scene) {
  return scene.meshes[static_cast<std::size_t>(scene.nodes[0].mesh)].primitives[0];
}

json& targetOf(ModelBuilder& model, std::size_t index) {
  return model.doc["meshes"][0]["primitives"][0]["targets"][index];
}

TEST(Morph, TargetsAddToPositionsByWeight) {
  const auto scene = load(morphed());
  EXPECT_EQ(drawn(*scene).positions, (std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {1, 1, 1}}));
  EXPECT_EQ(scene->bounds.min, glm::dvec3(0, 0, 1));
  EXPECT_EQ(scene->meshes[0].primitives[0].positions[0], glm::vec3(0, 0, 0));
  EXPECT_EQ(*drawn(*scene).center, glm::dvec3(0.5, 0.5, 0));  // three.js sorts by the unmorphed mesh
}

TEST(Morph, TheNodesWeightsComeBeforeTheMeshs) {
  ModelBuilder model = morphed();
  model.doc["nodes"][0]["weights"] = {-1};
  const auto scene = load(model);
  EXPECT_EQ(drawn(*scene).positions[3], glm::vec3(1, 1, -2));
  EXPECT_EQ(scene->nodes[0].weights, (std::vector<float>{-1, 0.25f}));
}

TEST(Morph, WithoutWeightsTheMeshOfTheFileIsDrawn) {
  const auto scene = load(morphed({0, 0}));
  EXPECT_EQ(scene->nodes[0].mesh, 0);
  EXPECT_EQ(scene->meshes.size(), 1u);
}

TEST(Morph, TooManyWeightsAreIgnoredAndMissingOnesAreZero) {
  EXPECT_EQ(drawn(*load(morphed({1, 0, 7, 7}))).positions[0], glm::vec3(0, 0, 2));
  EXPECT_EQ(drawn(*load(morphed({1}))).positions[3], glm::vec3(0, 1, 2));
}

TEST(Morph, NormalsAndColoursMorphAndAMissingOneAddsTheMeshsOwn) {
  ModelBuilder model = morphed({0.5, 1});
  json& attributes = model.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["NORMAL"] = model.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 5126, "VEC3");
  attributes["COLOR_0"] = model.accessor(std::vector<float>(16, 0.25f), 5126, "VEC4");
  targetOf(model, 0)["NORMAL"] = model.accessor(std::vector<float>{2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0}, 5126, "VEC3");
  targetOf(model, 0)["COLOR_0"] = model.accessor(std::vector<float>(12, 0.5f), 5126, "VEC3");
  const auto scene = load(model);
  EXPECT_EQ(drawn(*scene).normals[0], glm::vec3(1, 0, 2));             // base + half the first + the base again
  EXPECT_EQ(drawn(*scene).colors[0], glm::vec4(0.75, 0.75, 0.75, 1));  // RGB targets count as alpha 1
}

TEST(Morph, SparseAndIntegerTargetsAreRead) {
  ModelBuilder model = morphed({1, 1});
  const int indices = model.view(bytesOf(std::vector<std::uint16_t>{2}));
  const int values = model.view(bytesOf(std::vector<float>{0, 0, 5}));
  model.doc["accessors"].push_back({{"componentType", 5126},
                                    {"count", 4},
                                    {"type", "VEC3"},
                                    {"sparse",
                                     {{"count", 1},
                                      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                      {"values", {{"bufferView", values}}}}}});
  targetOf(model, 0)["POSITION"] = model.doc["accessors"].size() - 1;
  targetOf(model, 1)["POSITION"] =
      model.accessor(std::vector<std::int16_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 32767, 0, -32767}, 5122, "VEC3", true);
  const auto scene = load(model);
  EXPECT_EQ(drawn(*scene).positions[2], glm::vec3(1, 1, 5));
  EXPECT_EQ(drawn(*scene).positions[3], glm::vec3(1, 1, -1));
}

TEST(Morph, TargetsThatDoNotFitAreRefused) {
  ModelBuilder model = morphed();
  const std::string where = "/meshes/0/primitives/0/targets/1/POSITION";
  targetOf(model, 1)["POSITION"] = model.accessor(std::vector<float>(9, 1), 5126, "VEC3");
  EXPECT_EQ(errorOf(model), "E_ACCESSOR at " + where);
  targetOf(model, 1)["POSITION"] = model.accessor(std::vector<float>(8, 1), 5126, "VEC2");
  EXPECT_EQ(errorOf(model), "E_ACCESSOR at " + where);
  targetOf(model, 1)["POSITION"] = 99;
  EXPECT_EQ(errorOf(model), "E_REF at " + where);
  model.doc["meshes"][0]["primitives"][0]["targets"] = json::array();
  for (int i = 0; i < 257; ++i) model.doc["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", 0}});
  EXPECT_EQ(errorOf(model), "L_MORPH_TARGETS at /meshes/0/primitives/0/targets");
}

TEST(Morph, TargetsAndCopiesCountAsVerticesBeforeAnyIsRead) {
  Limits limits;
  limits.vertices = 15;  // four, of two targets, and the copy
  EXPECT_EQ(errorOf(morphed(), limits), "L_VERTICES at /meshes/0/primitives/0");
  limits.vertices = 16;
  EXPECT_EQ(errorOf(morphed(), limits), "");
}

TEST(Morph, WhatIsNotFiniteIsDroppedOnlyWhereItIsDrawn) {
  ModelBuilder model = morphed({1, 0});
  targetOf(model, 1)["POSITION"] =
      model.accessor(std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, NAN_F, 0, 0}, 5126, "VEC3");
  EXPECT_EQ(drawn(*load(model)).indices.size(), 6u);
  model.doc["meshes"][0]["weights"] = {1, 1};
  const auto scene = load(model);
  EXPECT_EQ(drawn(*scene).indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
}

TEST(Morph, TangentsStay) {
  ModelBuilder model = morphed();
  const std::vector<float> tangents{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  model.doc["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = model.accessor(tangents, 5126, "VEC4");
  targetOf(model, 0)["TANGENT"] = model.accessor(std::vector<float>(12, 1), 5126, "VEC3");
  const auto scene = load(model);
  EXPECT_EQ(drawn(*scene).tangents[0], glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(hasWarning(*scene, "W_MORPH"));
}

}  // namespace
}  // namespace telar::test::morph_test
