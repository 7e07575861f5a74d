#include <cmath>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

/// A textured quad with two UV sets and one material, which tests overwrite.
class MaterialTest : public testing::Test {
 protected:
  MaterialTest() {
    json& primitive = model.quad();
    const std::vector<float> uvs = {0, 0, 1, 0, 1, 1, 0, 1};
    primitive["attributes"]["TEXCOORD_0"] = model.accessor(uvs, 5126, "VEC2");
    primitive["attributes"]["TEXCOORD_1"] = model.accessor(uvs, 5126, "VEC2");
    primitive["material"] = 0;
    model.doc["textures"] = {{{"source", model.image()}}};
    model.doc["materials"] = {json::object()};
  }
  json& material() { return model.doc["materials"][0]; }
  json& baseColor() { return material()["pbrMetallicRoughness"]["baseColorTexture"]; }
  Material read() {
    scene = load(model);
    return scene->materials[0];
  }

  ModelBuilder model;
  std::shared_ptr<const Scene> scene;
};

TEST_F(MaterialTest, DefaultsAreThoseOfTheSpecification) {
  const Material m = read();
  EXPECT_EQ(m.baseColorFactor, glm::vec4(1));
  EXPECT_EQ(m.metallicFactor, 1);
  EXPECT_EQ(m.roughnessFactor, 1);
  EXPECT_EQ(m.emissiveFactor, glm::vec3(0));
  EXPECT_EQ(m.alphaMode, AlphaMode::kOpaque);
  EXPECT_EQ(m.alphaCutoff, 0.5f);
  EXPECT_FALSE(m.doubleSided || m.unlit || m.baseColorTexture);
  EXPECT_EQ(scene->images[0].width, 0u);  // no material uses it
}

TEST_F(MaterialTest, ReadsEveryProperty) {
  model.doc["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
  model.doc["textures"][0]["sampler"] = 0;
  material() = json::parse(R"({"name": "wool", "doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.25,
    "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.75,
      "baseColorTexture": {"index": 0, "texCoord": 1}, "metallicRoughnessTexture": {"index": 0}},
    "normalTexture": {"index": 0, "scale": -2}, "occlusionTexture": {"index": 0, "strength": 0.5, "texCoord": 1},
    "emissiveTexture": {"index": 0}, "emissiveFactor": [0.25, 0.5, 1],
    "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}})");
  const Material m = read();
  EXPECT_EQ(m.name, "wool");
  EXPECT_EQ(m.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallicFactor, 0.5f);
  EXPECT_EQ(m.roughnessFactor, 0.75f);
  EXPECT_EQ(m.normalScale, -2);
  EXPECT_EQ(m.occlusionStrength, 0.5f);
  EXPECT_EQ(m.emissiveFactor, glm::vec3(2, 4, 8));
  EXPECT_EQ(m.alphaMode, AlphaMode::kMask);
  EXPECT_EQ(m.alphaCutoff, 0.25f);
  EXPECT_TRUE(m.doubleSided);
  EXPECT_EQ(m.baseColorTexture.texCoord, 1);
  EXPECT_EQ(m.occlusionTexture.texCoord, 1);
  EXPECT_EQ(m.normalTexture.sampler, (Sampler{33071, 33648, 9728, 9985}));
  ASSERT_EQ(scene->images.size(), 1u);
  EXPECT_EQ(scene->images[0].pixels, (ZeroedBytes{255, 0, 0, 255}));
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(MaterialTest, TextureTransformIsThreeJss) {
  baseColor() = {
      {"index", 0},
      {"extensions",
       {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"rotation", 0.3}, {"scale", {2, 5}}, {"texCoord", 1}}}}}};
  const Material m = read();
  EXPECT_TRUE(m.baseColorTexture.hasTransform);
  EXPECT_EQ(m.baseColorTexture.texCoord, 1);
  // three.js: matrix.set(sx c, sy s, tx, -sx s, sy c, ty, 0, 0, 1), rows first
  const double c = std::cos(0.3), s = std::sin(0.3);
  const glm::vec3 uv = m.baseColorTexture.uvTransform * glm::vec3(0.125f, 0.75f, 1);
  EXPECT_NEAR(uv.x, 2 * c * 0.125 + 5 * s * 0.75 + 0.5, 1e-6);
  EXPECT_NEAR(uv.y, -2 * s * 0.125 + 5 * c * 0.75 + 0.25, 1e-6);
  EXPECT_EQ(uv.z, 1);
}

TEST_F(MaterialTest, TextureTransformWithoutValuesIsNone) {
  baseColor() = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}};
  const Material m = read();
  EXPECT_FALSE(m.baseColorTexture.hasTransform);
  EXPECT_EQ(m.baseColorTexture.texCoord, 1);
  EXPECT_EQ(m.baseColorTexture.uvTransform, glm::mat3(1));
}

TEST_F(MaterialTest, UnlitReadsBaseColourOnly) {
  baseColor() = {{"index", 0}};
  material()["normalTexture"] = {{"index", 0}};
  material()["extensions"]["KHR_materials_unlit"] = json::object();
  const Material m = read();
  EXPECT_TRUE(m.unlit && m.baseColorTexture);
  EXPECT_FALSE(m.normalTexture);
}

TEST_F(MaterialTest, CosmeticFaultsAreWarnings) {
  const auto warns = [&](const char* code) {
    read();
    return hasWarning(*scene, code);
  };
  material() = {{"alphaMode", "GLASS"}};
  EXPECT_TRUE(warns("W_ENUM"));
  material() = {{"pbrMetallicRoughness", {{"roughnessFactor", -5}}}};
  EXPECT_TRUE(warns("W_RANGE"));
  EXPECT_EQ(scene->materials[0].roughnessFactor, 0);
  EXPECT_EQ(scene->warnings.back().message, "expected 0 to 1, got -5: 0 is taken");
  material() = {{"pbrMetallicRoughness", {{"roughnessFactor", 1.0000001}}}};
  EXPECT_TRUE(warns("W_RANGE"));
  EXPECT_EQ(scene->warnings.back().message, "expected 0 to 1, got 1.0000001: 1 is taken");
  material() = {{"emissiveFactor", {1e30, 0, 0}}};
  EXPECT_TRUE(warns("W_RANGE"));
  EXPECT_EQ(scene->materials[0].emissiveFactor.x, 1);
  material() = json::object();
  baseColor() = {{"index", 0}, {"texCoord", 2147483648u}};
  EXPECT_TRUE(warns("W_TEXCOORD"));
  EXPECT_FALSE(scene->materials[0].baseColorTexture);
  baseColor() = {{"index", 0}};
  model.doc["samplers"] = {{{"wrapS", 1}}};
  model.doc["textures"][0]["sampler"] = 0;
  EXPECT_TRUE(warns("W_SAMPLER"));
  model.doc["textures"] = {json::object()};
  EXPECT_TRUE(warns("W_TEXTURE"));
}

TEST_F(MaterialTest, WrongTypesAreErrors) {
  material() = {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}};
  EXPECT_EQ(errorOf(model), "E_SCHEMA at /materials/0/pbrMetallicRoughness/baseColorFactor");
  material() = json::object();
  baseColor() = {{"index", 1}};
  EXPECT_EQ(errorOf(model), "E_REF at /materials/0/pbrMetallicRoughness/baseColorTexture/index");
  baseColor() = json::object();
  EXPECT_EQ(errorOf(model), "E_SCHEMA at /materials/0/pbrMetallicRoughness/baseColorTexture/index");
}

TEST_F(MaterialTest, WebpSourceWins) {
  model.doc["images"].push_back({{"uri", "data:image/webp;base64,AAAA"}});
  model.doc["textures"] = {{{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}}};
  baseColor() = {{"index", 0}};
  EXPECT_EQ(errorOf(model), "E_IMAGE_FORMAT at /images/1");
}

TEST_F(MaterialTest, VariantsMapMaterialsAndReachTheirImages) {
  model.doc["materials"] = {json::object(), {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.doc["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "blue"}}, {{"name", "red"}}};
  json& primitive = model.doc["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {1}}}};
  read();
  EXPECT_EQ(scene->variants, (std::vector<std::string>{"blue", "red"}));
  EXPECT_EQ(scene->meshes[0].primitives[0].variantMaterials, (std::map<int, int>{{1, 1}}));
  EXPECT_EQ(scene->images[0].width, 1u);
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {2}}}};
  EXPECT_EQ(errorOf(model), "E_REF at /meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0/variants/0");
}

}  // namespace
}  // namespace telar::test
