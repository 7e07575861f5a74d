#include "telar/pose.h"

#include "asset/model_builder.h"
#include "expect_error.h"

namespace telar::test {
namespace {

using Channel = std::pair<json, std::vector<float>>;  // target, values at 0 and 2 seconds

const char* typeOf(const std::string& path) {
  if (path == "weights") return "SCALAR";
  return path == "rotation" ? "VEC4" : "VEC3";
}

void animate(ModelBuilder& model, const std::vector<Channel>& channels) {
  json animation = {{"channels", json::array()}, {"samplers", json::array()}};
  const int times = model.accessor(std::vector<float>{0, 2}, 5126, "SCALAR");
  for (const auto& [target, values] : channels) {
    animation["channels"].push_back({{"sampler", animation["samplers"].size()}, {"target", target}});
    const int output = model.accessor(values, 5126, typeOf(target["path"]));
    animation["samplers"].push_back({{"input", times}, {"output", output}});
  }
  model.doc["animations"].push_back(animation);
}

json target(int node, const char* path) { return {{"node", node}, {"path", path}}; }

std::string poseError(const std::shared_ptr<const Scene>& scene, const Pose& pose) {
  try {
    poseScene(scene, pose, {});
    return "";
  } catch (const Error& error) {
    return error.code;
  }
}

/// A quad below a parent.
ModelBuilder pair() {
  ModelBuilder model;
  model.quad();
  model.doc["nodes"] = {{{"children", {1}}, {"translation", {0, 10, 0}}}, {{"mesh", 0}}};
  return model;
}

TEST(Pose, ChannelsReplaceTheirPartOfATransform) {
  ModelBuilder model = pair();
  model.doc["nodes"][0]["scale"] = {2, 2, 2};
  animate(model, {{target(0, "translation"), {0, 0, 0, 4, 0, 0}}, {target(1, "scale"), {1, 1, 1, 3, 1, 1}}});
  const auto scene = load(model);
  const auto posed = poseScene(scene, {0, 1}, {});
  EXPECT_EQ(posed->nodes[1].world * glm::dvec4(1, 1, 0, 1), glm::dvec4(6, 2, 0, 1));
  EXPECT_EQ(posed->bounds.min, glm::dvec3(2, 0, 0));
  EXPECT_EQ(posed->bounds.max, glm::dvec3(6, 2, 0));
  EXPECT_EQ(scene->bounds.max, glm::dvec3(2, 12, 0));  // the model stands as it was
}

TEST(Pose, BeforeTheStartAndAfterTheEndItStandsStill) {
  ModelBuilder model = pair();
  animate(model, {{target(1, "translation"), {1, 0, 0, 5, 0, 0}}});
  const auto scene = load(model);
  EXPECT_EQ(poseScene(scene, {0, -3}, {})->bounds.min.x, 1);
  EXPECT_EQ(poseScene(scene, {0, 0.5}, {})->bounds.min.x, 2);
  EXPECT_EQ(poseScene(scene, {0, 99}, {})->bounds.min.x, 5);
}

TEST(Pose, SharesWhatDoesNotDeform) {
  ModelBuilder model = pair();
  animate(model, {{target(1, "translation"), {0, 0, 0, 1, 0, 0}}});
  const auto scene = load(model);
  const auto posed = poseScene(scene, {0, 1}, {});
  EXPECT_EQ(&posed->meshes[0].primitives[0], &scene->meshes[0].primitives[0]);
  EXPECT_EQ(posed->model, scene);
  EXPECT_EQ(posed->motion, scene->motion);
  EXPECT_EQ(posed->meshes.size(), 1u);
}

TEST(Pose, OfAPoseIsOneOfTheModel) {
  ModelBuilder model = pair();
  animate(model, {{target(0, "translation"), {0, 0, 0, 4, 0, 0}}});
  animate(model, {{target(1, "translation"), {0, 0, 0, 0, 0, 6}}});
  const auto scene = load(model);
  const auto again = poseScene(poseScene(scene, {0, 2}, {}), {1, 2}, {});
  EXPECT_EQ(again->bounds.min, glm::dvec3(0, 10, 6));
  EXPECT_EQ(again->model, scene);
}

TEST(Pose, MorphsByAnimatedWeights) {
  ModelBuilder model = pair();
  const int up = model.accessor(std::vector<float>{0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2}, 5126, "VEC3");
  model.doc["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}};
  animate(model, {{target(1, "weights"), {0, 1}}});
  const auto scene = load(model);
  const auto posed = poseScene(scene, {0, 0.5}, {});
  EXPECT_EQ(posed->bounds.max.z, 0.5);
  EXPECT_EQ(posed->nodes[1].mesh, 1);
  EXPECT_EQ(posed->meshes[1].primitives[0].positions[2], glm::vec3(1, 1, 0.5));
  EXPECT_EQ(poseScene(scene, {0, 0}, {})->nodes[1].mesh, 0);
}

TEST(Pose, MovesCamerasAndLights) {
  ModelBuilder model = pair();
  model.doc["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  model.doc["nodes"][0]["camera"] = 0;
  animate(model, {{target(0, "translation"), {0, 0, 5, 0, 0, 9}}});
  const auto posed = poseScene(load(model), {0, 1}, {});
  EXPECT_EQ(json::parse(describeScene(*posed))["cameras"][0]["position"], (json{0, 0, 7}));
}

TEST(Pose, WhatIsSqueezedToNothingMayGrow) {
  ModelBuilder model = pair();
  model.doc["nodes"][1]["scale"] = {0, 0, 0};
  animate(model, {{target(1, "scale"), {0, 0, 0, 2, 2, 2}}});
  const auto scene = load(model);
  EXPECT_TRUE(scene->bounds.empty());
  EXPECT_TRUE(hasWarning(*scene, "W_SCALE"));
  const auto posed = poseScene(scene, {0, 1}, {});
  EXPECT_EQ(posed->bounds.max, glm::dvec3(1, 11, 0));
  EXPECT_FALSE(hasWarning(*posed, "W_SCALE"));
  EXPECT_EQ(poseError(scene, {0, 0}), "E_NO_GEOMETRY");
}

TEST(Pose, AnUnknownAnimationIsRefused) {
  ModelBuilder model = pair();
  EXPECT_EQ(poseError(load(model), {0, 0}), "E_POSE");
  animate(model, {{target(1, "scale"), {1, 1, 1, 2, 2, 2}}});
  EXPECT_EQ(poseError(load(model), {1, 0}), "E_POSE");
  EXPECT_EQ(poseError(load(model), {-1, 0}), "E_POSE");
}

TEST(Pose, ValuesOutOfRangeAreNotDrawn) {
  ModelBuilder model = pair();
  animate(model, {{target(1, "translation"), {0, 0, 0, 3e38f, 0, 0}}, {target(0, "scale"), {1, 1, 1, 3e38f, 1, 1}}});
  EXPECT_EQ(poseError(load(model), {0, 2}), "E_NO_GEOMETRY");
}

TEST(Pose, CanBeCancelled) {
  ModelBuilder model = pair();
  animate(model, {{target(1, "scale"), {1, 1, 1, 2, 2, 2}}});
  const auto scene = load(model);
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_ERROR(poseScene(scene, {0, 0}, cancel), "X_CANCELLED");
}

TEST(Pose, MatricesAreTakenApartAsThreeDoes) {
  ModelBuilder model = pair();
  // Turned by 90 degrees about z and mirrored in x; then the rotation alone is animated away.
  model.doc["nodes"][1]["matrix"] = {0, -2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1};
  const auto rest = load(model);
  EXPECT_NEAR(rest->nodes[1].world[0].y, -2, 1e-12);
  EXPECT_NEAR(rest->nodes[1].transform.scale.x, -2, 1e-12);
  animate(model, {{target(1, "rotation"), {0, 0, 0, 1, 0, 0, 0, 1}}});
  const auto posed = poseScene(load(model), {0, 1}, {});
  EXPECT_NEAR(posed->nodes[1].world[0].x, -2, 1e-12);
  EXPECT_NEAR(posed->nodes[1].world[1].y, 3, 1e-12);
}

TEST(Pose, ShearIsLostAsInThree) {
  ModelBuilder model = pair();
  model.doc["nodes"][1]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const auto scene = load(model);
  const glm::dmat3 linear(scene->nodes[1].world);
  EXPECT_NEAR(glm::dot(linear[0], linear[1]), 0, 0.5);  // the axes are nearly square again
  EXPECT_NEAR(glm::length(linear[1]), std::sqrt(2.0), 0.7);
}

}  // namespace
}  // namespace telar::test
