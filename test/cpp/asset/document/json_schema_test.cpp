#include "asset/model_builder.h"

namespace telar::test {
namespace {

Bytes text(const std::string& jsonText) {
  const auto* bytes = reinterpret_cast<const std::byte*>(jsonText.data());
  return {bytes, bytes + jsonText.size()};
}

TEST(Json, SyntaxFaultsGiveTheirByteOffset) {
  try {
    load(text(R"({"asset":{"version":"2.0"},})"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "E_JSON");
    EXPECT_EQ(error.offset, 27u);  // the brace after the comma
  }
  EXPECT_EQ(errorOf(text("[]")), "E_JSON");
  EXPECT_EQ(errorOf(text("{} x")), "E_JSON");
  EXPECT_EQ(errorOf(text("/* c */ {}")), "E_JSON");
  EXPECT_EQ(errorOf(text("{\"a\": NaN}")), "E_JSON");
  EXPECT_EQ(errorOf(text("{\"a\": \"\xff\"}")), "E_JSON");
  EXPECT_EQ(errorOf(text(std::string(300, ' ') + "{}" + std::string(2, '\0'))), "E_JSON");
}

TEST(Json, DepthAndValuesAreLimitedBeforeTheyCost) {
  const std::string deep = "{\"a\":" + std::string(2'000'000, '[');
  EXPECT_EQ(errorOf(text(deep)), "L_JSON_DEPTH");
  std::string wide = "{\"a\":[0";
  for (int i = 0; i < 500'000; ++i) wide += ",0";
  EXPECT_EQ(errorOf(text(wide + "]}")), "L_JSON_VALUES");
  Limits limits;
  limits.jsonBytes = 10;
  EXPECT_EQ(errorOf(text("{\"asset\":{}}"), limits), "L_JSON_BYTES");
}

TEST(Json, NumbersBeyondDoubleNameTheirPlace) {
  EXPECT_EQ(errorOf(text(R"({"nodes":[{},{"scale":[1,1e400,1]}]})")), "E_SCHEMA at /nodes/1/scale/1");
}

TEST(Json, OddKeysAreHarmless) {
  ModelBuilder model;
  model.quad()["attributes"]["__proto__"] = 0;
  model.doc["__proto__"] = {{"polluted", true}};
  model.doc["extras"] = json::array({1, nullptr, {{"a", "b"}}});
  EXPECT_EQ(errorOf(model), "");
}

TEST(Json, OfEqualKeysTheLastCounts) {
  const std::string document = R"({"asset":{"version":"1.0"},"asset":{"version":"2.0"}})";
  EXPECT_EQ(errorOf(text(document)), "E_NO_GEOMETRY");
}

TEST(Schema, VersionComesFirst) {
  EXPECT_EQ(errorOf(text("{}")), "E_SCHEMA at /asset");
  EXPECT_EQ(errorOf(text(R"({"asset":{"version":"1.0"},"nodes":{}})")), "E_VERSION at /asset/version");
  EXPECT_EQ(errorOf(text(R"({"asset":{"version":"2.0","minVersion":"2.1"}})")), "E_VERSION at /asset/minVersion");
}

TEST(Schema, RequiredExtensionsAreNamed) {
  ModelBuilder model;
  model.quad();
  model.doc["extensionsUsed"] = {"VENDOR_magic", "VENDOR_glitter"};
  EXPECT_TRUE(hasWarning(*load(model), "W_EXT_IGNORED"));
  model.doc["extensionsRequired"] = {"VENDOR_magic"};
  try {
    load(model);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "E_EXT_REQUIRED");
    EXPECT_NE(std::string(error.what()).find("VENDOR_magic"), std::string::npos);
  }
}

struct SchemaCase {
  const char* pointer;  ///< what is replaced in the quad's document
  json value;
  const char* error;
};

class SchemaFault : public testing::TestWithParam<SchemaCase> {};

TEST_P(SchemaFault, IsFoundWhereItIs) {
  ModelBuilder model;
  model.quad();
  model.doc[json::json_pointer(GetParam().pointer)] = GetParam().value;
  EXPECT_EQ(errorOf(model), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Table, SchemaFault,
    testing::Values(
        SchemaCase{"/nodes", json::object(), "E_SCHEMA at /nodes"},
        SchemaCase{"/nodes/0", nullptr, "E_SCHEMA at /nodes/0"},
        SchemaCase{"/nodes/0/mesh", -1, "E_SCHEMA at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 0.5, "E_SCHEMA at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", "0", "E_SCHEMA at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 1, "E_REF at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 4294967296ull, "E_REF at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 18446744073709551615ull, "E_REF at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 1.8446744073709552e19, "E_REF at /nodes/0/mesh"},
        SchemaCase{"/nodes/0/mesh", 0.0, ""},  // a whole number written as 0.0
        SchemaCase{"/nodes/0/matrix", {1, 2, 3}, "E_SCHEMA at /nodes/0/matrix"},
        SchemaCase{"/nodes/0/rotation", {0, 0, 0, 0}, "E_SCHEMA at /nodes/0/rotation"},
        SchemaCase{"/nodes/0/skin", 0, "E_REF at /nodes/0/skin"},
        SchemaCase{"/nodes/0/children", {0.5}, "E_SCHEMA at /nodes/0/children/0"},
        SchemaCase{"/scene", 7, "E_REF at /scene"},
        SchemaCase{"/meshes/0/primitives", json::array(), "E_SCHEMA at /meshes/0/primitives"},
        SchemaCase{"/meshes/0/primitives/0/attributes", json::array(), "E_SCHEMA at /meshes/0/primitives/0/attributes"},
        SchemaCase{"/meshes/0/primitives/0/attributes/NORMAL", 99, "E_REF at /meshes/0/primitives/0/attributes/NORMAL"},
        SchemaCase{"/meshes/0/primitives/0/mode", 7, "E_SCHEMA at /meshes/0/primitives/0/mode"},
        SchemaCase{"/meshes/0/primitives/0/material", 0, "E_REF at /meshes/0/primitives/0/material"},
        SchemaCase{"/accessors/0/count", 0, "E_ACCESSOR at /accessors/0/count"},
        SchemaCase{"/accessors/0/count", "4", "E_SCHEMA at /accessors/0/count"},
        SchemaCase{"/accessors/0/count", 5, "E_ACCESSOR at /accessors/0"},
        SchemaCase{"/accessors/0/componentType", 5124, "E_ACCESSOR at /accessors/0/componentType"},
        SchemaCase{"/accessors/0/byteOffset", 2, "E_ACCESSOR at /accessors/0/byteOffset"},
        SchemaCase{"/accessors/0/byteOffset", 9007199254740992ull, "E_ACCESSOR at /accessors/0"},
        SchemaCase{"/accessors/0/type", "VEC9", "E_ACCESSOR at /accessors/0/type"},
        SchemaCase{"/accessors/0/type", "MAT4", "E_ACCESSOR at /accessors/0"},
        SchemaCase{"/accessors/1/componentType", 5126, "E_ACCESSOR at /accessors/1"},
        SchemaCase{"/bufferViews/0/byteLength", 0, "E_BUFFERVIEW at /bufferViews/0/byteLength"},
        SchemaCase{"/bufferViews/0/byteOffset", 9007199254740991ull, "E_BUFFERVIEW at /bufferViews/0"},
        SchemaCase{"/bufferViews/0/byteStride", 8, "E_STRIDE at /bufferViews/0/byteStride"},
        SchemaCase{"/bufferViews/0/byteStride", 13, "E_STRIDE at /bufferViews/0/byteStride"},
        SchemaCase{"/bufferViews/0/byteStride", 256, "E_STRIDE at /bufferViews/0/byteStride"},
        SchemaCase{"/bufferViews/0/buffer", 1, "E_REF at /bufferViews/0/buffer"},
        SchemaCase{"/images", {json::object()}, "E_SCHEMA at /images/0"},
        SchemaCase{"/skins", {{{"joints", json::array()}}}, "E_SKIN at /skins/0/joints"}));

TEST(Schema, ListsAreLimited) {
  const auto over = [](std::uint64_t Limits::*limit, const char* list) {
    ModelBuilder model;
    model.quad();
    model.doc[list] = json::array({json::object(), json::object(), json::object()});
    Limits limits;
    limits.*limit = 2;
    return errorOf(model, limits);
  };
  EXPECT_EQ(over(&Limits::nodes, "nodes"), "L_NODES at /nodes");
  EXPECT_EQ(over(&Limits::materials, "materials"), "L_MATERIALS at /materials");
  EXPECT_EQ(over(&Limits::textures, "textures"), "L_TEXTURES at /textures");
  EXPECT_EQ(over(&Limits::images, "images"), "L_IMAGES at /images");
  EXPECT_EQ(over(&Limits::accessors, "accessors"), "L_ACCESSORS at /accessors");
  EXPECT_EQ(over(&Limits::bufferViews, "bufferViews"), "L_BUFFER_VIEWS at /bufferViews");
}

}  // namespace
}  // namespace telar::test
