#include <limits>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

/// A quad whose node an animation moves: 0 to 2 in x within two seconds.
ModelBuilder animated() {
  ModelBuilder model;
  model.quad();
  const int times = model.accessor(std::vector<float>{0, 2}, 5126, "SCALAR");
  const int values = model.accessor(std::vector<float>{0, 0, 0, 2, 0, 0}, 5126, "VEC3");
  model.doc["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                              {"samplers", {{{"input", times}, {"output", values}}}}}};
  return model;
}

json& channelOf(ModelBuilder& model) { return model.doc["animations"][0]["channels"][0]; }
json& samplerOf(ModelBuilder& model) { return model.doc["animations"][0]["samplers"][0]; }

std::string errorWith(const char* key, int accessor, ModelBuilder& model) {
  ModelBuilder changed = model;
  samplerOf(changed)[key] = accessor;
  return errorOf(changed);
}

TEST(Animation, IsPlainDataWithANameAndADuration) {
  ModelBuilder model = animated();
  model.doc["animations"].push_back(model.doc["animations"][0]);
  model.doc["animations"][1]["name"] = "walk";
  const auto scene = load(model);
  ASSERT_TRUE(scene->motion);
  ASSERT_EQ(scene->motion->animations.size(), 2u);
  EXPECT_EQ(scene->motion->animations[0].name, "animation_0");
  EXPECT_EQ(scene->motion->animations[1].name, "walk");
  EXPECT_EQ(scene->motion->animations[1].duration, 2);
  EXPECT_EQ(scene->motion->animations[0].channels[0].sampler.values, (std::vector<float>{0, 0, 0, 2, 0, 0}));
  const json facts = json::parse(describeScene(*scene));
  EXPECT_EQ(facts["animations"],
            json::parse(R"([{"name": "animation_0", "duration": 2}, {"name": "walk", "duration": 2}])"));
  EXPECT_TRUE(scene->warnings.empty());
}

TEST(Animation, AModelWithoutOneHasNoMotion) {
  ModelBuilder model;
  model.quad();
  const auto scene = load(model);
  EXPECT_FALSE(scene->motion);
  EXPECT_EQ(scene->meshes.size(), scene->fileMeshes);
  EXPECT_FALSE(scene->meshes[0].primitives[0].deformers);
}

TEST(Animation, TimesMustBeFiniteAndNotFall) {
  ModelBuilder model = animated();
  const std::string where = "E_ANIMATION at /animations/0/samplers/0/input";
  const auto times = [&](std::vector<float> list) {
    return errorWith("input", model.accessor(list, 5126, "SCALAR"), model);
  };
  EXPECT_EQ(times({1, 0.5f}), where);
  EXPECT_EQ(times({0, std::numeric_limits<float>::quiet_NaN()}), where);
  EXPECT_EQ(times({0, std::numeric_limits<float>::infinity()}), where);
  EXPECT_EQ(times({1, 1}), "");
  EXPECT_EQ(errorWith("input", 0, model), where);  // VEC3
  EXPECT_EQ(errorWith("input", model.accessor(std::vector<std::uint16_t>{0, 1}, 5123, "SCALAR"), model), where);
}

TEST(Animation, ValuesMustFitTheTimesAndTheTarget) {
  ModelBuilder model = animated();
  const std::string where = "E_ANIMATION at /animations/0/samplers/0/output";
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<float>(9), 5126, "VEC3"), model), where);
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<float>(8), 5126, "VEC4"), model), where);
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<std::uint32_t>(6), 5125, "VEC3"), model), where);
  samplerOf(model)["interpolation"] = "CUBICSPLINE";
  EXPECT_EQ(errorOf(model), where);
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<float>(18), 5126, "VEC3"), model), "");
}

TEST(Animation, WeightsNeedOneNumberForEachTarget) {
  ModelBuilder model = animated();
  model.doc["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  channelOf(model)["target"]["path"] = "weights";
  const std::string where = "E_ANIMATION at /animations/0/samplers/0/output";
  EXPECT_EQ(errorOf(model), where);
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<float>(3), 5126, "SCALAR"), model), where);
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<float>(4), 5126, "SCALAR"), model), "");
  EXPECT_EQ(errorWith("output", model.accessor(std::vector<std::uint8_t>(4), 5121, "SCALAR", true), model), "");
}

TEST(Animation, IndicesMustExist) {
  ModelBuilder model = animated();
  EXPECT_EQ(errorWith("input", 99, model), "E_REF at /animations/0/samplers/0/input");
  channelOf(model)["sampler"] = 1;
  EXPECT_EQ(errorOf(model), "E_REF at /animations/0/channels/0/sampler");
  channelOf(model) = {{"sampler", 0}, {"target", {{"node", 4}, {"path", "scale"}}}};
  EXPECT_EQ(errorOf(model), "E_REF at /animations/0/channels/0/target/node");
}

TEST(Animation, TwoChannelsMustNotMoveTheSame) {
  ModelBuilder model = animated();
  model.doc["animations"][0]["channels"].push_back(channelOf(model));
  EXPECT_EQ(errorOf(model), "E_ANIMATION at /animations/0/channels/1/target");
}

TEST(Animation, ChannelsThatMoveNothingAreTold) {
  ModelBuilder pointer = animated();
  channelOf(pointer)["target"] = {{"path", "pointer"}};
  EXPECT_TRUE(load(pointer)->motion->animations[0].channels.empty());

  ModelBuilder unknown = animated();
  channelOf(unknown)["target"]["path"] = "colour";
  const auto scene = load(unknown);
  EXPECT_TRUE(hasWarning(*scene, "W_ANIMATION"));
  EXPECT_EQ(scene->motion->animations[0].duration, 2);  // three.js counts its times

  ModelBuilder weights = animated();
  channelOf(weights)["target"]["path"] = "weights";
  EXPECT_TRUE(hasWarning(*load(weights), "W_ANIMATION"));

  ModelBuilder elsewhere = animated();
  elsewhere.doc["nodes"].push_back(json::object());
  channelOf(elsewhere)["target"]["node"] = 1;
  EXPECT_TRUE(hasWarning(*load(elsewhere), "W_ANIMATION"));
}

TEST(Animation, UnknownInterpolationsAreLinear) {
  ModelBuilder model = animated();
  samplerOf(model)["interpolation"] = "WOBBLE";
  const auto scene = load(model);
  EXPECT_EQ(scene->motion->animations[0].channels[0].sampler.interpolation, Interpolation::kLinear);
  EXPECT_TRUE(hasWarning(*scene, "W_ENUM"));
}

TEST(Animation, KeyframesAreLimitedBeforeTheyAreRead) {
  ModelBuilder model = animated();
  Limits limits;
  limits.keyframeValues = 7;  // two times and two vectors
  EXPECT_EQ(errorOf(model, limits), "L_KEYFRAME_VALUES at /animations/0/samplers/0/output");
  limits.keyframeValues = 8;
  EXPECT_EQ(errorOf(model, limits), "");
  const int huge = static_cast<int>(model.doc["accessors"].size());
  model.doc["accessors"].push_back({{"componentType", 5126}, {"count", 1ull << 50}, {"type", "SCALAR"}});
  EXPECT_EQ(errorWith("input", huge, model), "L_KEYFRAME_VALUES at /animations/0/samplers/0/input");
}

}  // namespace
}  // namespace telar::test
