#include "asset/accessor/accessor.h"

#include "asset/model_builder.h"

namespace telar::test {
namespace {

using namespace telar::asset;

/// A triangle whose first UV set is the given accessor data.
std::vector<glm::vec2> uvsFrom(const Bytes& data, int componentType, bool normalized, int stride = 0) {
  ModelBuilder model;
  const int position = model.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, COMPONENT_F32, "VEC3");
  const int uv = model.accessor(model.view(data, stride), componentType, 3, "VEC2", normalized);
  model.primitive({{"POSITION", position}, {"TEXCOORD_0", uv}});
  return load(model)->meshes[0].primitives[0].uvs[0];
}

TEST(Accessor, NormalizedComponentsFollowOpenGl) {
  for (const auto how : {Normalizing::kDivided, Normalizing::kFetched}) {
    EXPECT_EQ(fromComponent(-128, COMPONENT_I8, true, how), -1.0f);
    EXPECT_EQ(fromComponent(-127, COMPONENT_I8, true, how), -1.0f);
    EXPECT_EQ(fromComponent(127, COMPONENT_I8, true, how), 1.0f);
    EXPECT_EQ(fromComponent(255, COMPONENT_U8, true, how), 1.0f);
    EXPECT_FLOAT_EQ(fromComponent(51, COMPONENT_U8, true, how), 0.2f);
    EXPECT_EQ(fromComponent(-32768, COMPONENT_I16, true, how), -1.0f);
    EXPECT_EQ(fromComponent(65535, COMPONENT_U16, true, how), 1.0f);
    EXPECT_EQ(fromComponent(200, COMPONENT_U8, false, how), 200.0f);
  }
}

TEST(Accessor, NormalizedComponentsAreThoseOfWhoReadsThem) {
  int differ = 0;
  for (int i = 0; i <= 255; ++i) {
    const float divided = fromComponent(i, COMPONENT_U8, true, Normalizing::kDivided);
    const float fetched = fromComponent(i, COMPONENT_U8, true, Normalizing::kFetched);
    EXPECT_EQ(divided, static_cast<float>(i / 255.0));
    EXPECT_EQ(fetched, static_cast<float>(i) * (1.0f / 255.0f));
    differ += divided != fetched;
  }
  EXPECT_GT(differ, 0);
}

TEST(Accessor, ReadsEveryComponentType) {
  using Uvs = std::vector<glm::vec2>;
  const Uvs integers = {{1, 2}, {3, 4}, {5, 100}};
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<std::int8_t>{1, 2, 3, 4, 5, 100}), COMPONENT_I8, false), integers);
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<std::uint8_t>{1, 2, 3, 4, 5, 100}), COMPONENT_U8, false), integers);
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<std::int16_t>{1, 2, 3, 4, 5, 100}), COMPONENT_I16, false), integers);
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<std::uint16_t>{1, 2, 3, 4, 5, 100}), COMPONENT_U16, false), integers);
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<float>{1, 2, 3, 4, 5, 100}), COMPONENT_F32, false), integers);
  const Uvs unit = {{0, 1}, {1, 0}, {51 * (1 / 255.0f), 102 * (1 / 255.0f)}};
  EXPECT_EQ(uvsFrom(bytesOf(std::vector<std::uint8_t>{0, 255, 255, 0, 51, 102}), COMPONENT_U8, true), unit);
}

TEST(Accessor, HonoursTheStride) {
  const std::vector<float> interleaved = {1, 2, -1, -1, 3, 4, -1, -1, 5, 100};  // the last element ends the view
  EXPECT_EQ(uvsFrom(bytesOf(interleaved), COMPONENT_F32, false, 16),
            (std::vector<glm::vec2>{{1, 2}, {3, 4}, {5, 100}}));
}

class SparseAccessor : public testing::Test {
 protected:
  SparseAccessor() {
    model.quad();
    indices = model.view(bytesOf(std::vector<std::uint16_t>{1, 2}));
    values = model.view(bytesOf(std::vector<float>{7, 0, 0, 7, 8, 9}));
    sparse() = {{"count", 2},
                {"indices", {{"bufferView", indices}, {"componentType", COMPONENT_U16}}},
                {"values", {{"bufferView", values}}}};
  }
  json& sparse() { return model.doc["accessors"][0]["sparse"]; }
  void setIndices(std::uint16_t a, std::uint16_t b) {
    sparse()["indices"]["bufferView"] = model.view(bytesOf(std::vector<std::uint16_t>{a, b}));
  }

  ModelBuilder model;
  int indices, values;
};

TEST_F(SparseAccessor, ReplacesElements) {
  const auto positions = load(model)->meshes[0].primitives[0].positions;
  EXPECT_EQ(positions, (std::vector<glm::vec3>{{0, 0, 0}, {7, 0, 0}, {7, 8, 9}, {0, 1, 0}}));
}

TEST_F(SparseAccessor, StandsOnZerosWithoutAView) {
  model.doc["accessors"][0].erase("bufferView");
  const auto positions = load(model)->meshes[0].primitives[0].positions;
  EXPECT_EQ(positions, (std::vector<glm::vec3>{{0, 0, 0}, {7, 0, 0}, {7, 8, 9}, {0, 0, 0}}));
}

TEST_F(SparseAccessor, TellsWhichIndexIsWrong) {
  const auto toldOf = [this](std::uint16_t a, std::uint16_t b) -> std::string {
    setIndices(a, b);
    try {
      load(model);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(toldOf(2, 1), "sparse index 1 is 1, which is not above 2, the one before it");
  EXPECT_EQ(toldOf(1, 4), "sparse index 1 is 4, but the accessor has 4 elements");
}

TEST_F(SparseAccessor, RefusesContradictions) {
  setIndices(1, 4);
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/indices");
  setIndices(2, 1);
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/indices");
  setIndices(1, 1);
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/indices");
  setIndices(0, 3);
  EXPECT_EQ(errorOf(model), "");
  sparse()["count"] = 3;  // the views hold two
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/indices");
  sparse()["count"] = 5;
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/count");
  sparse()["count"] = 4611686018427387904ull;
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/count");
  sparse()["count"] = 2;
  sparse()["values"]["byteOffset"] = 4;
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/values");
  sparse()["values"]["byteOffset"] = 18446744073709551608ull;
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/values/byteOffset");
  sparse()["values"]["byteOffset"] = 0;
  sparse()["indices"]["componentType"] = COMPONENT_I16;
  EXPECT_EQ(errorOf(model), "E_SPARSE at /accessors/0/sparse/indices/componentType");
}

TEST(Buffers, LengthsMustBeTrue) {
  ModelBuilder model;
  model.quad();
  json doc = model.doc;
  doc["buffers"] = {{{"byteLength", model.bin.size() + 4}}};
  EXPECT_EQ(errorOf(glbOf(doc.dump(), model.bin)), "E_BUFFER at /buffers/0/byteLength");
  doc["buffers"] = {{{"byteLength", 1ull << 40}}};
  EXPECT_EQ(errorOf(glbOf(doc.dump(), model.bin)), "E_BUFFER at /buffers/0/byteLength");
  doc["buffers"] = {{{"byteLength", 20}}};  // the bytes are there, but the buffer says that it ends
  EXPECT_EQ(errorOf(glbOf(doc.dump(), model.bin)), "E_BUFFERVIEW at /bufferViews/0");
  doc["buffers"] = {{{"byteLength", model.bin.size()}}, {{"byteLength", 4}}};
  EXPECT_EQ(errorOf(glbOf(doc.dump(), model.bin)), "E_BUFFER at /buffers/1");
  EXPECT_EQ(errorOf(glbOf(doc.dump(), {})), "E_BUFFER at /buffers/0");
}

}  // namespace
}  // namespace telar::test
