#include <cmath>
#include <limits>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

constexpr const char* EXTENSION = "EXT_mesh_gpu_instancing";

/// A quad at three places, the last one mirrored; its node stands 10 to the right.
ModelBuilder instanced() {
  ModelBuilder model;
  model.quad();
  json attributes = {
      {"TRANSLATION", model.accessor(std::vector<float>{0, 0, 0, 0, 5, 0, 0, 0, -7}, 5126, "VEC3")},
      {"SCALE", model.accessor(std::vector<float>{1, 1, 1, 2, 3, 1, -1, 1, 1}, 5126, "VEC3")},
  };
  model.doc["nodes"][0] = {
      {"mesh", 0}, {"translation", {10, 0, 0}}, {"extensions", {{EXTENSION, {{"attributes", attributes}}}}}};
  model.doc["extensionsUsed"] = {EXTENSION};
  return model;
}

json& attributesOf(ModelBuilder& model) { return model.doc["nodes"][0]["extensions"][EXTENSION]["attributes"]; }

TEST(Instances, AreMatricesInTheNodesSpace) {
  const auto scene = load(instanced());
  ASSERT_TRUE(scene->nodes[0].instances);
  const Instances& instances = *scene->nodes[0].instances;
  ASSERT_EQ(instances.matrices.size(), 3u);
  EXPECT_EQ(instances.matrices[1], glm::mat4(2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1));
  EXPECT_TRUE(instances.colors.empty());
  EXPECT_EQ(scene->bounds.min, glm::dvec3(9, 0, -7));
  EXPECT_EQ(scene->bounds.max, glm::dvec3(12, 8, 0));
  EXPECT_EQ(scene->triangleCount, 6u);
  EXPECT_EQ(scene->drawCount, 1u);
  EXPECT_FALSE(hasWarning(*scene, "W_EXT_IGNORED"));
}

TEST(Instances, FactsMeasureEveryPlace) {
  const json facts = json::parse(describeScene(*load(instanced())));
  EXPECT_EQ(facts["bounds"]["min"], (json{9, 0, -7}));
  EXPECT_NE(std::find(facts["outline"].begin(), facts["outline"].end(), json({12, 8, 0})), facts["outline"].end());
}

TEST(Instances, ManyVerticesAreMeasuredByTheirBox) {
  ModelBuilder model;
  // A triangle that touches its box at the upper left and the lower right only.
  const int position = model.accessor(std::vector<float>{0, 1, 0, 1, 0, 0, 0.4f, 0.4f, 0}, 5126, "VEC3");
  model.primitive({{"POSITION", position}});
  const std::size_t places = (std::size_t{1} << 20) / 3 + 1;
  Limits limits;
  limits.instances = places;
  std::vector<float> turned(places * 4);
  for (std::size_t i = 0; i < places; ++i) turned[4 * i + 2] = std::sqrt(0.5f), turned[4 * i + 3] = std::sqrt(0.5f);
  turned[2] = std::sin(0.3926991f), turned[3] = std::cos(0.3926991f);  // the first one by 45 degrees
  json attributes = {{"ROTATION", model.accessor(turned, 5126, "VEC4")}};
  model.doc["nodes"][0]["extensions"][EXTENSION]["attributes"] = attributes;
  const auto scene = load(model, limits);
  EXPECT_NEAR(scene->bounds.max.y, std::sqrt(2.0), 1e-6);  // the box's corner, which no vertex reaches
}

TEST(Instances, ColoursAreThreeNumbersOrTheFirstThreeOfFour) {
  ModelBuilder model = instanced();
  attributesOf(model)["_COLOR_0"] =
      model.accessor(std::vector<std::uint8_t>{255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255, 9}, 5121, "VEC4", true);
  EXPECT_EQ(load(model)->nodes[0].instances->colors, (std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  attributesOf(model)["_COLOR_0"] = model.accessor(std::vector<float>{1, 0, 0, 0, -1, 0, 0, 0, 1e9f}, 5126, "VEC3");
  const auto scene = load(model);
  EXPECT_EQ(scene->nodes[0].instances->colors[2], glm::vec3(0, 0, 65504));
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
}

TEST(Instances, NormalizedRotationsAndUnknownAttributesAreTaken) {
  ModelBuilder model = instanced();
  attributesOf(model).erase("SCALE");
  attributesOf(model)["ROTATION"] =
      model.accessor(std::vector<std::int16_t>{0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0, 0, 32767}, 5122, "VEC4", true);
  attributesOf(model)["_ID"] = model.accessor(std::vector<float>{1, 2, 3}, 5126, "SCALAR");
  const auto scene = load(model);
  EXPECT_EQ(scene->nodes[0].instances->matrices[0][0], glm::vec4(-1, 0, 0, 0));
}

TEST(Instances, ThoseThatAreNotFiniteAreLeftOut) {
  ModelBuilder model = instanced();
  attributesOf(model)["TRANSLATION"] =
      model.accessor(std::vector<float>{0, 0, 0, std::numeric_limits<float>::infinity(), 5, 0, 0, 0, -7}, 5126, "VEC3");
  const auto scene = load(model);
  EXPECT_EQ(scene->nodes[0].instances->matrices.size(), 2u);
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
}

TEST(Instances, MeshesThatThreeDrawsOnceAreDrawnOnce) {
  ModelBuilder lines = instanced();
  lines.doc["meshes"][0]["primitives"][0]["mode"] = 1;
  const auto scene = load(lines);
  EXPECT_FALSE(scene->nodes[0].instances);
  EXPECT_TRUE(hasWarning(*scene, "W_INSTANCING"));
  ModelBuilder none = instanced();
  attributesOf(none) = json::object();
  EXPECT_FALSE(load(none)->nodes[0].instances);
}

TEST(Instances, OfAMorphingMeshMorphToo) {
  ModelBuilder model = instanced();
  const int up = model.accessor(std::vector<float>{0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2}, 5126, "VEC3");
  model.doc["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}};
  model.doc["meshes"][0]["weights"] = {0.5};
  const auto scene = load(model);
  EXPECT_EQ(scene->bounds.max.z, 1);
  EXPECT_TRUE(hasWarning(*scene, "W_INSTANCING"));
}

TEST(Instances, ContradictionsAreRefused) {
  const std::string where = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes/";
  ModelBuilder model = instanced();
  attributesOf(model)["SCALE"] = model.accessor(std::vector<float>(6, 1), 5126, "VEC3");
  EXPECT_EQ(errorOf(model).substr(0, 12), "E_INSTANCING");
  attributesOf(model)["SCALE"] = model.accessor(std::vector<float>(6, 1), 5126, "VEC2");
  EXPECT_EQ(errorOf(model), "E_INSTANCING at " + where + "SCALE");
  attributesOf(model)["SCALE"] = 99;
  EXPECT_EQ(errorOf(model), "E_REF at " + where + "SCALE");
  model.doc["nodes"][0]["extensions"][EXTENSION].erase("attributes");
  EXPECT_EQ(errorOf(model), "E_SCHEMA at /nodes/0/extensions/EXT_mesh_gpu_instancing/attributes");
}

TEST(Instances, LimitsHoldBeforeAnyIsRead) {
  ModelBuilder model = instanced();
  Limits limits;
  limits.instances = 2;
  EXPECT_EQ(errorOf(model, limits), "L_INSTANCES at /nodes/0");
  limits = {};
  limits.triangles = 5;  // two triangles, three times
  EXPECT_EQ(errorOf(model, limits), "L_TRIANGLES at /meshes/0/primitives/0");
  attributesOf(model) = {{"TRANSLATION", model.doc["accessors"].size()}};
  model.doc["accessors"].push_back({{"componentType", 5126}, {"count", 1ull << 50}, {"type", "VEC3"}});
  EXPECT_EQ(errorOf(model), "L_INSTANCES at /nodes/0");
}

TEST(Instances, AreSortedByTheSphereAroundThem) {
  const auto scene = load(instanced());
  const glm::dvec3 center = scene->nodes[0].instances->centers.at(0);
  EXPECT_GT(center.y, 1);
  EXPECT_LT(center.z, -1);
}

}  // namespace
}  // namespace telar::test
