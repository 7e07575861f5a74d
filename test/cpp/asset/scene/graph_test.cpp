#include "asset/model_builder.h"

namespace telar::test {
namespace {

TEST(Graph, CyclesAndSharedChildrenAreRefused) {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"][0]["children"] = {0};
  EXPECT_EQ(errorOf(model), "E_GRAPH at /nodes/0");
  model.doc["nodes"] = {{{"mesh", 0}, {"children", {1, 2}}}, {{"children", {2}}}, json::object()};
  EXPECT_EQ(errorOf(model), "E_GRAPH at /nodes/1/children/0");
  // a cycle that no scene reaches
  model.doc["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_EQ(errorOf(model), "E_GRAPH at /nodes/1");
  model.doc["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}};
  EXPECT_EQ(errorOf(model), "E_GRAPH at /scenes/0/nodes/0");
}

TEST(Graph, DepthIsLimitedWithoutRecursion) {
  ModelBuilder model;
  model.quad();
  for (int i = 1; i < 60'000; ++i) {
    model.doc["nodes"][i - 1]["children"] = {i};
    model.doc["nodes"].push_back(json::object());
  }
  EXPECT_EQ(errorOf(model).substr(0, 12), "L_NODE_DEPTH");
  Limits limits;
  limits.nodeDepth = 60'000;
  EXPECT_EQ(load(model, limits)->nodes.size(), 60'000u);
}

TEST(Graph, SceneIsTheDefaultOneElseTheFirstElseAllRoots) {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
  model.doc["scenes"].push_back({{"nodes", {1}}, {"name", "second"}});
  model.doc["scene"] = 1;
  EXPECT_EQ(load(model)->bounds.min.x, 5);
  EXPECT_EQ(load(model)->name, "second");
  model.doc.erase("scene");
  EXPECT_EQ(load(model)->bounds.max.x, 1);
  model.doc.erase("scenes");
  const auto all = load(model);
  EXPECT_EQ(all->nodes.size(), 2u);
  EXPECT_TRUE(hasWarning(*all, "W_NO_SCENE"));
}

TEST(Graph, WorldMatricesKeepMirroringAndNonUniformScale) {
  ModelBuilder model;
  model.quad();
  const double h = std::sqrt(0.5);
  model.doc["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, h, h}}},
                        {{"mesh", 0}, {"scale", {-2, 3, 1}}}};
  const auto scene = load(model);
  ASSERT_EQ(scene->nodes.size(), 2u);
  EXPECT_EQ(scene->nodes[1].parent, 0);
  EXPECT_LT(glm::determinant(glm::dmat3(scene->nodes[1].world)), 0);
  // 90 degrees about Z: x' = 10 - y, y' = x; the scaled quad spans x -2..0, y 0..3
  EXPECT_NEAR(scene->bounds.min.x, 7, 1e-12);
  EXPECT_NEAR(scene->bounds.max.x, 10, 1e-12);
  EXPECT_NEAR(scene->bounds.min.y, -2, 1e-12);
  EXPECT_NEAR(scene->bounds.max.y, 0, 1e-12);
}

TEST(Graph, MatrixIsColumnMajor) {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1};
  const auto scene = load(model);
  EXPECT_EQ(scene->bounds.min, glm::dvec3(4, 5, 6));
  EXPECT_EQ(scene->nodes[0].world[3], glm::dvec4(4, 5, 6, 1));
  model.doc["nodes"][0]["scale"] = {1, 1, 1};
  EXPECT_EQ(errorOf(model), "E_SCHEMA at /nodes/0/matrix");
}

TEST(Graph, CollapsedNodesAreLeftOut) {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"].push_back({{"mesh", 0}, {"scale", {0, 0, 0}}, {"translation", {100, 0, 0}}});
  model.doc["scenes"][0]["nodes"] = {0, 1};
  const auto scene = load(model);
  EXPECT_TRUE(hasWarning(*scene, "W_SCALE"));
  EXPECT_EQ(scene->bounds.max.x, 1);
  EXPECT_EQ(scene->drawCount, 1u);
  model.doc["nodes"][0]["scale"] = {1e-320, 1, 0};
  EXPECT_EQ(errorOf(model), "E_NO_GEOMETRY");
}

TEST(Graph, DrawsBeyondTheRangeOfFloatsAreLeftOut) {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"][0] = {{"scale", {1e200, 1e200, 1e200}}, {"children", {1}}};
  model.doc["nodes"].push_back({{"scale", {1e200, 1e200, 1e200}}, {"mesh", 0}});
  EXPECT_EQ(errorOf(model), "E_NO_GEOMETRY");
  model.doc["nodes"][0] = {{"scale", {1e6, 1e6, 1e6}}, {"children", {1}}};
  model.doc["nodes"][1] = {{"mesh", 0}, {"translation", {1e3, 0, 0}}};
  EXPECT_EQ(load(model)->bounds.max.x, 1e6 * 1001);
}

TEST(Graph, WorkIsLimitedByWhatIsVisited) {
  ModelBuilder model;
  model.quad();
  for (int i = 1; i < 10; ++i) {
    model.doc["nodes"].push_back({{"mesh", 0}});
    model.doc["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_EQ(load(model)->triangleCount, 20u);
  Limits limits;
  limits.triangles = 19;
  EXPECT_EQ(errorOf(model, limits), "L_TRIANGLES at /meshes/0/primitives/0");
  limits.triangles = 5;
  try {
    load(model, limits);
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("L_TRIANGLES: more than the limit of 5 (at least 6: counting stopped there);"))
        << message;
    EXPECT_EQ(error.limit->actual, 6);
  }
  limits = {};
  limits.drawCalls = 9;
  EXPECT_EQ(errorOf(model, limits), "L_DRAW_CALLS at /meshes/0/primitives/0");
  limits = {};
  limits.vertices = 4;  // the mesh is decoded once
  EXPECT_EQ(errorOf(model, limits), "");
  limits.vertices = 3;
  EXPECT_EQ(errorOf(model, limits), "L_VERTICES at /meshes/0/primitives/0");
}

TEST(Graph, ZeroFilledBombsAreRefusedByTheirCount) {
  ModelBuilder model;
  model.primitive({{"POSITION", model.accessor(-1, 5126, 2'000'000'000, "VEC3")}});
  EXPECT_EQ(errorOf(model), "L_VERTICES at /meshes/0/primitives/0");
  ModelBuilder indices;
  indices.quad()["indices"] = indices.accessor(-1, 5125, 300'000'000, "SCALAR");
  EXPECT_EQ(errorOf(indices), "L_TRIANGLES at /meshes/0/primitives/0");
}

}  // namespace
}  // namespace telar::test
