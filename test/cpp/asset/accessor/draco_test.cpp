#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <draco/point_cloud/point_cloud_builder.h>

#include <cstring>
#include <ctime>

#include "asset/accessor/accessor.h"
#include "asset/accessor/draco_mesh.h"
#include "asset/model_builder.h"
#include "expect_error.h"
#include "telar/limits.h"

namespace telar::test {
namespace {

using namespace telar::asset;

struct Encoded {
  Bytes data;
  std::uint32_t points = 0, faces = 0;
  int position = 0, uv = 0, custom = 0;  ///< unique ids
};

/// How a test encodes.
struct Encoding {
  int method = draco::MESH_EDGEBREAKER_ENCODING;
  int uvPrediction = draco::PREDICTION_UNDEFINED;  ///< left to the encoder
  draco::DataType custom = draco::DT_UINT8;
};

/// A fan of 8 triangles with positions, UVs and a generic attribute of bytes, as a glTF exporter encodes it.
Encoded encode(const Encoding& how) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(8);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  const int custom = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, how.custom);
  for (int i = 0; i < 8; ++i) {
    const auto x = static_cast<float>(i);
    const float p[3][3] = {{4, 3, 0}, {x, 0, 0}, {x + 1, 0, 0}};
    const float t[3][2] = {{0.5f, 1}, {x / 8, 0}, {(x + 1) / 8, 0}};
    const std::uint8_t c[4] = {255, static_cast<std::uint8_t>(i), 51, 255};
    const draco::FaceIndex face(static_cast<unsigned>(i));
    builder.SetAttributeValuesForFace(position, face, p[0], p[1], p[2]);
    builder.SetAttributeValuesForFace(uv, face, t[0], t[1], t[2]);
    builder.SetAttributeValuesForFace(custom, face, c, c, c);
  }
  const auto mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  encoder.SetEncodingMethod(how.method);
  if (how.uvPrediction != draco::PREDICTION_UNDEFINED) {
    encoder.SetAttributePredictionScheme(uv, how.uvPrediction);
  }
  encoder.SetAttributeQuantization(position, 14);
  encoder.SetAttributeQuantization(uv, 12);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  Encoded out;
  const auto* bytes = reinterpret_cast<const std::byte*>(buffer.data());
  out.data.assign(bytes, bytes + buffer.size());
  out.points = mesh->num_points();
  out.faces = mesh->num_faces();
  out.position = static_cast<int>(mesh->attribute(position)->unique_id());
  out.uv = static_cast<int>(mesh->attribute(uv)->unique_id());
  out.custom = static_cast<int>(mesh->attribute(custom)->unique_id());
  return out;
}

/// Nothing of what a decoder holds is over the default limits.
class Bounds {
 public:
  DracoBounds get() { return {limits, memory, cancel}; }
  Limits limits;
  MemoryBudget memory{limits.memoryBytes};
  CancelToken cancel;
};

/// Code of the error; empty = decoded.
std::string codeOf(const Bytes& data, const Encoded& encoded) {
  Bounds bounds;
  try {
    DracoMesh::decode(data, {encoded.points, std::uint64_t{encoded.faces} * 3}, bounds.get(), "");
    return "";
  } catch (const Error& error) {
    return error.code;
  }
}

class DracoTest : public testing::TestWithParam<int> {
 protected:
  DracoTest() : encoded(encode({GetParam()})) {
    json& p = model.primitive({{"POSITION", model.accessor(-1, COMPONENT_F32, encoded.points, "VEC3")},
                               {"TEXCOORD_0", model.accessor(-1, COMPONENT_F32, encoded.points, "VEC2")},
                               {"COLOR_0", model.accessor(-1, COMPONENT_U8, encoded.points, "VEC4", true)}});
    p["indices"] = model.accessor(-1, COMPONENT_U16, encoded.faces * 3, "SCALAR");
    p["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", model.view(encoded.data)},
        {"attributes", {{"POSITION", encoded.position}, {"TEXCOORD_0", encoded.uv}, {"COLOR_0", encoded.custom}}}};
    model.doc["extensionsUsed"] = model.doc["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  }
  json& extension() { return model.doc["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]; }
  static constexpr const char* WHERE = "E_DRACO at /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

  Encoded encoded;
  ModelBuilder model;
};

INSTANTIATE_TEST_SUITE_P(Methods, DracoTest,
                         testing::Values(draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING));

TEST_P(DracoTest, HeaderCountsAreRead) {
  const DracoCounts counts = readDracoCounts(encoded.data, "");
  EXPECT_EQ(counts.faces, 8u);
  EXPECT_GE(counts.vertices, 10u);
}

TEST_P(DracoTest, DecodesEveryAttributeById) {
  const auto scene = load(model);
  const auto& p = scene->meshes[0].primitives[0];
  ASSERT_EQ(p.indices.size(), 24u);
  ASSERT_EQ(p.colors.size(), encoded.points);
  EXPECT_NEAR(scene->bounds.max.x, 8, 1e-3);
  EXPECT_NEAR(scene->bounds.max.y, 3, 1e-3);
  double area = 0;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto a = p.positions[p.indices[i]], b = p.positions[p.indices[i + 1]], c = p.positions[p.indices[i + 2]];
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  EXPECT_NEAR(area, 12, 1e-2);
  for (std::size_t i = 0; i < p.positions.size(); ++i) {
    EXPECT_EQ(p.colors[i].r, 1);
    EXPECT_FLOAT_EQ(p.colors[i].b, 0.2f);
    const float u = p.positions[i].y > 1 ? 0.5f : p.positions[i].x / 8;
    EXPECT_NEAR(p.uvs[0][i].x, u, 1e-3);
  }
}

TEST_P(DracoTest, ContradictionsAreRefused) {
  const auto accessors = model.doc["accessors"];
  for (int i = 0; i < 3; ++i) model.doc["accessors"][i]["count"] = encoded.points + 1;
  EXPECT_EQ(errorOf(model), WHERE);
  model.doc["accessors"] = accessors;
  model.doc["accessors"][3]["count"] = 27;
  EXPECT_EQ(errorOf(model), WHERE);
  model.doc["accessors"] = accessors;
  extension()["attributes"]["POSITION"] = 99;
  EXPECT_EQ(errorOf(model), std::string(WHERE) + "/attributes/POSITION");
  extension()["attributes"]["POSITION"] = encoded.uv;  // two components
  EXPECT_EQ(errorOf(model), std::string(WHERE) + "/attributes/POSITION");
  extension()["attributes"].erase("POSITION");
  EXPECT_EQ(errorOf(model), std::string(WHERE) + "/attributes");
  extension()["bufferView"] = 7;
  EXPECT_EQ(errorOf(model), "E_REF at /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView");
}

/// Every cut and many flips of the bitstream: a mesh or E_DRACO, never a crash, a hang or another error.
TEST_P(DracoTest, DamagedStreamsAreTypedErrors) {
  ASSERT_EQ(codeOf(encoded.data, encoded), "");
  for (std::size_t size = 0; size < encoded.data.size(); ++size) {
    const std::string code =
        codeOf(Bytes(encoded.data.begin(), encoded.data.begin() + static_cast<std::ptrdiff_t>(size)), encoded);
    ASSERT_TRUE(code == "E_DRACO" || (code.empty() && size + 8 > encoded.data.size())) << size << " " << code;
  }
  for (std::size_t at = 0; at < encoded.data.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes data = encoded.data;
      data[at] ^= static_cast<std::byte>(1 << bit);
      const std::string code = codeOf(data, encoded);
      ASSERT_TRUE(code.empty() || code == "E_DRACO") << at << " " << bit << " " << code;
    }
  }
}

/// Texture coordinates that are predicted say how many orientations follow. Whatever number of four bytes is made the
/// largest, decoding stays as small as the mesh: libdraco alone takes ten seconds for one of them.
TEST(DracoClaims, NoNumberInTheDataIsBelieved) {
  for (const int prediction : {draco::MESH_PREDICTION_TEX_COORDS_PORTABLE, draco::MESH_PREDICTION_PARALLELOGRAM}) {
    const Encoded encoded = encode({draco::MESH_EDGEBREAKER_ENCODING, prediction});
    ASSERT_EQ(codeOf(encoded.data, encoded), "");
    const std::clock_t start = std::clock();
    for (std::size_t at = 0; at + 4 <= encoded.data.size(); ++at) {
      Bytes data = encoded.data;
      const std::uint32_t most = 0x7fffffff;
      std::memcpy(&data[at], &most, sizeof most);
      const std::string code = codeOf(data, encoded);
      ASSERT_TRUE(code.empty() || code == "E_DRACO" || code.starts_with("L_")) << at << " " << code;
    }
    EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC);  // processor time
  }
}

TEST(DracoClaims, BooleansAreRefusedBeforeTheyAreRead) {
  const Encoded encoded = encode({.custom = draco::DT_BOOL});
  EXPECT_EQ(codeOf(encoded.data, encoded), "E_DRACO");
}

TEST(DracoClaims, DecodingCountsAgainstTheModelsMemory) {
  const Encoded encoded = encode({});
  Bounds bounds;
  MemoryBudget little(100);
  const auto decode = [&](MemoryBudget& memory) {
    DracoMesh::decode(encoded.data, {encoded.points, 24}, {bounds.limits, memory, bounds.cancel}, "/here");
  };
  try {
    decode(little);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "L_MEMORY_BYTES");
    EXPECT_EQ(error.pointer, "/here");
  }
  MemoryBudget enough(10'000);
  decode(enough);
  EXPECT_EQ(enough.kept(), 0u);
  enough.charge(10'000);  // what decoding needed was given back
}

TEST(DracoClaims, CancelActsInside) {
  const Encoded encoded = encode({});
  Bounds bounds;
  bounds.cancel.cancel();
  try {
    DracoMesh::decode(encoded.data, {encoded.points, 24}, bounds.get(), "");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "X_CANCELLED");
  }
}

TEST(DracoHeader, ClaimsAreRefusedBeforeAnythingIsAllocated) {
  // sequential mesh, 2^32 - 1 faces, 3 points
  const Bytes huge = bytesOf(
      std::vector<unsigned char>{'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0, 0xff, 0xff, 0xff, 0xff, 0x0f, 3, 1});
  EXPECT_EQ(readDracoCounts(huge, "").faces, 0xffffffffu);
  EXPECT_EQ(codeOf(huge, {huge, 3, 1}), "E_DRACO");
  const auto refused = [](const std::vector<unsigned char>& head) {
    try {
      readDracoCounts(bytesOf(head), "");
      return std::string();
    } catch (const Error& error) {
      return error.code;
    }
  };
  EXPECT_EQ(refused({}), "E_DRACO");
  EXPECT_EQ(refused({'D', 'R', 'A', 'C', 'O', 1, 1, 1, 0, 0, 0, 1, 3}), "E_DRACO");
  EXPECT_EQ(refused({'D', 'R', 'A', 'C', 'O', 2, 2, 0, 0, 0, 0, 1, 3}), "E_DRACO");  // point cloud
  EXPECT_EQ(refused({'D', 'R', 'A', 'C', 'O', 2, 2, 1, 9, 0, 0, 1, 3}), "E_DRACO");
  std::vector<unsigned char> nested = {'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0x80, 0};
  for (int i = 0; i < 100'000; ++i) nested.insert(nested.end(), {0, 1, 0});  // metadata in metadata
  EXPECT_EQ(refused(nested), "E_DRACO");
}

/// 40 points on a line with a generic attribute of bytes.
Encoded encodePoints(int method) {
  draco::PointCloudBuilder builder;
  builder.Start(40);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int custom = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  for (std::uint32_t i = 0; i < 40; ++i) {
    const float p[3] = {static_cast<float>(i), 1, 2};
    const std::uint8_t c[4] = {255, static_cast<std::uint8_t>(i), 51, 255};
    builder.SetAttributeValueForPoint(position, draco::PointIndex(i), p);
    builder.SetAttributeValueForPoint(custom, draco::PointIndex(i), c);
  }
  const auto cloud = builder.Finalize(false);
  draco::ExpertEncoder encoder(*cloud);
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(position, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  Encoded out;
  const auto* bytes = reinterpret_cast<const std::byte*>(buffer.data());
  out.data.assign(bytes, bytes + buffer.size());
  out.points = cloud->num_points();
  out.position = static_cast<int>(cloud->attribute(position)->unique_id());
  out.custom = static_cast<int>(cloud->attribute(custom)->unique_id());
  return out;
}

ModelBuilder pointModel(const Encoded& encoded, int mode) {
  ModelBuilder model;
  json& p = model.primitive({{"POSITION", model.accessor(-1, COMPONENT_F32, encoded.points, "VEC3")},
                             {"COLOR_0", model.accessor(-1, COMPONENT_U8, encoded.points, "VEC4", true)}});
  p["mode"] = mode;
  p["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", model.view(encoded.data)},
      {"attributes", {{"POSITION", encoded.position}, {"COLOR_0", encoded.custom}}}};
  return model;
}

TEST(DracoPoints, AreDrawnAsPoints) {
  for (const int method : {draco::POINT_CLOUD_SEQUENTIAL_ENCODING, draco::POINT_CLOUD_KD_TREE_ENCODING}) {
    const Encoded encoded = encodePoints(method);
    const auto scene = load(pointModel(encoded, 0));
    const auto& p = scene->meshes.at(0).primitives.at(0);
    EXPECT_EQ(p.topology, Topology::kPoints);
    EXPECT_TRUE(p.indices.empty());
    ASSERT_EQ(p.positions.size(), 40u);
    for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(p.colors[i].g * 255, p.positions[i].x, 0.01) << "in one order";
    EXPECT_NEAR(scene->bounds.max.x, 39, 1e-2);
    EXPECT_EQ(errorOf(pointModel(encoded, 4)),
              "E_DRACO at /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression");
  }
}

/// Attributes that nothing asks for are decoded too: what they take is known from their types, and lent before.
TEST(DracoPoints, EveryAttributeCountsAgainstTheModelsMemory) {
  constexpr int COMPONENTS = 100;
  draco::PointCloudBuilder builder;
  builder.Start(40);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int wide = builder.AddAttribute(draco::GeometryAttribute::GENERIC, COMPONENTS, draco::DT_INT32);
  const std::int32_t nothing[COMPONENTS] = {};
  for (std::uint32_t i = 0; i < 40; ++i) {
    const float p[3] = {static_cast<float>(i), 1, 2};
    builder.SetAttributeValueForPoint(position, draco::PointIndex(i), p);
    builder.SetAttributeValueForPoint(wide, draco::PointIndex(i), nothing);
  }
  const auto cloud = builder.Finalize(false);
  draco::ExpertEncoder encoder(*cloud);
  encoder.SetEncodingMethod(draco::POINT_CLOUD_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  ASSERT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  const auto* bytes = reinterpret_cast<const std::byte*>(buffer.data());
  const Bounds bounds;
  const auto decode = [&](std::uint64_t most) {
    MemoryBudget memory(most);
    DracoMesh::decode({bytes, buffer.size()}, {40, 0, true}, {bounds.limits, memory, bounds.cancel}, "/here");
  };
  EXPECT_NO_THROW(decode(40 * (COMPONENTS + 3) * 8));
  EXPECT_ERROR(decode(40 * (COMPONENTS + 3) * 8 - 1), "L_MEMORY_BYTES");
}

TEST(DracoPoints, DamagedOnesAreTypedErrors) {
  for (const int method : {draco::POINT_CLOUD_SEQUENTIAL_ENCODING, draco::POINT_CLOUD_KD_TREE_ENCODING}) {
    const Encoded good = encodePoints(method);
    for (std::size_t size = 0; size < good.data.size(); ++size) {
      Encoded cut = good;
      cut.data.resize(std::max<std::size_t>(size, 1));
      const std::string error = errorOf(pointModel(cut, 0));
      EXPECT_TRUE(error.empty() || error.starts_with("E_DRACO")) << size << ": " << error;
    }
    Encoded many = good;
    for (std::size_t i = 11; i < 15; ++i) many.data[i] = std::byte{0x7f};  // the number of points
    EXPECT_TRUE(errorOf(pointModel(many, 0)).starts_with("L_VERTICES"));
  }
}

}  // namespace
}  // namespace telar::test
