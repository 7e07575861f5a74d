#include "asset/model_builder.h"

namespace telar::test {
namespace {

json describe(const ModelBuilder& model) { return json::parse(describeScene(*load(model))); }

TEST(Describe, CountsAndSizes) {
  ModelBuilder model;
  model.quad();
  model.doc["asset"]["generator"] = "loom \"1\"\n";
  model.doc["asset"]["copyright"] = "CC0";
  model.doc["nodes"][0]["scale"] = {0.5, 0.75, 1};
  const json facts = describe(model);
  EXPECT_EQ(facts["size"], json({0.5, 0.75, 0.0}));
  EXPECT_EQ(facts["bounds"]["max"], json({0.5, 0.75, 0.0}));
  EXPECT_EQ(facts["nodes"], 1);
  EXPECT_EQ(facts["meshes"], 1);
  EXPECT_EQ(facts["drawCalls"], 1);
  EXPECT_EQ(facts["vertices"], 4);
  EXPECT_EQ(facts["triangles"], 2);
  EXPECT_EQ(facts["fileBytes"], model.glb().size());
  EXPECT_EQ(facts["generator"], "loom \"1\"\n");
  EXPECT_EQ(facts["copyright"], "CC0");
  EXPECT_EQ(facts["warnings"], json::array());
}

TEST(Describe, CamerasAreInWorldSpaceAndDegrees) {
  ModelBuilder model;
  model.quad();
  model.doc["cameras"] = {
      {{"type", "perspective"}, {"name", "front"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 20}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 1}, {"znear", 0}, {"zfar", 5}}}},
      {{"type", "perspective"}, {"perspective", {{"yfov", -1}, {"znear", 0.1}}}}};
  const double h = std::sqrt(0.5);
  // a camera at (5, 0.5, 0) that looks along -X at the quad's centre (0.5, 0.5, 0)
  model.doc["nodes"].push_back({{"camera", 0}, {"translation", {5, 0.5, 0}}, {"rotation", {0, h, 0, h}}});
  model.doc["nodes"].push_back({{"camera", 1}, {"name", "flat"}, {"translation", {0, 0, 9}}});
  model.doc["nodes"].push_back({{"camera", 2}});
  model.doc["scenes"][0]["nodes"] = {0, 1, 2, 3};
  const json facts = describe(model);
  ASSERT_EQ(facts["cameras"].size(), 2u);
  const json& front = facts["cameras"][0];
  EXPECT_EQ(front["name"], "front");
  EXPECT_EQ(front["projection"], "perspective");
  EXPECT_NEAR(front["fovY"], 28.64788975654116, 1e-12);
  EXPECT_EQ(front["near"], 0.1);
  EXPECT_EQ(front["far"], 20);
  const double expected[] = {0.5, 0.5, 0}, up[] = {0, 1, 0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(front["target"][i], expected[i], 1e-12);
    EXPECT_NEAR(front["up"][i], up[i], 1e-12);
  }
  EXPECT_EQ(facts["cameras"][1]["name"], "flat");
  EXPECT_EQ(facts["cameras"][1]["height"], 2);
  EXPECT_EQ(facts["cameras"][1]["position"], json({0.0, 0.0, 9.0}));
  EXPECT_TRUE(hasWarning(*load(model), "W_CAMERA"));
}

TEST(Describe, CamerasComeInTheFilesOrder) {
  ModelBuilder model;
  model.quad();
  const json lens = {{"yfov", 1}, {"znear", 1}};
  model.doc["cameras"] = {{{"type", "perspective"}, {"name", "a"}, {"perspective", lens}},
                          {{"type", "perspective"}, {"name", "b"}, {"perspective", lens}}};
  model.doc["nodes"] = {{{"camera", 1}}, {{"mesh", 0}}, {{"camera", 0}}};
  model.doc["scenes"][0]["nodes"] = {0, 1, 2};
  const json cameras = describe(model)["cameras"];
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0]["name"], "a");
  EXPECT_EQ(cameras[0]["node"], 2);
  EXPECT_EQ(cameras[0]["far"], nullptr);
  EXPECT_EQ(cameras[1]["name"], "b");
}

TEST(Describe, LightsOfTheModel) {
  ModelBuilder model;
  model.quad();
  model.doc["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"color", {1, 0.5, 0}},
       {"intensity", 40},
       {"spot", {{"innerConeAngle", 0.9}, {"outerConeAngle", 0.6}}}},
      {{"type", "laser"}}};
  model.doc["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  model.doc["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  model.doc["scenes"][0]["nodes"] = {0, 1};
  const auto scene = load(model);
  ASSERT_EQ(scene->lights.size(), 1u);
  EXPECT_EQ(scene->lights[0].type, LightType::kSpot);
  EXPECT_EQ(scene->lights[0].innerConeAngle, scene->lights[0].outerConeAngle);
  EXPECT_TRUE(hasWarning(*scene, "W_RANGE"));
  EXPECT_TRUE(hasWarning(*scene, "W_LIGHT"));
  EXPECT_EQ(json::parse(describeScene(*scene))["lights"][0]["intensity"], 40);
  model.doc["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 2;
  EXPECT_EQ(errorOf(model), "E_REF at /nodes/0/extensions/KHR_lights_punctual/light");
  Limits limits;
  limits.lights = 0;
  model.doc["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  EXPECT_EQ(errorOf(model, limits), "L_LIGHTS");
}

TEST(Describe, NamesAreCutAtACodePoint) {
  ModelBuilder model;
  model.quad();
  std::string name = "x";
  for (int i = 0; i < 1000; ++i) name += "\xc3\xa9";
  model.doc["materials"] = {{{"name", name}}};
  const json facts = describe(model);  // throws where the text is not UTF-8
  EXPECT_EQ(facts["materials"][0]["name"].get<std::string>(), name.substr(0, 1023));
}

TEST(Warnings, AreAtMostAHundredAndNoTwoAlike) {
  ModelBuilder model;
  model.quad();
  model.doc["materials"] = json::array();
  for (int i = 0; i < 300; ++i) model.doc["materials"].push_back({{"alphaMode", "GLASS"}});
  EXPECT_EQ(load(model)->warnings.size(), 100u);
}

}  // namespace
}  // namespace telar::test
