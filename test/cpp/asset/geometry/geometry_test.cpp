#include <limits>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

constexpr float NAN_F = std::numeric_limits<float>::quiet_NaN();
constexpr float INF_F = std::numeric_limits<float>::infinity();
using Indices = std::vector<std::uint32_t>;

const Primitive& first(const std::shared_ptr<const Scene>& scene) { return scene->meshes.at(0).primitives.at(0); }

/// Five points that are not in one line, drawn in the given mode.
ModelBuilder points(int mode) {
  ModelBuilder model;
  const std::vector<float> five = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
  model.primitive({{"POSITION", model.accessor(five, 5126, "VEC3")}})["mode"] = mode;
  return model;
}

TEST(Geometry, ModesBecomeTopologies) {
  const auto drawn = [](int mode) {
    const auto scene = load(points(mode));
    return std::pair(first(scene).topology, first(scene).indices);
  };
  EXPECT_EQ(drawn(0), std::pair(Topology::kPoints, Indices{}));
  EXPECT_EQ(drawn(1), std::pair(Topology::kLines, Indices{0, 1, 2, 3}));  // the fifth has no partner
  EXPECT_EQ(drawn(2), std::pair(Topology::kLineLoop, Indices{}));
  EXPECT_EQ(drawn(3), std::pair(Topology::kLineStrip, Indices{}));
  EXPECT_EQ(drawn(4), std::pair(Topology::kTriangles, Indices{0, 1, 2}));
  EXPECT_EQ(drawn(5), std::pair(Topology::kTriangles, Indices{0, 1, 2, 3, 2, 1, 2, 3, 4}));
  EXPECT_EQ(drawn(6), std::pair(Topology::kTriangles, Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(Geometry, StripsKeepTheirWinding) {
  // a strip of a flat quad: both triangles must face +Z
  ModelBuilder model;
  model.primitive(
      {{"POSITION", model.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 5126, "VEC3")}})["mode"] = 5;
  const auto scene = load(model);
  const auto& p = first(scene);
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto a = p.positions[p.indices[i]], b = p.positions[p.indices[i + 1]], c = p.positions[p.indices[i + 2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0);
  }
}

TEST(Geometry, IndicesAreScannedWhole) {
  ModelBuilder model;
  json& primitive = model.quad();
  const auto with = [&](int type, const Bytes& data, std::size_t count) {
    primitive["indices"] = model.accessor(model.view(data), type, count, "SCALAR");
    return errorOf(model);
  };
  EXPECT_EQ(with(5121, bytesOf(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}), 6), "");
  EXPECT_EQ(with(5125, bytesOf(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}), 6), "");
  EXPECT_EQ(with(5123, bytesOf(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 4}), 6), "E_INDEX at /accessors/4");
  EXPECT_EQ(with(5125, bytesOf(std::vector<std::uint32_t>{0, 1, 0xffffffff}), 3), "E_INDEX at /accessors/5");
  EXPECT_EQ(with(5123, bytesOf(std::vector<std::uint16_t>{0, 1}), 2), "E_NO_GEOMETRY");
  EXPECT_EQ(with(5126, bytesOf(std::vector<float>{0, 1, 2}), 3), "E_ACCESSOR at /meshes/0/primitives/0/indices");
  primitive["indices"] =
      model.accessor(model.view(bytesOf(std::vector<std::uint16_t>{0, 0, 1, 1, 2, 2}), 4), 5123, 3, "SCALAR");
  EXPECT_EQ(errorOf(model), "E_STRIDE at /bufferViews/8/byteStride");
}

TEST(Geometry, AttributesMustMatchPosition) {
  ModelBuilder model;
  json& attributes = model.quad()["attributes"];
  const std::string where = "E_ACCESSOR at /meshes/0/primitives/0/attributes/";
  attributes["NORMAL"] = model.accessor(std::vector<float>{0, 0, 1}, 5126, "VEC3");
  EXPECT_EQ(errorOf(model), where + "NORMAL");
  attributes.erase("NORMAL");
  attributes["TEXCOORD_1"] = attributes["POSITION"];
  EXPECT_EQ(errorOf(model), where + "TEXCOORD_1");
  attributes.erase("TEXCOORD_1");
  attributes["TANGENT"] = model.accessor(-1, 5126, 4, "MAT2");
  EXPECT_EQ(errorOf(model), where + "TANGENT");
  attributes.erase("TANGENT");
  attributes["_ANYTHING"] = model.accessor(std::vector<float>{0, 0, 1}, 5126, "SCALAR");
  EXPECT_EQ(errorOf(model), "");
}

TEST(Geometry, AbsentStreamsStayEmpty) {
  ModelBuilder model;
  model.quad();
  const auto scene = load(model);
  const auto& p = first(scene);
  EXPECT_EQ(p.positions.size(), 4u);
  EXPECT_TRUE(p.normals.empty() && p.tangents.empty() && p.uvs[0].empty() && p.uvs[1].empty() && p.colors.empty());
  EXPECT_EQ(p.material, -1);
}

TEST(Geometry, ColoursWithAndWithoutAlpha) {
  ModelBuilder model;
  json& attributes = model.quad()["attributes"];
  attributes["COLOR_0"] = model.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, .5f, .5f, .5f}, 5126, "VEC3");
  auto scene = load(model);
  EXPECT_FALSE(first(scene).colorsHaveAlpha);
  EXPECT_EQ(first(scene).colors[3], glm::vec4(.5f, .5f, .5f, 1));
  const std::vector<std::uint8_t> rgba = {255, 0, 0, 51, 0, 255, 0, 255, 0, 0, 255, 0, 255, 255, 255, 255};
  attributes["COLOR_0"] = model.accessor(rgba, 5121, "VEC4", true);
  scene = load(model);
  EXPECT_TRUE(first(scene).colorsHaveAlpha);
  EXPECT_EQ(first(scene).colors[0], glm::vec4(1, 0, 0, 51 * (1 / 255.0f)));
}

TEST(Geometry, QuantizedPositionsAreMeasuredInWorldSpace) {
  ModelBuilder model;
  const std::vector<std::int16_t> corners = {0, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0};  // stride 8
  const int position = model.accessor(model.view(bytesOf(corners), 8), 5122, 3, "VEC3", true);
  model.primitive({{"POSITION", position}});
  model.doc["nodes"][0]["scale"] = {0.5, 0.25, 1};
  model.doc["extensionsUsed"] = {"KHR_mesh_quantization"};
  model.doc["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto scene = load(model);
  EXPECT_EQ(scene->bounds.max, glm::dvec3(0.5, 0.25, 0));
  EXPECT_TRUE(scene->warnings.empty());
}

TEST(Geometry, BoundsCoverDrawnVerticesOnlyAndDeclaredOnesAreNotTrusted) {
  ModelBuilder model;
  const std::vector<float> four = {0, 0, 0, 1, 0, 0, 0, 1, 0, 900, 900, 900};
  json& primitive = model.primitive({{"POSITION", model.accessor(four, 5126, "VEC3")}});
  primitive["indices"] = model.accessor(std::vector<std::uint8_t>{0, 1, 2}, 5121, "SCALAR");
  auto scene = load(model);
  EXPECT_EQ(scene->bounds.max, glm::dvec3(1, 1, 0));
  EXPECT_FALSE(hasWarning(*scene, "W_MINMAX"));
  model.doc["accessors"][0]["min"] = {-1e30, 0, 0};
  model.doc["accessors"][0]["max"] = {1e30, 0.5, 0};
  scene = load(model);
  EXPECT_EQ(scene->bounds.max, glm::dvec3(1, 1, 0));
  EXPECT_TRUE(hasWarning(*scene, "W_MINMAX"));
  model.doc["accessors"][0]["min"] = {0};
  EXPECT_TRUE(hasWarning(*load(model), "W_MINMAX"));
}

TEST(Geometry, ElementsThatAreNotFiniteAreDropped) {
  ModelBuilder model;
  const std::vector<float> four = {0, 0, 0, 1, 0, 0, 1, 1, 0, NAN_F, 1, 0};
  json& primitive = model.primitive({{"POSITION", model.accessor(four, 5126, "VEC3")}});
  primitive["indices"] = model.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR");
  const auto scene = load(model);
  EXPECT_EQ(first(scene).indices, (Indices{0, 1, 2}));
  EXPECT_EQ(first(scene).positions[3], glm::vec3(0));
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
  EXPECT_EQ(scene->bounds.max, glm::dvec3(1, 1, 0));

  for (const int mode : {0, 1, 2, 3, 4, 5, 6}) {
    ModelBuilder all;
    all.primitive(
        {{"POSITION", all.accessor(std::vector<float>(12, mode % 2 ? INF_F : 3e38f), 5126, "VEC3")}})["mode"] = mode;
    EXPECT_EQ(errorOf(all), "E_NO_GEOMETRY") << "mode " << mode;
  }
}

TEST(Geometry, LinesAroundABadVertexAreDropped) {
  ModelBuilder model;
  const std::vector<float> five = {0, 0, 0, 1, 0, 0, NAN_F, 1, 0, 1, 1, 0, 0, 2, 0};
  json& primitive = model.primitive({{"POSITION", model.accessor(five, 5126, "VEC3")}});
  primitive["mode"] = 2;
  const auto loop = load(model);
  EXPECT_EQ(first(loop).topology, Topology::kLines);
  EXPECT_EQ(first(loop).indices, (Indices{0, 1, 3, 4, 4, 0}));
  primitive["mode"] = 3;
  const auto strip = load(model);
  EXPECT_EQ(first(strip).indices, (Indices{0, 1, 3, 4}));
}

TEST(Geometry, EmptyExtentIsNoGeometry) {
  ModelBuilder model;
  model.primitive({{"POSITION", model.accessor(std::vector<float>(9, 1.0f), 5126, "VEC3")}});
  EXPECT_EQ(errorOf(model), "E_NO_GEOMETRY");
  ModelBuilder none;
  none.primitive({{"NORMAL", none.accessor(std::vector<float>(9, 1.0f), 5126, "VEC3")}});
  EXPECT_EQ(errorOf(none), "E_NO_GEOMETRY");
}

TEST(Geometry, UnusableNormalsAndTangentsAreReplaced) {
  ModelBuilder model;
  json& attributes = model.quad()["attributes"];
  attributes["NORMAL"] = model.accessor(std::vector<float>{NAN_F, 0, 0, 0, 0, 0, 1e30f, 0, 0, 0, 3, 0}, 5126, "VEC3");
  attributes["TANGENT"] =
      model.accessor(std::vector<float>{1, 0, 0, 0, NAN_F, 0, 0, -1, 0, 0, 0, 1, 2, 0, 0, -7}, 5126, "VEC4");
  const auto scene = load(model);
  const auto& p = first(scene);
  EXPECT_EQ(p.normals[0], glm::vec3(0, 0, 1));  // of the faces
  EXPECT_EQ(p.normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(p.normals[2], glm::vec3(1, 0, 0));  // its length would overflow when squared
  EXPECT_EQ(p.normals[3], glm::vec3(0, 3, 0));  // as in the file
  EXPECT_EQ(p.tangents[0], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(p.tangents[1], glm::vec4(0, 0, 0, -1));  // none
  EXPECT_EQ(p.tangents[2], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(p.tangents[3], glm::vec4(2, 0, 0, -1));
  EXPECT_TRUE(hasWarning(*scene, "W_NONFINITE"));
}

TEST(Geometry, UnusableUvsAndColoursAreReplaced) {
  ModelBuilder model;
  json& attributes = model.quad()["attributes"];
  attributes["TEXCOORD_0"] = model.accessor(std::vector<float>{NAN_F, 1, 1, INF_F, 3, -4, 1, 1}, 5126, "VEC2");
  attributes["COLOR_0"] = model.accessor(std::vector<float>{NAN_F, -1, 1e30f, 1, 0, 1, 1, 1, 1, 1, 1, 1}, 5126, "VEC3");
  const auto scene = load(model);
  EXPECT_EQ(first(scene).uvs[0], (std::vector<glm::vec2>{{0, 0}, {0, 0}, {3, -4}, {1, 1}}));
  EXPECT_EQ(first(scene).colors[0], glm::vec4(1, 0, 65504, 1));
}

TEST(Geometry, VisibilityIsReadOfBothSides) {
  ModelBuilder model;
  json& primitive = model.quad();
  const std::vector<std::int16_t> shorts(4 * 4, 16384);
  primitive["attributes"]["_TELAR_VISIBILITY"] = model.accessor(shorts, 5122, "VEC4", true);
  const auto scene = load(model);
  ASSERT_EQ(first(scene).visibility[0].size(), 4u);
  EXPECT_NEAR(first(scene).visibility[0][3].w, 0.5, 1e-4);
  EXPECT_TRUE(first(scene).visibility[1].empty());
  EXPECT_EQ(first(scene).file, 0);
}

TEST(Geometry, VisibilityOfHostileFilesIsMadeUsable) {
  ModelBuilder model;
  json& primitive = model.quad();
  const std::vector<float> values = {NAN_F, 0, 1, 0.5f, 1e30f, 0, 0, 2, 0, INF_F, 0, -3, 0, 1, 0, NAN_F};
  primitive["attributes"]["_TELAR_VISIBILITY_BACK"] = model.accessor(values, 5126, "VEC4");
  const auto scene = load(model);
  const std::vector<glm::vec4> wanted = {{0, 0, 0, 0.5f}, {0, 0, 0, 1}, {0, 0, 0, 0}, {0, 1, 0, 1}};
  EXPECT_EQ(first(scene).visibility[1], wanted);
  ASSERT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->warnings[0].code, "W_NONFINITE");
}

TEST(Geometry, VisibilityOfAnotherShapeIsRefused) {
  const auto errorWith = [](const char* type, const std::vector<float>& values) {
    ModelBuilder model;
    json& primitive = model.quad();
    primitive["attributes"]["_TELAR_VISIBILITY"] = model.accessor(values, 5126, type);
    return errorOf(model);
  };
  const std::string refused = "E_ACCESSOR at /meshes/0/primitives/0/attributes/_TELAR_VISIBILITY";
  EXPECT_EQ(errorWith("VEC3", std::vector<float>(12, 0)), refused);
  EXPECT_EQ(errorWith("VEC4", std::vector<float>(12, 0)), refused) << "three vertices of four";
  EXPECT_EQ(errorWith("VEC4", std::vector<float>(16, 0)), "");
}

}  // namespace
}  // namespace telar::test
