#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "brdf/shading.h"

namespace telar::brdf_f {
namespace {

/// What a variant is compared on: a material at one point, and whether it is woven.
struct Case {
  const char* name;
  MaterialInputs inputs;
  bool woven = false;
};

MaterialInputs plain() {
  MaterialInputs m{};
  m.baseColor = {0.5f, 0.3f, 0.2f};
  m.roughness = 0.4f;
  m.ior = 1.5f;
  m.specular = 1;
  m.specularColor = glm::vec3(1);
  m.sheenRoughness = 0.5f;
  m.clearcoatRoughness = 0.2f;
  m.yarnTurn = {1, 0};
  m.anisotropyTexel = {1, 0.5f, 1};
  m.warpSpecularColor = m.weftSpecularColor = glm::vec3(1);
  m.yarnRoughness = glm::vec2(0.5f);
  m.yarnAnisotropy = glm::vec2(0.4f);
  return m;
}

/// Each layer alone, those of cloths together, and all.
std::vector<Case> cases() {
  std::vector<Case> all{{"plain", plain()}};
  const auto add = [&](const char* name, bool woven, auto change) {
    all.push_back({name, plain(), woven});
    change(all.back().inputs);
  };
  const auto sheen = [](MaterialInputs& m) { m.sheenColor = {0.3f, 0.2f, 0.1f}; };
  const auto through = [](MaterialInputs& m) {
    m.diffuseTransmission = 0.4f, m.diffuseTransmissionColor = m.baseColor;
  };
  const auto yarns = [](MaterialInputs& m) { m.yarnCoverage = {0.6f, 0.3f}; };
  add("sheen", false, sheen);
  add("flat", false, [](MaterialInputs& m) { m.flatness = 0.6f; });
  add("knitted", false, [&](MaterialInputs& m) { sheen(m), through(m); });
  add("coated", false, [](MaterialInputs& m) { m.clearcoat = 0.7f; });
  add("woven", true, [&](MaterialInputs& m) { yarns(m), sheen(m), through(m); });
  add("stretched", false, [](MaterialInputs& m) { m.anisotropyVector = {0.6f, 0}; });
  add("rough", false, [](MaterialInputs& m) { m.diffuseRoughness = 0.8f; });
  add("all", true, [&](MaterialInputs& m) {
    yarns(m), sheen(m), through(m);
    m.clearcoat = 0.7f, m.flatness = 0.6f, m.diffuseRoughness = 0.8f;
  });
  return all;
}

SurfaceInfo surfaceOf(const Case& c) {
  const vec3 n(0, 0, 1), v = glm::normalize(vec3(0.5f, 0.2f, 0.7f));
  Normals normals{};
  normals.geometric = normals.shading = normals.coat = n;
  normals.frame = glm::mat3(1);
  normals.upward = 1;
  SurfaceInfo s;
  readSurface(s, c.inputs, normals, v, true, c.woven);
  s.dfg = splitSum(s.three, s.perceptualRoughness, s.NoV);
  s.coatDfg = splitSum(s.three, s.clearcoatRoughness, s.clearcoatNoV);
  return s;
}

/// Directions over the whole sphere.
std::vector<vec3> directions() {
  std::vector<vec3> all;
  for (int i = 0; i < 20; ++i) {
    const float z = 1 - (2 * static_cast<float>(i) + 1) / 20, phi = 2.4f * static_cast<float>(i),
                r = std::sqrt(1 - z * z);
    all.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
  }
  return all;
}

/// Largest difference of a variant from the text with every layer on, under single lights and a dome, relative to the
/// largest value.
float differenceOf(const ShadingVariant& variant, ShadingModel shading, const SurfaceInfo& surface) {
  const ShadingFunctions functions = shadingFunctions(shading);
  const SurfaceInfo whole = functions.preparedSurface(surface);
  const LobeMixture wholeLobes = lobeMixture(whole);
  SurfaceInfo own = surface;
  variant.prepare(own);
  LobeMixture lobes;
  variant.lobeMixture(own, lobes);
  const auto composed = [&](const Reflected& lit) {
    return functions.composedRadiance(whole, lit.diffuse, lit, nothingReflected(), vec3(0));
  };
  const auto apart = [](const vec3& a, const vec3& b) { return max3(glm::abs(a - b)); };
  Reflected dome = functions.addDome(nothingReflected(), whole, vec3(1)), ownDome = variant.dome(own, vec3(1));
  if (functions.addBehind) dome = functions.addBehind(dome, whole, vec3(0.5f));
  if (variant.behind) ownDome = variant.behind(ownDome, own, vec3(0.5f));
  float most = apart(variant.composed(own, ownDome.diffuse, ownDome), composed(dome)), largest = composed(dome).x;
  for (const vec3& l : directions()) {
    const Reflected lit = functions.addPunctual(nothingReflected(), whole, l, vec3(1));
    const vec3 expected = composed(lit);
    most = std::max({most, apart(variant.bsdfCosine(own, l, 1), expected),
                     std::abs(variant.pdfMixture(lobes, l) - pdfMixture(wholeLobes, l))});
    largest = std::max({largest, expected.x, pdfMixture(wholeLobes, l)});
  }
  return most / largest;
}

/// Roundings of some hundred operations in float: sums are in another order where a layer is left out.
constexpr float ROUNDING = 2e-5f;

TEST(ShadingVariant, LeavesOutNothingThatASurfaceHas) {
  for (const ShadingModel shading : {ShadingModel::kThree, ShadingModel::kFabric}) {
    for (const Case& c : cases()) {
      if (c.woven && shading == ShadingModel::kThree) continue;
      const SurfaceInfo surface = surfaceOf(c);
      EXPECT_LT(differenceOf(shadingVariant(shading, surface), shading, surface), ROUNDING)
          << c.name << ", shading " << static_cast<int>(shading);
    }
  }
}

// The planted fault: the variant of a plain surface, on one that has a layer.
TEST(ShadingVariant, OneThatLeavesOutALayerIsTold) {
  const std::vector<Case> all = cases();
  const ShadingVariant& bare = shadingVariant(ShadingModel::kFabric, surfaceOf(all[0]));
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GT(differenceOf(bare, ShadingModel::kFabric, surfaceOf(all[i])), 100 * ROUNDING) << all[i].name;
  }
}

TEST(ShadingVariant, SamplesFollowItsDensity) {
  // A mean of 1 / pdf over the directions drawn is the solid angle that they reach, up to the sphere's.
  for (const Case& c : cases()) {
    SurfaceInfo s = surfaceOf(c);
    const ShadingVariant& variant = shadingVariant(ShadingModel::kFabric, s);
    variant.prepare(s);
    LobeMixture lobes;
    variant.lobeMixture(s, lobes);
    constexpr int SIDE = 256;
    double upper = 0;
    for (int i = 0; i < SIDE * SIDE; ++i) {
      const vec2 u = (vec2(i % SIDE, i / SIDE) + 0.5f) / static_cast<float>(SIDE);
      const vec3 l = variant.sampleMixture(lobes, u);
      const float pdf = variant.pdfMixture(lobes, l);
      // Cosine-weighted over the upper side: pi.
      if (pdf > 0 && l.z > 0) upper += l.z / pdf;
    }
    EXPECT_NEAR(upper / (SIDE * SIDE), 3.14159265, 0.02) << c.name;
  }
}

}  // namespace
}  // namespace telar::brdf_f
