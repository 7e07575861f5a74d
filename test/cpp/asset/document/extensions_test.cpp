#include "asset/model_builder.h"

namespace telar::test {
namespace {

std::string warningOf(const Scene& scene, const std::string& code) {
  for (const Warning& warning : scene.warnings) {
    if (warning.code == code) return warning.message;
  }
  return {};
}

bool tells(const std::string& message, const std::string& part) { return message.find(part) != std::string::npos; }

TEST(Extensions, UnknownOptionalOnesWarnByName) {
  ModelBuilder model;
  model.quad();
  model.doc["extensionsUsed"] = {"ACME_glitter"};
  EXPECT_TRUE(tells(warningOf(*load(model), "W_EXT_IGNORED"), "ACME_glitter"));
}

TEST(Extensions, UnknownRequiredOnesAreRefusedByName) {
  for (const char* name : {"ACME_glitter", "KHR_materials_pbrSpecularGlossiness", "EXT_texture_avif"}) {
    ModelBuilder model;
    model.quad();
    model.doc["extensionsUsed"] = {name};
    model.doc["extensionsRequired"] = {name};
    try {
      load(model);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code, "E_EXT_REQUIRED");
      EXPECT_TRUE(tells(error.what(), name));
    }
  }
}

/// The client shows what stands beside the extension, and says nothing.
TEST(Extensions, SpecularGlossinessIsLeftOutWithTheCure) {
  ModelBuilder model;
  model.quad()["material"] = 0;
  model.doc["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
  model.doc["materials"] = {
      {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {1, 0, 0, 1}}}}}}}};
  const auto scene = load(model);
  EXPECT_TRUE(tells(warningOf(*scene, "W_EXT_IGNORED"), "gltf-transform metalrough"));
  EXPECT_EQ(scene->materials.at(0).baseColorFactor, glm::vec4(1));
  EXPECT_EQ(scene->materials.at(0).metallicFactor, 1.0f);
}

/// A quad with a texture; `texture` may name image 0, a PNG, and image 1, which no decoder knows.
ModelBuilder textured(const json& texture) {
  ModelBuilder model;
  model.quad()["material"] = 0;
  model.image();
  model.doc["images"].push_back({{"bufferView", model.view(bytesOf(std::vector<char>{0, 0, 0, 1, 'f', 't', 'y', 'p'}))},
                                 {"mimeType", "image/avif"}});
  model.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.doc["textures"] = {texture};
  model.doc["extensionsUsed"] = {"EXT_texture_avif"};
  return model;
}

TEST(Extensions, AvifGivesWayToItsFallback) {
  const json extension = {{"EXT_texture_avif", {{"source", 1}}}};
  const auto scene = load(textured({{"source", 0}, {"extensions", extension}}));
  EXPECT_EQ(scene->materials.at(0).baseColorTexture.image, 0);
  EXPECT_TRUE(tells(warningOf(*scene, "W_EXT_IGNORED"), "EXT_texture_avif"));
  const auto bare = load(textured({{"extensions", extension}}));
  EXPECT_FALSE(bare->materials.at(0).baseColorTexture);
  EXPECT_TRUE(hasWarning(*bare, "W_TEXTURE"));
}

TEST(Extensions, BasisuIsTakenBeforeWebpAndTheFallback) {
  json texture = {{"source", 0},
                  {"extensions", {{"EXT_texture_webp", {{"source", 0}}}, {"KHR_texture_basisu", {{"source", 1}}}}}};
  EXPECT_EQ(errorOf(textured(texture)), "E_IMAGE_FORMAT at /images/1");
}

TEST(Extensions, BasisuTakesKtx2Alone) {
  EXPECT_EQ(errorOf(textured({{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}})),
            "E_IMAGE_FORMAT at /images/0");
  EXPECT_EQ(errorOf(textured({{"source", 0}})), "");
}

}  // namespace
}  // namespace telar::test
