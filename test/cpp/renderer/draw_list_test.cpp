#include "pass/plan/draw_list.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "renderer/scenes.h"

namespace telar {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

TEST(PlanDraws, CompilesOnlyWhatTheMaterialAndTheShotUse) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  const auto plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  ASSERT_EQ(plan.draws.opaque.size(), 1u);
  const shader::VariantKey& key = plan.draws.opaque[0].key;
  EXPECT_TRUE(key.features().empty()) << key.features()[0];
  EXPECT_FALSE(plan.environment);
}

TEST(PlanDraws, InstancingIsCompiledOnlyForInstances) {
  auto scene = sceneOf(spherePrimitive(1, 4));
  Instances instances;
  instances.matrices = {glm::mat4(1), glm::mat4(2)};
  instances.centers = {{0, 0, 1}};
  scene->nodes.push_back(scene->nodes[0]);
  scene->nodes[1].instances = std::make_shared<const Instances>(instances);
  auto plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  ASSERT_EQ(plan.draws.opaque.size(), 2u);
  // Front to back: the centre of the instances is nearer.
  EXPECT_TRUE(plan.draws.opaque[0].key.instancing);
  EXPECT_FALSE(plan.draws.opaque[0].key.instanceColor || plan.draws.opaque[0].key.vertexColor);
  EXPECT_FALSE(plan.draws.opaque[1].key.instancing);
  instances.colors = {glm::vec3(1), glm::vec3(0)};
  scene->nodes[1].instances = std::make_shared<const Instances>(instances);
  plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  EXPECT_TRUE(plan.draws.opaque[0].key.instanceColor && plan.draws.opaque[0].key.vertexColor);
}

TEST(PlanDraws, DeformedMeshesAreSortedByTheSphereOfThree) {
  auto scene = sceneOf(spherePrimitive(1, 4));
  Primitive far = spherePrimitive(1, 4);
  far.center = glm::dvec3(0, 0, 1.5);
  far.material = 0;
  scene->meshes.push_back({"deformed", {far}});
  scene->nodes.push_back(scene->nodes[0]);
  scene->nodes[1].mesh = 1;
  const auto plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  EXPECT_EQ(plan.draws.opaque[0].node, &scene->nodes[1]);
}

TEST(PlanDraws, AMapThatIsMultipliedByZeroIsNotSampled) {
  Material material;
  material.metallicFactor = material.roughnessFactor = 0;
  material.occlusionStrength = 0;
  material.metallicRoughnessTexture.image = material.occlusionTexture.image = material.emissiveTexture.image = 0;
  const auto plan = pass::planDraws(*sceneOf(spherePrimitive(1, 4), material), shotOf(8), Limits{}, false);
  EXPECT_TRUE(plan.draws.opaque[0].key.features().empty());
}

TEST(PlanDraws, YarnsHaveTheRoughnessOfTexelsWhereTheMaterialHasNone) {
  Material material;
  material.metallicFactor = material.roughnessFactor = 0;
  material.metallicRoughnessTexture.image = 0;
  material.fabric.weave = true;
  Shot shot = shotOf(8);
  shot.shading = ShadingModel::kFabric;
  const auto plan = pass::planDraws(*sceneOf(spherePrimitive(1, 4), material), shot, Limits{}, false);
  EXPECT_TRUE(plan.draws.opaque[0].key.metallicRoughnessMap);
}

TEST(PlanDraws, OcclusionIsReadWithRoughnessWhereTheTexelsAreTheSame) {
  const auto together = [](const auto& change) {
    Material material;
    material.metallicRoughnessTexture.image = material.occlusionTexture.image = 0;
    change(material.occlusionTexture);
    const auto plan = pass::planDraws(*sceneOf(spherePrimitive(1, 4), material), shotOf(8), Limits{}, false);
    return plan.draws.opaque[0].key.occlusionWithRoughness;
  };
  EXPECT_TRUE(together([](TextureRef&) {}));
  EXPECT_FALSE(together([](TextureRef& texture) { texture.image = 1; }));
  EXPECT_FALSE(together([](TextureRef& texture) { texture.sampler.wrapS = 33071; }));
  EXPECT_FALSE(together([](TextureRef& texture) { texture.texCoord = 1; }));
  EXPECT_FALSE(together([](TextureRef& texture) { texture.uvTransform[2].x = 0.5f; }));
}

TEST(PlanDraws, ABlendedDoubleSidedSurfaceIsDrawnBackFacesFirst) {
  Material material;
  material.alphaMode = AlphaMode::kBlend;
  material.doubleSided = true;
  const auto scene = sceneOf(spherePrimitive(1, 4), material);
  const auto plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  ASSERT_EQ(plan.draws.blended.size(), 2u);
  EXPECT_TRUE(plan.draws.blended[0].key.flipSided);
  EXPECT_FALSE(plan.draws.blended[1].key.flipSided);
  EXPECT_FALSE(plan.draws.blended[0].castsShadow()) << "its other draw casts it";
  EXPECT_TRUE(plan.draws.blended[1].castsShadow());
}

TEST(PlanDraws, BlendedPointsOfTwoSidesAreDrawnTwiceAsTheyAre) {
  const auto draws = [](bool doubleSided) {
    Material material;
    material.alphaMode = AlphaMode::kBlend;
    material.doubleSided = doubleSided;
    Primitive primitive = spherePrimitive(1, 4);
    primitive.topology = Topology::kPoints;
    return pass::planDraws(*sceneOf(primitive, material), shotOf(8), Limits{}, false).draws.blended.size();
  };
  EXPECT_EQ(draws(true), 2u);
  EXPECT_EQ(draws(false), 1u);
}

TEST(PlanDraws, TrianglesCastShadowsAndGhostsDoNot) {
  const auto castsShadow = [](Topology topology, float opacity) {
    Primitive primitive = spherePrimitive(1, 4);
    primitive.topology = topology;
    Shot shot = shotOf(8);
    shot.ghost = {{{PartQuery::Kind::kMaterial, 0, {}}, opacity}};
    const auto scene = sceneOf(primitive, Material());
    scene->fileMaterials = 1;
    const auto plan = pass::planDraws(*scene, shot, Limits{}, false);
    return plan.draws.shown()[opacity < 1 ? 2 : 0]->at(0).castsShadow();
  };
  EXPECT_TRUE(castsShadow(Topology::kTriangles, 1));
  EXPECT_FALSE(castsShadow(Topology::kPoints, 1));
  EXPECT_FALSE(castsShadow(Topology::kTriangles, 0.5f));
}

TEST(PlanDraws, TheCutoffOfAMapIsThatOfTheMaterialWithoutItsFactor) {
  const auto cutoff = [](float alphaCutoff, float factor) {
    Material material;
    material.alphaCutoff = alphaCutoff, material.baseColorFactor.a = factor;
    pass::DrawItem item;
    item.material = &material;
    return item.textureCutoff();
  };
  EXPECT_FLOAT_EQ(cutoff(0.3f, 1), 0.3f);
  EXPECT_FLOAT_EQ(cutoff(0.3f, 0.5f), 0.6f);
  EXPECT_GT(cutoff(0.3f, 0.2f), 1) << "no texel passes";
  EXPECT_GT(cutoff(0, 0), 1) << "there is nothing of it";
}

TEST(PlanDraws, OnlyABlendedMapThatMayHaveHolesIsMadeAnew) {
  const auto meansOf = [](AlphaMode mode, const char* format, ShadingModel shading) {
    Material material;
    material.alphaMode = mode;
    material.baseColorTexture.image = material.normalTexture.image = 0;
    auto scene = sceneOf(spherePrimitive(1, 4), material);
    Image8 image{1, 1, {255, 255, 255, 255}};
    image.format = format;
    scene->images = std::vector<Image8>{image};
    Shot shot = shotOf(8);
    shot.shading = shading;
    const auto plan = pass::planDraws(*scene, shot, Limits{}, false);
    const auto& key = (mode == AlphaMode::kBlend ? plan.draws.blended : plan.draws.opaque).at(0).key;
    EXPECT_EQ(key.normalHoles, key.alphaMeans);
    return key.alphaMeans;
  };
  EXPECT_TRUE(meansOf(AlphaMode::kBlend, "PNG", ShadingModel::kFabric));
  EXPECT_FALSE(meansOf(AlphaMode::kBlend, "JPEG", ShadingModel::kFabric));
  EXPECT_FALSE(meansOf(AlphaMode::kOpaque, "PNG", ShadingModel::kFabric));
  EXPECT_FALSE(meansOf(AlphaMode::kBlend, "PNG", ShadingModel::kThree));
}

TEST(PlanDraws, BlendedSurfacesAreDrawnFarToNear) {
  Material material;
  material.alphaMode = AlphaMode::kBlend;
  const auto scene = sceneOf(spherePrimitive(0.1f, 4), material);
  Node far = scene->nodes[0];
  far.world[3] = glm::dvec4(0, 0, -1, 1);
  scene->nodes.push_back(far);
  const auto plan = pass::planDraws(*scene, shotOf(8), Limits{}, false);
  ASSERT_EQ(plan.draws.blended.size(), 2u);
  EXPECT_EQ(plan.draws.blended[0].node, &scene->nodes[1]);
}

TEST(PlanDraws, AnUnknownVariantNamesTheKnownOnes) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  scene->variants = {"natural", "indigo"};
  Shot shot = shotOf(8);
  shot.variant = "red";
  try {
    pass::planDraws(*scene, shot, Limits{}, false);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "E_VARIANT");
    EXPECT_NE(std::string(error.what()).find("\"indigo\""), std::string::npos);
  }
}

TEST(PlanDraws, AMirroredNodeTurnsTheWindingRound) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  scene->nodes[0].world[0][0] = -1;
  EXPECT_TRUE(pass::planDraws(*scene, shotOf(8), Limits{}, false).draws.opaque[0].mirrored);
}

TEST(PlanDraws, LightsAreLimited) {
  Shot shot = shotOf(8);
  shot.lights.assign(3, Shot::Light{Shot::Light::Type::kPoint});
  Limits limits;
  limits.lights = 2;
  EXPECT_ERROR(planFrame(*sceneOf(spherePrimitive(1, 4)), shot, limits), "L_LIGHTS");
}

TEST(PlanFrame, NamesFeaturesAndPasses) {
  Shot shot = shotOf(8);
  shot.lights.push_back({Shot::Light::Type::kPoint});
  shot.toneMapping = ToneMapping::kAgx;
  const auto json = nlohmann::json::parse(planFrame(*sceneOf(spherePrimitive(1, 4)), shot, Limits{}));
  EXPECT_EQ(json["features"], nlohmann::json::array({"1 point-light", "tone-mapping-agx"}));
  EXPECT_EQ(json["passes"], nlohmann::json::array({"opaque", "resolve"}));
}

}  // namespace
}  // namespace telar
