#include <cmath>
#include <numbers>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

/// A quad with two UV sets, one texture, and one material, which tests overwrite.
class PhysicalLayersTest : public testing::Test {
 protected:
  PhysicalLayersTest() {
    json& primitive = model.quad();
    const std::vector<float> uvs = {0, 0, 1, 0, 1, 1, 0, 1};
    primitive["attributes"]["TEXCOORD_0"] = model.accessor(uvs, 5126, "VEC2");
    primitive["attributes"]["TEXCOORD_1"] = model.accessor(uvs, 5126, "VEC2");
    primitive["material"] = 0;
    model.doc["textures"] = {{{"source", model.image()}}};
  }
  json& extensions() { return model.doc["materials"][0]["extensions"]; }
  Material read(const std::string& text) {
    model.doc["materials"] = json::array({json::object()});
    extensions() = json::parse(text);
    scene = load(model);
    return scene->materials[0];
  }
  std::string errorWith(const std::string& text) {
    model.doc["materials"] = json::array({json::object()});
    extensions() = json::parse(text);
    return errorOf(model);
  }

  ModelBuilder model;
  std::shared_ptr<const Scene> scene;
};

TEST_F(PhysicalLayersTest, DefaultsAreThoseOfGltfLoader) {
  const Material plain = read("{}");
  EXPECT_FALSE(plain.physical);
  const PhysicalLayers l =
      read(R"({"KHR_materials_ior": {}, "KHR_materials_specular": {}, "KHR_materials_clearcoat": {},
    "KHR_materials_sheen": {}, "KHR_materials_anisotropy": {}, "KHR_materials_iridescence": {},
    "KHR_materials_diffuse_roughness": {}, "KHR_materials_transmission": {}, "KHR_materials_volume": {},
    "KHR_materials_dispersion": {}})")
          .layers;
  EXPECT_TRUE(scene->materials[0].physical);
  EXPECT_EQ(l.ior, 1.5f);
  EXPECT_EQ(l.specularFactor, 1);
  EXPECT_EQ(l.specularColorFactor, glm::vec3(1));
  EXPECT_EQ(l.clearcoatFactor, 0);
  EXPECT_EQ(l.clearcoatRoughnessFactor, 0);
  EXPECT_EQ(l.clearcoatNormalScale, 1);
  EXPECT_EQ(l.sheenColorFactor, glm::vec3(0));
  EXPECT_EQ(l.sheenRoughnessFactor, 0);
  EXPECT_EQ(l.anisotropyStrength, 0);
  EXPECT_EQ(l.anisotropyRotation, 0);
  EXPECT_EQ(l.iridescenceFactor, 0);
  EXPECT_EQ(l.iridescenceIor, 1.3f);
  EXPECT_EQ(l.iridescenceThicknessMinimum, 100);
  EXPECT_EQ(l.iridescenceThicknessMaximum, 400);
  EXPECT_EQ(l.diffuseRoughnessFactor, 0);
  EXPECT_EQ(l.transmissionFactor, 0);
  EXPECT_EQ(l.thicknessFactor, 0);
  EXPECT_TRUE(std::isinf(l.attenuationDistance));
  EXPECT_EQ(l.attenuationColor, glm::vec3(1));
  EXPECT_EQ(l.dispersion, 0);
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(PhysicalLayersTest, ReadsEveryFactor) {
  const PhysicalLayers l = read(R"({"KHR_materials_ior": {"ior": 1.75},
    "KHR_materials_specular": {"specularFactor": 0.25, "specularColorFactor": [0.5, 1, 4]},
    "KHR_materials_clearcoat": {"clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.125},
    "KHR_materials_sheen": {"sheenColorFactor": [0.25, 0.5, 0.75], "sheenRoughnessFactor": 0.375},
    "KHR_materials_anisotropy": {"anisotropyStrength": 0.625, "anisotropyRotation": -1.5},
    "KHR_materials_iridescence": {"iridescenceFactor": 0.875, "iridescenceIor": 2, "iridescenceThicknessMinimum": 700,
      "iridescenceThicknessMaximum": 50},
    "KHR_materials_diffuse_roughness": {"diffuseRoughnessFactor": 0.0625},
    "KHR_materials_transmission": {"transmissionFactor": 0.6875},
    "KHR_materials_volume": {"thicknessFactor": 2.5, "attenuationDistance": 0.03125, "attenuationColor": [0, 0.5, 1]},
    "KHR_materials_dispersion": {"dispersion": 1.5}})")
                               .layers;
  EXPECT_EQ(l.ior, 1.75f);
  EXPECT_EQ(l.specularFactor, 0.25f);
  EXPECT_EQ(l.specularColorFactor, glm::vec3(0.5f, 1, 4));
  EXPECT_EQ(l.clearcoatFactor, 0.5f);
  EXPECT_EQ(l.clearcoatRoughnessFactor, 0.125f);
  EXPECT_EQ(l.sheenColorFactor, glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(l.sheenRoughnessFactor, 0.375f);
  EXPECT_EQ(l.anisotropyStrength, 0.625f);
  EXPECT_EQ(l.anisotropyRotation, -1.5f);
  EXPECT_EQ(l.iridescenceFactor, 0.875f);
  EXPECT_EQ(l.iridescenceIor, 2);
  EXPECT_EQ(l.iridescenceThicknessMinimum, 700);  // above the maximum is allowed
  EXPECT_EQ(l.iridescenceThicknessMaximum, 50);
  EXPECT_EQ(l.diffuseRoughnessFactor, 0.0625f);
  EXPECT_EQ(l.transmissionFactor, 0.6875f);
  EXPECT_EQ(l.thicknessFactor, 2.5f);
  EXPECT_EQ(l.attenuationDistance, 0.03125f);
  EXPECT_EQ(l.attenuationColor, glm::vec3(0, 0.5f, 1));
  EXPECT_EQ(l.dispersion, 1.5f);
  EXPECT_TRUE(scene->warnings.empty());
}

struct TextureSlot {
  const char* extension;
  const char* on;  ///< a member that switches the layer on; empty = it is always read
  const char* key;
  TextureRef PhysicalLayers::*member;
};

constexpr TextureSlot SLOTS[] = {
    {"KHR_materials_specular", "", "specularTexture", &PhysicalLayers::specularTexture},
    {"KHR_materials_specular", "", "specularColorTexture", &PhysicalLayers::specularColorTexture},
    {"KHR_materials_clearcoat", "clearcoatFactor", "clearcoatTexture", &PhysicalLayers::clearcoatTexture},
    {"KHR_materials_clearcoat", "clearcoatFactor", "clearcoatRoughnessTexture",
     &PhysicalLayers::clearcoatRoughnessTexture},
    {"KHR_materials_clearcoat", "clearcoatFactor", "clearcoatNormalTexture", &PhysicalLayers::clearcoatNormalTexture},
    {"KHR_materials_sheen", "", "sheenColorTexture", &PhysicalLayers::sheenColorTexture},
    {"KHR_materials_sheen", "", "sheenRoughnessTexture", &PhysicalLayers::sheenRoughnessTexture},
    {"KHR_materials_anisotropy", "anisotropyStrength", "anisotropyTexture", &PhysicalLayers::anisotropyTexture},
    {"KHR_materials_iridescence", "iridescenceFactor", "iridescenceTexture", &PhysicalLayers::iridescenceTexture},
    {"KHR_materials_iridescence", "iridescenceFactor", "iridescenceThicknessTexture",
     &PhysicalLayers::iridescenceThicknessTexture},
    {"KHR_materials_diffuse_roughness", "diffuseRoughnessFactor", "diffuseRoughnessTexture",
     &PhysicalLayers::diffuseRoughnessTexture},
    {"KHR_materials_transmission", "transmissionFactor", "transmissionTexture", &PhysicalLayers::transmissionTexture},
};

TEST_F(PhysicalLayersTest, EachTextureIsReadDecodedAndTransformed) {
  for (const TextureSlot& slot : SLOTS) {
    SCOPED_TRACE(slot.key);
    json layer = {{slot.key,
                   {{"index", 0},
                    {"texCoord", 0},
                    {"scale", -2},
                    {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"texCoord", 1}}}}}}}};
    if (*slot.on) layer[slot.on] = 1;
    const TextureRef texture = read(json{{slot.extension, layer}}.dump()).layers.*slot.member;
    EXPECT_EQ(texture.image, 0);
    EXPECT_EQ(texture.texCoord, 1);
    EXPECT_TRUE(texture.hasTransform);
    EXPECT_EQ(texture.uvTransform[2], glm::vec3(0.5f, 0.25f, 1));
    EXPECT_EQ(scene->images[0].width, 1u);
    EXPECT_TRUE(scene->warnings.empty());
    layer[slot.key] = {{"index", 0}};
    const TextureRef plain = read(json{{slot.extension, layer}}.dump()).layers.*slot.member;
    EXPECT_EQ(plain.texCoord, 0);
    EXPECT_FALSE(plain.hasTransform);
  }
  const char* coat = R"({"KHR_materials_clearcoat": {"clearcoatFactor": 1,
    "clearcoatNormalTexture": {"index": 0, "scale": -2}}})";
  EXPECT_EQ(read(coat).layers.clearcoatNormalScale, -2);
}

TEST_F(PhysicalLayersTest, TexturesOfALayerWithFactor0AreNotDecoded) {
  for (const TextureSlot& slot : SLOTS) {
    if (!*slot.on) continue;
    SCOPED_TRACE(slot.key);
    EXPECT_FALSE(read(json{{slot.extension, {{slot.key, {{"index", 0}}}}}}.dump()).layers.*slot.member);
    EXPECT_EQ(scene->images[0].width, 0u);
    EXPECT_TRUE(scene->materials[0].physical);
  }
}

TEST_F(PhysicalLayersTest, Ior0ReflectsAll) {
  EXPECT_EQ(read(R"({"KHR_materials_ior": {"ior": 0}})").layers.ior, 1000);
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(PhysicalLayersTest, ThicknessIsReadWhereLightComesThrough) {
  const auto thickness = [&](double transmission, double factor) {
    const json volume = {{"thicknessFactor", factor}, {"thicknessTexture", {{"index", 0}, {"texCoord", 1}}}};
    const json both = {{"KHR_materials_transmission", {{"transmissionFactor", transmission}}},
                       {"KHR_materials_volume", volume}};
    return read(both.dump()).layers.thicknessTexture;
  };
  EXPECT_EQ(thickness(0.5, 2).texCoord, 1);
  EXPECT_EQ(scene->images[0].width, 1u);
  EXPECT_FALSE(thickness(0, 2));
  EXPECT_FALSE(thickness(1, 0));
  EXPECT_EQ(scene->images[0].width, 0u);
}

TEST_F(PhysicalLayersTest, AttenuationDistance0IsNone) {
  EXPECT_TRUE(std::isinf(read(R"({"KHR_materials_volume": {"attenuationDistance": 0}})").layers.attenuationDistance));
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(PhysicalLayersTest, RotationIsKeptWithinATurn) {
  const double angle = 1000 * 2 * std::numbers::pi + 0.5;
  const json anisotropy = {{"KHR_materials_anisotropy", {{"anisotropyStrength", 1}, {"anisotropyRotation", angle}}}};
  EXPECT_NEAR(read(anisotropy.dump()).layers.anisotropyRotation, 0.5f, 1e-6);
  const float huge = read(R"({"KHR_materials_anisotropy": {"anisotropyRotation": 1e300}})").layers.anisotropyRotation;
  EXPECT_LE(std::abs(huge), 3.1415927f);
}

TEST_F(PhysicalLayersTest, EachExtensionOfGltfLoadersMakesItPhysical) {
  for (const char* name :
       {"KHR_materials_anisotropy", "KHR_materials_clearcoat", "KHR_materials_diffuse_roughness",
        "KHR_materials_dispersion", "KHR_materials_ior", "KHR_materials_iridescence", "KHR_materials_sheen",
        "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_volume", "EXT_materials_bump"}) {
    EXPECT_TRUE(read(json{{name, json::object()}}.dump()).physical) << name;
    EXPECT_FALSE(read(json{{name, json::object()}, {"KHR_materials_unlit", json::object()}}.dump()).physical) << name;
  }
  EXPECT_FALSE(read(R"({"KHR_materials_emissive_strength": {}, "ACME_paint": {}})").physical);
}

TEST_F(PhysicalLayersTest, SupportedExtensionsMayBeRequiredAndDoNotWarn) {
  const json names = {"KHR_materials_anisotropy",  "KHR_materials_clearcoat", "KHR_materials_diffuse_roughness",
                      "KHR_materials_dispersion",  "KHR_materials_ior",       "KHR_materials_iridescence",
                      "KHR_materials_sheen",       "KHR_materials_specular",  "KHR_materials_volume",
                      "KHR_materials_transmission"};
  model.doc["extensionsUsed"] = model.doc["extensionsRequired"] = names;
  read("{}");
  EXPECT_TRUE(scene->warnings.empty());
  model.doc["extensionsRequired"].push_back("ACME_glitter");
  EXPECT_EQ(errorOf(model), "E_EXT_REQUIRED at /extensionsRequired/10");
}

struct Clamped {
  const char* text;
  float PhysicalLayers::*member;
  float value;
};

class PhysicalRange : public PhysicalLayersTest, public testing::WithParamInterface<Clamped> {};

TEST_P(PhysicalRange, IsKeptWithAWarning) {
  EXPECT_EQ(read(GetParam().text).layers.*GetParam().member, GetParam().value);
  EXPECT_TRUE(hasWarning(*scene, "W_RANGE"));
}

using L = PhysicalLayers;
INSTANTIATE_TEST_SUITE_P(
    Table, PhysicalRange,
    testing::Values(
        Clamped{R"({"KHR_materials_ior": {"ior": -1}})", &L::ior, 1},
        Clamped{R"({"KHR_materials_ior": {"ior": 1e300}})", &L::ior, 1000},
        Clamped{R"({"KHR_materials_specular": {"specularFactor": 2}})", &L::specularFactor, 1},
        Clamped{R"({"KHR_materials_clearcoat": {"clearcoatFactor": -1}})", &L::clearcoatFactor, 0},
        Clamped{R"({"KHR_materials_clearcoat": {"clearcoatRoughnessFactor": 1e308}})", &L::clearcoatRoughnessFactor, 1},
        Clamped{R"({"KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0, "scale": 1e300}}})",
                &L::clearcoatNormalScale, 1e4f},
        Clamped{R"({"KHR_materials_sheen": {"sheenRoughnessFactor": 1.5}})", &L::sheenRoughnessFactor, 1},
        Clamped{R"({"KHR_materials_anisotropy": {"anisotropyStrength": 7}})", &L::anisotropyStrength, 1},
        Clamped{R"({"KHR_materials_iridescence": {"iridescenceFactor": 1.01}})", &L::iridescenceFactor, 1},
        Clamped{R"({"KHR_materials_iridescence": {"iridescenceIor": 0}})", &L::iridescenceIor, 1},
        Clamped{R"({"KHR_materials_iridescence": {"iridescenceThicknessMinimum": -5}})",
                &L::iridescenceThicknessMinimum, 0},
        Clamped{R"({"KHR_materials_iridescence": {"iridescenceThicknessMaximum": 1e300}})",
                &L::iridescenceThicknessMaximum, 1e6f},
        Clamped{R"({"KHR_materials_diffuse_roughness": {"diffuseRoughnessFactor": -0.5}})", &L::diffuseRoughnessFactor,
                0},
        Clamped{R"({"KHR_materials_transmission": {"transmissionFactor": 9}})", &L::transmissionFactor, 1},
        Clamped{R"({"KHR_materials_volume": {"thicknessFactor": -1}})", &L::thicknessFactor, 0},
        Clamped{R"({"KHR_materials_volume": {"thicknessFactor": 1e300}})", &L::thicknessFactor, 1e12f},
        Clamped{R"({"KHR_materials_volume": {"attenuationDistance": -1}})", &L::attenuationDistance, 1e-12f},
        Clamped{R"({"KHR_materials_volume": {"attenuationDistance": 1e-300}})", &L::attenuationDistance, 1e-12f},
        Clamped{R"({"KHR_materials_volume": {"attenuationDistance": 1e300}})", &L::attenuationDistance, 1e12f},
        Clamped{R"({"KHR_materials_dispersion": {"dispersion": -1}})", &L::dispersion, 0},
        Clamped{R"({"KHR_materials_dispersion": {"dispersion": 1e300}})", &L::dispersion, 40}));

TEST_F(PhysicalLayersTest, ColoursAreKeptInRange) {
  const char* text = R"({"KHR_materials_sheen": {"sheenColorFactor": [-1, 0.5, 1e300]},
    "KHR_materials_specular": {"specularColorFactor": [-1, 3, 1e300]},
    "KHR_materials_volume": {"attenuationColor": [-1, 0.5, 1e300]}})";
  const PhysicalLayers l = read(text).layers;
  EXPECT_EQ(l.sheenColorFactor, glm::vec3(0, 0.5f, 1));
  EXPECT_EQ(l.specularColorFactor, glm::vec3(0, 3, 65504));
  EXPECT_EQ(l.attenuationColor, glm::vec3(0, 0.5f, 1));
  EXPECT_TRUE(hasWarning(*scene, "W_RANGE"));
}

TEST_F(PhysicalLayersTest, FaultsNameTheirPlace) {
  const std::string at = "/materials/0/extensions/";
  EXPECT_EQ(errorWith(R"({"KHR_materials_sheen": []})"), "E_SCHEMA at " + at + "KHR_materials_sheen");
  EXPECT_EQ(errorWith(R"({"KHR_materials_ior": null})"), "E_SCHEMA at " + at + "KHR_materials_ior");
  EXPECT_EQ(errorWith(R"({"KHR_materials_ior": {"ior": "1.5"}})"), "E_SCHEMA at " + at + "KHR_materials_ior/ior");
  EXPECT_EQ(errorWith(R"({"KHR_materials_sheen": {"sheenColorFactor": [1, 1]}})"),
            "E_SCHEMA at " + at + "KHR_materials_sheen/sheenColorFactor");
  EXPECT_EQ(errorWith(R"({"KHR_materials_specular": {"specularColorFactor": [1, null, 1]}})"),
            "E_SCHEMA at " + at + "KHR_materials_specular/specularColorFactor/1");
  EXPECT_EQ(errorWith(R"({"KHR_materials_volume": {"attenuationColor": [1, 1]}})"),
            "E_SCHEMA at " + at + "KHR_materials_volume/attenuationColor");
  EXPECT_EQ(errorWith(R"({"KHR_materials_volume": {"thicknessTexture": {"index": 7}}})"),
            "E_REF at " + at + "KHR_materials_volume/thicknessTexture/index");
  EXPECT_EQ(errorWith(R"({"KHR_materials_dispersion": {"dispersion": []}})"),
            "E_SCHEMA at " + at + "KHR_materials_dispersion/dispersion");
  for (const TextureSlot& slot : SLOTS) {
    const std::string place = at + slot.extension + "/" + slot.key;
    const auto with = [&](const json& info) { return errorWith(json{{slot.extension, {{slot.key, info}}}}.dump()); };
    EXPECT_EQ(with({{"index", 1}}), "E_REF at " + place + "/index");
    EXPECT_EQ(with({{"index", -1}}), "E_SCHEMA at " + place + "/index");
    EXPECT_EQ(with(json::object()), "E_SCHEMA at " + place + "/index");
    EXPECT_EQ(with(0), "E_SCHEMA at " + place);
  }
}

TEST_F(PhysicalLayersTest, TexturesThatCannotBeDrawnAreWarnings) {
  EXPECT_FALSE(
      read(R"({"KHR_materials_sheen": {"sheenColorTexture": {"index": 0, "texCoord": 2}}})").layers.sheenColorTexture);
  EXPECT_TRUE(hasWarning(*scene, "W_TEXCOORD"));
  model.doc["textures"] = {json::object()};
  EXPECT_FALSE(read(R"({"KHR_materials_sheen": {"sheenColorTexture": {"index": 0}}})").layers.sheenColorTexture);
  EXPECT_TRUE(hasWarning(*scene, "W_TEXTURE"));
}

TEST_F(PhysicalLayersTest, UnlitReadsNoLayer) {
  const Material m = read(R"({"KHR_materials_unlit": {},
    "KHR_materials_sheen": {"sheenColorFactor": [1, 1, 1], "sheenColorTexture": {"index": 0}}})");
  EXPECT_EQ(m.layers.sheenColorFactor, glm::vec3(0));
  EXPECT_FALSE(m.layers.sheenColorTexture);
  EXPECT_EQ(scene->images[0].width, 0u);
}

}  // namespace
}  // namespace telar::test
