#include <cmath>

#include "asset/document/fabric_presets.h"
#include "asset/model_builder.h"

namespace telar::test {
namespace {

/// A quad with one texture and one material, which tests overwrite.
class FabricLayersTest : public testing::Test {
 protected:
  FabricLayersTest() {
    json& primitive = model.quad();
    primitive["attributes"]["TEXCOORD_0"] = model.accessor(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 5126, "VEC2");
    primitive["material"] = 0;
    model.doc["textures"] = {{{"source", model.image()}}};
  }
  Material read(const json& material) {
    model.doc["materials"] = json::array({material});
    scene = load(model);
    return scene->materials[0];
  }
  /// The material as the shading "fabric" takes it.
  Material filled(const json& material) {
    const Material plain = read(material);
    EXPECT_EQ(scene->fileMaterials, 1u);
    EXPECT_EQ(scene->materials.size(), 2u);
    EXPECT_EQ(plain.withPreset, 1);
    return scene->materials.at(1);
  }
  std::string errorWith(const std::string& material) {
    model.doc["materials"] = json::array({json::parse(material)});
    return errorOf(model);
  }
  static json fabric(const json& value) { return {{"extensions", {{"TELAR_materials_fabric", value}}}}; }

  ModelBuilder model;
  std::shared_ptr<const Scene> scene;
};

TEST_F(FabricLayersTest, DefaultsChangeNothing) {
  for (const char* text :
       {"{}", R"({"extensions": {"KHR_materials_diffuse_transmission": {}, "TELAR_materials_fabric": {}}})"}) {
    const Material m = read(json::parse(text));
    EXPECT_FALSE(m.physical);
    EXPECT_EQ(m.withPreset, -1);
    EXPECT_EQ(m.fabric.diffuseTransmissionFactor, 0);
    EXPECT_EQ(m.fabric.diffuseTransmissionColorFactor, glm::vec3(1));
    EXPECT_EQ(m.fabric.flatness, 0);
    EXPECT_FALSE(m.fabric.weave || m.fabric.back);
    EXPECT_TRUE(scene->warnings.empty());
  }
}

TEST_F(FabricLayersTest, ReadsDiffuseTransmission) {
  const Material m = read(json::parse(R"({"extensions": {"KHR_materials_diffuse_transmission": {
    "diffuseTransmissionFactor": 0.25, "diffuseTransmissionTexture": {"index": 0},
    "diffuseTransmissionColorFactor": [0.5, 0.25, 1], "diffuseTransmissionColorTexture": {"index": 0}}}})"));
  EXPECT_EQ(m.fabric.diffuseTransmissionFactor, 0.25f);
  EXPECT_EQ(m.fabric.diffuseTransmissionColorFactor, glm::vec3(0.5f, 0.25f, 1));
  EXPECT_TRUE(m.fabric.diffuseTransmissionTexture && m.fabric.diffuseTransmissionColorTexture);
  EXPECT_EQ(scene->images[0].width, 1u);
}

TEST_F(FabricLayersTest, TexturesOfAFactorOfZeroAreNotRead) {
  const Material m = read(json::parse(R"({"extensions": {"KHR_materials_diffuse_transmission": {
    "diffuseTransmissionTexture": {"index": 0}}}})"));
  EXPECT_FALSE(m.fabric.diffuseTransmissionTexture);
  EXPECT_EQ(scene->images[0].width, 0u);
}

TEST_F(FabricLayersTest, ReadsWeaveAndBack) {
  const FabricLayers f = read(fabric(json::parse(R"({"flatness": 0.5,
    "weave": {"threadsPerUv": [40, 30], "weaveTexture": {"index": 0}, "weft": {"coverage": 0.25},
      "warp": {"coverage": 0.5, "roughnessFactor": 0.125, "anisotropyStrength": 0.75, "specularColorFactor": [1, 0, 0.5]}},
    "back": {"baseColorFactor": [0, 0.5, 1], "baseColorTexture": {"index": 0}, "roughnessFactor": 0.25}})")))
                             .fabric;
  EXPECT_EQ(f.flatness, 0.5f);
  EXPECT_TRUE(f.weave && f.back && f.weaveTexture && f.backColorTexture);
  EXPECT_EQ(f.threadsPerUv, glm::vec2(40, 30));
  EXPECT_EQ(f.warp.coverage, 0.5f);
  EXPECT_EQ(f.warp.roughnessFactor, 0.125f);
  EXPECT_EQ(f.warp.anisotropyStrength, 0.75f);
  EXPECT_EQ(f.warp.specularColorFactor, glm::vec3(1, 0, 0.5f));
  EXPECT_EQ(f.weft.coverage, 0.25f);
  EXPECT_EQ(f.weft.roughnessFactor, 0.5f);
  EXPECT_EQ(f.backColorFactor, glm::vec3(0, 0.5f, 1));
  EXPECT_EQ(f.backRoughnessFactor, 0.25f);
}

TEST_F(FabricLayersTest, ABackLooksLikeTheFrontWhereItDoesNotSay) {
  json material = fabric({{"back", {{"roughnessFactor", 0.5}}}});
  material["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0.5, 0.25, 0, 1}}, {"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.75}};
  const FabricLayers same = read(material).fabric;
  EXPECT_EQ(same.backColorFactor, glm::vec3(0.5f, 0.25f, 0));
  EXPECT_TRUE(same.backColorTexture);
  EXPECT_EQ(same.backRoughnessFactor, 0.5f);
  material["extensions"]["TELAR_materials_fabric"]["back"] = {{"baseColorFactor", {1, 1, 0}}};
  const FabricLayers own = read(material).fabric;
  EXPECT_EQ(own.backColorFactor, glm::vec3(1, 1, 0));
  EXPECT_FALSE(own.backColorTexture);
  EXPECT_EQ(own.backRoughnessFactor, 0.75f);
}

TEST_F(FabricLayersTest, ValuesAreKeptInRangeWithAWarning) {
  const FabricLayers f = read(fabric(json::parse(R"({"flatness": 7, "weave": {"threadsPerUv": [-1, 1e300],
    "warp": {"coverage": 1, "roughnessFactor": -1}, "weft": {"coverage": 1}}})")))
                             .fabric;
  EXPECT_EQ(f.flatness, 1);
  EXPECT_EQ(f.threadsPerUv, glm::vec2(0, 1e6f));
  EXPECT_EQ(f.warp.roughnessFactor, 0);
  EXPECT_EQ(f.warp.coverage + f.weft.coverage, 1);
  EXPECT_TRUE(hasWarning(*scene, "W_RANGE"));
}

TEST_F(FabricLayersTest, ExtrasAreReadWhereThereIsNoExtension) {
  json material = {{"extras", {{"TELAR_materials_fabric", {{"flatness", 0.25}}}, {"mine", {1, 2}}}}};
  EXPECT_EQ(read(material).fabric.flatness, 0.25f);
  material["extensions"]["TELAR_materials_fabric"] = {{"weave", json::object()}};
  const FabricLayers f = read(material).fabric;
  EXPECT_EQ(f.flatness, 0);  // the extension stands for all of it
  EXPECT_TRUE(f.weave);
  EXPECT_EQ(f.warp.coverage, 0.5f);
}

TEST_F(FabricLayersTest, WarningsPointToWhereItStands) {
  read({{"extras", {{"TELAR_materials_fabric", {{"flatness", 2}}}}}});
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].pointer, "/materials/0/extras/TELAR_materials_fabric/flatness");
}

TEST_F(FabricLayersTest, ExtrasOfOthersMayBeAnything) {
  for (const char* text : {"null", "[1]", "\"denim\"", "7", R"({"telar": 1})"}) {
    EXPECT_EQ(errorWith(std::string(R"({"extras": )") + text + "}"), "") << text;
  }
}

TEST_F(FabricLayersTest, MalformedValuesAreErrors) {
  const std::string at = " at /materials/0/extensions/TELAR_materials_fabric";
  const auto error = [&](const char* value) {
    return errorWith(std::string(R"({"extensions": {"TELAR_materials_fabric": )") + value + "}}");
  };
  EXPECT_EQ(error("1"), "E_SCHEMA" + at);
  EXPECT_EQ(error(R"({"preset": 1})"), "E_SCHEMA" + at + "/preset");
  EXPECT_EQ(error(R"({"weave": []})"), "E_SCHEMA" + at + "/weave");
  EXPECT_EQ(error(R"({"weave": {"threadsPerUv": [1]}})"), "E_SCHEMA" + at + "/weave/threadsPerUv");
  EXPECT_EQ(error(R"({"weave": {"weaveTexture": {"index": 5}}})"), "E_REF" + at + "/weave/weaveTexture/index");
  EXPECT_EQ(error(R"({"back": {"baseColorFactor": [1, 1, 1, 1]}})"), "E_SCHEMA" + at + "/back/baseColorFactor");
  EXPECT_EQ(errorWith(R"({"extras": {"TELAR_materials_fabric": []}})"),
            "E_SCHEMA at /materials/0/extras/TELAR_materials_fabric");
}

TEST_F(FabricLayersTest, UnlitMaterialsHaveNone) {
  json material = fabric({{"weave", {{"weaveTexture", {{"index", 0}}}}}});
  material["extensions"]["KHR_materials_unlit"] = json::object();
  EXPECT_FALSE(read(material).fabric.weave);
}

TEST_F(FabricLayersTest, APresetFillsWhatTheMaterialLeavesOut) {
  json material = fabric({{"preset", "velvet"}});
  material["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5}, {"baseColorFactor", {0.5, 0, 0, 1}}};
  material["extensions"]["KHR_materials_sheen"] = {{"sheenRoughnessFactor", 0.125}};
  const Material cloth = filled(material);
  EXPECT_EQ(cloth.roughnessFactor, 0.5f);                // its own
  EXPECT_EQ(cloth.layers.sheenRoughnessFactor, 0.125f);  // its own, within an object of both
  EXPECT_EQ(cloth.metallicFactor, 0);
  // Red velvet has no white rim: the preset's sheen by the root of the colour, which has a floor.
  EXPECT_NEAR(cloth.layers.sheenColorFactor.x, std::sqrt(0.5f), 1e-6f);
  EXPECT_NEAR(cloth.layers.sheenColorFactor.y, std::sqrt(0.001f), 1e-6f);
  EXPECT_EQ(cloth.baseColorFactor, glm::vec4(0.5f, 0, 0, 1));
  const Material& plain = scene->materials[0];
  EXPECT_EQ(plain.metallicFactor, 1);
  EXPECT_EQ(plain.layers.sheenColorFactor, glm::vec3(0));
}

TEST_F(FabricLayersTest, ASheenOfTheFilesOwnKeepsItsColour) {
  json material = fabric({{"preset", "velvet"}});
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0, 0, 1}}};
  material["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {0.25, 0.5, 1}}};
  EXPECT_EQ(filled(material).layers.sheenColorFactor, glm::vec3(0.25f, 0.5f, 1));
}

TEST_F(FabricLayersTest, EveryPresetIsRead) {
  const json presets = json::parse(asset::fabricPresetText());
  for (const auto& item : presets.items()) {
    const std::string& name = item.key();
    const Material cloth = filled(fabric({{"preset", name}}));
    EXPECT_TRUE(scene->warnings.empty()) << name;
    EXPECT_EQ(cloth.metallicFactor, name == "sequin-thread" ? 1 : 0) << name;
    if (cloth.fabric.weave) {
      EXPECT_LE(cloth.fabric.warp.coverage + cloth.fabric.weft.coverage, 1) << name;
    }
  }
}

TEST_F(FabricLayersTest, AnUnknownPresetWarnsAndNamesThem) {
  read({{"extras", {{"TELAR_materials_fabric", {{"preset", "chain-mail"}}}}}});
  EXPECT_EQ(scene->materials.size(), 1u);
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].code, "W_ENUM");
  EXPECT_EQ(scene->warnings[0].pointer, "/materials/0/extras/TELAR_materials_fabric/preset");
  EXPECT_NE(scene->warnings[0].message.find("denim"), std::string::npos);
}

TEST_F(FabricLayersTest, APresetsFaultsAreTheMaterialsAndWarnOnce) {
  json material = fabric({{"preset", "denim"}, {"flatness", 3}});
  filled(material);
  EXPECT_EQ(scene->warnings.size(), 1u);
}

TEST_F(FabricLayersTest, InspectionTellsWhatAClothHas) {
  read(fabric({{"preset", "denim"}}));
  const json facts = json::parse(describeScene(*scene));
  ASSERT_EQ(facts["materials"].size(), 1u);
  const json& cloth = facts["materials"][0]["fabric"];
  EXPECT_EQ(cloth["back"], true);
  EXPECT_GT(cloth["weave"]["warp"], cloth["weave"]["weft"]);
  read(json::object());
  EXPECT_TRUE(json::parse(describeScene(*scene))["materials"][0]["fabric"].is_null());
}

TEST_F(FabricLayersTest, PrimitivesAndVariantsCannotReachTheFilledCopies) {
  json material = fabric({{"preset", "denim"}});
  model.doc["meshes"][0]["primitives"][0]["material"] = 1;
  model.doc["materials"] = json::array({material});
  EXPECT_EQ(errorOf(model), "E_REF at /meshes/0/primitives/0/material");
}

TEST_F(FabricLayersTest, BothExtensionsMayBeRequired) {
  model.doc["extensionsUsed"] =
      model.doc["extensionsRequired"] = {"KHR_materials_diffuse_transmission", "TELAR_materials_fabric"};
  read(json::object());
  EXPECT_TRUE(scene->warnings.empty());
}

}  // namespace
}  // namespace telar::test
