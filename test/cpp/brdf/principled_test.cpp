#include <gtest/gtest.h>

#include <array>
#include <random>

#include "brdf/quadrature.h"
#include "brdf/shading.h"
#include "shading_terms.h"

/// The principled shadings as they are composed: figures by quadrature of what addPunctual gives, against figures
/// computed apart from this code.
namespace telar::test::principled_test {
namespace {

using namespace brdf_d;
using Terms = ShadingTerms;

constexpr int STRATA = 300;
constexpr double NOV[] = {0.02, 0.1, 0.3, 0.6, 1};
constexpr ShadingModel BASES[] = {ShadingModel::kThreeR115, ShadingModel::kDisney2012};

const ShadingFunctions& shading() {
  static const ShadingFunctions functions = shadingFunctions(ShadingModel::kThreeR115);
  return functions;
}

/// White plain cloth, seen at NoV: what a material reader hands over.
SurfaceInfo cloth(const Terms& terms, double roughness, double NoV) {
  SurfaceInfo s{};
  s.terms = terms;
  s.n = s.coatNormal = vec3(0, 0, 1);
  s.v = direction(NoV, 0);
  s.t = vec3(1, 0, 0);
  s.b = vec3(0, 1, 0);
  s.baseColor = s.diffuse = vec3(1);
  s.f0 = s.f0Dielectric = vec3(F0_DIELECTRIC);
  s.f90 = 1;
  s.perceptualRoughness = roughness;
  s.NoV = s.clearcoatNoV = NoV;
  s.sheenRoughness = 0.5;
  s.clearcoatRoughness = 0.3;
  s.dfg = s.coatDfg = vec2(0.7, 0.05);
  return s;
}

SurfaceInfo cloth(ShadingModel base, double roughness, double NoV) { return cloth(termsOf(base), roughness, NoV); }

Reflected lit(const SurfaceInfo& prepared, const vec3& l, const vec3& color = vec3(1)) {
  return shading().addPunctual(nothingReflected(), prepared, l, color);
}

/// Albedo of one lobe: lit from everywhere.
double albedo(const SurfaceInfo& surface, vec3 Reflected::*lobe) {
  const SurfaceInfo s = shading().preparedSurface(surface);
  return overHemisphere(STRATA, [&](const vec3& l) { return (lit(s, l).*lobe).x; });
}

/// Of the coat, whose lobe is narrow.
double coatAlbedo(const SurfaceInfo& surface, double width) {
  const SurfaceInfo s = shading().preparedSurface(surface);
  return overGgx(500, width, s.v, [&](const vec3& l) { return lit(s, l).coat.x / l.z; });
}

template <class MakeSurface>
void expectRow(const std::array<double, 5>& expected, vec3 Reflected::*lobe, MakeSurface surfaceAt) {
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(albedo(surfaceAt(NOV[i]), lobe), expected[i], 1e-3) << "NoV " << NOV[i];
}

TEST(Disney2012Composed, DiffuseRows) {
  const auto disney = [](double roughness, double flatness) {
    return [=](double NoV) {
      SurfaceInfo s = cloth(ShadingModel::kDisney2012, roughness, NoV);
      s.flatness = flatness;
      return s;
    };
  };
  expectRow({0.53499, 0.68797, 0.89416, 0.97119, 0.97619}, &Reflected::diffuse, disney(0, 0));
  expectRow({1.01108, 1.02347, 1.01944, 1.00566, 1.00595}, &Reflected::diffuse, disney(0.5, 0));
  expectRow({1.51876, 1.38013, 1.15103, 1.04052, 1.03571}, &Reflected::diffuse, disney(1, 0));
  expectRow({1.10672, 1.27577, 1.25286, 0.99591, 0.75425}, &Reflected::diffuse, disney(0.5, 1));
  expectRow({1.50391, 1.49453, 1.30996, 1.00904, 0.75983}, &Reflected::diffuse, disney(1, 1));
  expectRow({1.00580, 0.91399, 0.76227, 0.68909, 0.68590}, &Reflected::diffuse, [](double NoV) {
    Terms terms = termsOf(ShadingModel::kDisney2012);
    terms.diffuse = Terms::DIFFUSE_FROSTBITE;
    return cloth(terms, 1, NoV);
  });
}

TEST(Disney2012Composed, SheenRow) {
  expectRow({0.08357, 0.06599, 0.03418, 0.00977, 0.00026}, &Reflected::sheen, [](double NoV) {
    SurfaceInfo s = cloth(ShadingModel::kDisney2012, 1, NoV);
    s.sheenColor = vec3(1);
    return s;
  });
}

TEST(Disney2012Composed, ClearcoatRow) {
  const double cosines[] = {0.05, 0.1, 0.3, 0.6, 1}, expected[] = {0.04391, 0.03924, 0.02297, 0.01057, 0.00814};
  for (int i = 0; i < 5; ++i) {
    SurfaceInfo s = cloth(ShadingModel::kDisney2012, 1, cosines[i]);
    s.clearcoat = 1;
    s.clearcoatRoughness = 1;  // the roughest it has: gloss 0
    EXPECT_NEAR(coatAlbedo(s, 0.5), expected[i], 1e-3) << cosines[i];
    const SurfaceInfo prepared = shading().preparedSurface(s);
    SurfaceInfo bare = s;
    bare.clearcoat = 0;
    const vec3 l = direction(0.4, 1);
    EXPECT_EQ(lit(prepared, l).diffuse, lit(shading().preparedSurface(bare), l).diffuse);
  }
}

TEST(R115Composed, DiffuseIsLambertOfAllTheLight) {
  for (const double NoV : NOV)
    EXPECT_NEAR(albedo(cloth(ShadingModel::kThreeR115, 1, NoV), &Reflected::diffuse), 1, 1e-5);
}

TEST(R115Composed, SheenStandsInPlaceOfTheGloss) {
  const auto velvet = [](double NoV) {
    SurfaceInfo s = cloth(ShadingModel::kThreeR115, 0.5, NoV);
    s.sheenColor = vec3(1);
    return s;
  };
  expectRow({0.61160, 0.53860, 0.37876, 0.22241, 0.08339}, &Reflected::sheen, velvet);
  for (const double NoV : NOV) {
    EXPECT_EQ(albedo(velvet(NoV), &Reflected::specular), 0);
    EXPECT_NEAR(albedo(velvet(NoV), &Reflected::diffuse), 1, 1e-5);
    const SurfaceInfo s = shading().preparedSurface(velvet(NoV));
    const Reflected around = shading().addEnvironment(nothingReflected(), s, {vec3(0), vec3(1), vec3(1), vec3(1)});
    EXPECT_EQ(around.sheen, vec3(0));
    EXPECT_GT(around.specular.x, 0);
    EXPECT_EQ(shading().addDome(nothingReflected(), s, vec3(1)).sheen, vec3(0));
  }
}

TEST(R115Composed, CoatTakesItsReflectivityFromWhatLiesBeneath) {
  const double cosines[] = {0.05, 0.1, 0.3, 0.6, 1};
  const double dhr[] = {0.404, 0.318, 0.119, 0.045, 0.040}, own[] = {0.39059, 0.34398, 0.16722, 0.05400, 0.03984};
  for (int i = 0; i < 5; ++i) {
    SurfaceInfo s = cloth(ShadingModel::kThreeR115, 0.7, cosines[i]);
    const SurfaceInfo bare = shading().preparedSurface(s);
    s.clearcoat = 1;
    EXPECT_NEAR(coatAlbedo(s, 0.09), own[i], 1e-3) << cosines[i];
    const SurfaceInfo coated = shading().preparedSurface(s);
    // By the angle of the light, for both lobes.
    const vec3 l = direction(cosines[i], 1);
    EXPECT_NEAR(lit(coated, l).diffuse.x / lit(bare, l).diffuse.x, 1 - dhr[i], 1e-3);
    EXPECT_NEAR(lit(coated, l).specular.x / lit(bare, l).specular.x, 1 - dhr[i], 1e-3);
    // By the angle of the viewer, for single scattering alone.
    const Incident sharp{vec3(0), vec3(0), vec3(1), vec3(0)}, mean{vec3(0), vec3(1), vec3(0), vec3(0)};
    const auto around = [](const SurfaceInfo& surface, const Incident& incident) {
      return shading().addEnvironment(nothingReflected(), surface, incident);
    };
    EXPECT_NEAR(around(coated, sharp).specular.x / around(bare, sharp).specular.x, 1 - dhr[i], 1e-3);
    EXPECT_EQ(around(coated, mean).specular, around(bare, mean).specular);
    EXPECT_EQ(around(coated, mean).diffuse, around(bare, mean).diffuse);
  }
}

TEST(R115Composed, ParametersOfTheListings) {
  SurfaceInfo s = cloth(ShadingModel::kThreeR115, 0, 0.5);
  s.baseColor = vec3(0.8, 0.4, 0.2);
  s.metallic = 0.25;
  s = shading().preparedSurface(s);
  EXPECT_EQ(s.perceptualRoughness, 0.04);
  EXPECT_NEAR(s.alpha, 0.0016, 1e-12);
  EXPECT_NEAR(s.f0.x, 0.04 * 0.75 + 0.8 * 0.25, 1e-12);  // 0.16 * 0.5^2, the reflectivity of an index of 1.5
  EXPECT_NEAR(s.f0.z, 0.04 * 0.75 + 0.2 * 0.25, 1e-12);
}

TEST(Disney2012Composed, GltfAsItsParameters) {
  SurfaceInfo s = cloth(ShadingModel::kDisney2012, 0.5, 0.5);
  s.anisotropyStrength = 0.6;
  const double alpha = 0.25, alphaT = alpha + (1 - alpha) * 0.36;
  s = shading().preparedSurface(s);
  EXPECT_NEAR(s.alphaT / s.alpha, alphaT / alpha, 1e-12);
  EXPECT_NEAR(s.alphaT * s.alpha, alpha * alpha, 1e-12);
  s = cloth(ShadingModel::kDisney2012, 0.1, 0.5);
  s.anisotropyStrength = 1;
  s = shading().preparedSurface(s);
  EXPECT_NEAR(s.alphaT / s.alpha, 10, 1e-9);  // the longest there is
  EXPECT_NEAR(shading().preparedSurface(cloth(ShadingModel::kDisney2012, 0.5, 0.5)).f0.x, 0.04, 1e-12);
  // A tint that is on the way from white to the hue of the base colour is met, in hue and brightness.
  SurfaceInfo tinted = cloth(ShadingModel::kDisney2012, 0.5, 0.5);
  tinted.baseColor = vec3(0.6, 0.2, 0.1);
  tinted.sheenColor = vec3(0.3) * mix(vec3(1), tintDisney(tinted.baseColor), 0.4);
  const vec3 expected = tinted.sheenColor;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(shading().preparedSurface(tinted).sheenColor[c], expected[c], 1e-12);
}

TEST(PrincipledComposed, ADomeIsLightFromEverywhere) {
  for (const int diffuse : {Terms::DIFFUSE_LAMBERT, Terms::DIFFUSE_DISNEY_2012, Terms::DIFFUSE_FROSTBITE,
                            Terms::DIFFUSE_EON, Terms::DIFFUSE_DISNEY_2015_THIN}) {
    for (const double roughness : {0.2, 0.6, 1.0}) {
      for (const double NoV : {0.05, 0.3, 0.8}) {
        Terms terms = termsOf(ShadingModel::kDisney2012);
        terms.diffuse = diffuse;
        SurfaceInfo s = cloth(terms, roughness, NoV);
        s.flatness = 0.4;
        s.diffuseTransmission = 0.25;
        const double dome =
            shading().addDome(nothingReflected(), shading().preparedSurface(s), vec3(TWO_PI / 2)).diffuse.x;
        EXPECT_NEAR(albedo(s, &Reflected::diffuse), dome, 2e-3) << diffuse << " " << roughness << " " << NoV;
      }
    }
  }
}

TEST(PrincipledComposed, SheenOfADomeIsThatOfItsLobe) {
  const std::pair<int, double> within[] = {
      {Terms::SHEEN_CHARLIE_NEUBELT, 0.015},  {Terms::SHEEN_DISNEY_2012, 5e-4},
      {Terms::SHEEN_ASHIKHMIN_VELVET, 0.035}, {Terms::SHEEN_CHARLIE_ESTEVEZ_KULLA, 0.06},
      {Terms::SHEEN_ZELTNER, 0.01},           {Terms::SHEEN_UNCHARTED_4, 1e-4}};
  for (const auto& [sheen, tolerance] : within) {
    for (const double roughness : {0.2, 0.5, 1.0}) {
      for (const double NoV : {0.05, 0.3, 0.8}) {
        Terms terms = termsOf(ShadingModel::kDisney2012);
        terms.sheen = sheen;
        SurfaceInfo s = cloth(terms, roughness, NoV);
        s.sheenColor = vec3(1);
        s.sheenRoughness = roughness;
        const double dome =
            shading().addDome(nothingReflected(), shading().preparedSurface(s), vec3(TWO_PI / 2)).sheen.x;
        EXPECT_NEAR(albedo(s, &Reflected::sheen), dome, tolerance) << sheen << " " << roughness << " " << NoV;
      }
    }
  }
}

TEST(PrincipledComposed, ThinClothReflectsAndTransmitsNoMoreThanArrives) {
  Terms terms = termsOf(ShadingModel::kDisney2012);
  terms.diffuse = Terms::DIFFUSE_DISNEY_2015_THIN;
  SurfaceInfo s = cloth(terms, 0.3, 0.7);
  s.diffuseTransmission = 0.4;
  s.transmittedColor = vec3(1, 0.5, 0.25);
  s = shading().preparedSurface(s);
  const vec3 behind = overHemisphere(STRATA, [&](const vec3& l) { return lit(s, vec3(l.x, l.y, -l.z)).diffuse; });
  EXPECT_NEAR(behind.x, 0.4, 1e-4);
  EXPECT_NEAR(behind.z, 0.1, 1e-4);
  const double front = overHemisphere(STRATA, [&](const vec3& l) { return lit(s, l).diffuse.x; });
  EXPECT_LE(front + behind.x, 1.01);
  const vec3 dome = shading().addBehind(nothingReflected(), s, vec3(TWO_PI / 2)).diffuse;
  EXPECT_NEAR(behind.x, dome.x, 1e-4);
  EXPECT_NEAR(behind.z, dome.z, 1e-4);
  EXPECT_EQ(lit(s, vec3(0, 0, -1)).specular, vec3(0));
}

/// What a slot has a say in.
struct Say {
  const char* slot;
  int Terms::*member;
  int terms;
  bool diffuse, specular, sheen, coat;  ///< by the light of one direction
};

const Say SAYS[] = {
    {"parameters", &Terms::parameters, 2, true, true, true, true},
    {"diffuse", &Terms::diffuse, 5, true, false, false, false},
    {"distribution", &Terms::distribution, 2, false, true, false, false},
    {"visibility", &Terms::visibility, 2, false, true, false, false},
    {"fresnel", &Terms::fresnel, 2, false, true, false, false},
    {"sheen", &Terms::sheen, 6, false, false, true, false},
    {"clearcoat", &Terms::clearcoat, 2, true, true, true, true},  // its width says what it takes from beneath
    {"layering", &Terms::layering, 2, true, true, true, false},
    {"scattering", &Terms::scattering, 2, false, false, false, false},
    {"environment", &Terms::environment, 3, false, false, false, false},
};

/// A coated, stretched, tinted cloth, with or without the sheen that takes the place of r115's gloss.
SurfaceInfo richCloth(const Terms& terms, bool sheen) {
  SurfaceInfo s = cloth(terms, 0.5, 0.4);
  s.baseColor = s.diffuse = vec3(0.7, 0.4, 0.2);
  s.f0Dielectric = vec3(0.06, 0.04, 0.03);
  s.sheenColor = sheen ? vec3(0.5, 0.4, 0.6) : vec3(0);
  s.clearcoat = 0.5;
  s.anisotropyStrength = 0.6;
  s.flatness = 0.5;
  s.diffuseTransmission = 0.3;
  return s;
}

/// Whether a swap changes the light; and it changes no lobe that the slot has no say in.
bool differs(const Say& say, const Terms& before, const Terms& after, bool sheen) {
  const SurfaceInfo original = shading().preparedSurface(richCloth(before, sheen));
  const SurfaceInfo swapped = shading().preparedSurface(richCloth(after, sheen));
  const vec3 l = direction(0.35, 2);
  const Reflected a = lit(original, l), b = lit(swapped, l);
  EXPECT_TRUE(say.diffuse || a.diffuse == b.diffuse) << say.slot;
  EXPECT_TRUE(say.specular || a.specular == b.specular) << say.slot;
  EXPECT_TRUE(say.sheen || a.sheen == b.sheen) << say.slot;
  EXPECT_TRUE(say.coat || a.coat == b.coat) << say.slot;
  const Incident around{vec3(0), vec3(1), vec3(0.7), vec3(0.6)};
  const auto sum = [](const Reflected& r) { return r.diffuse + r.specular + r.sheen + r.coat; };
  return sum(shading().addEnvironment(a, original, around)) != sum(shading().addEnvironment(b, swapped, around));
}

TEST(PrincipledComposed, ASwappedSlotChangesWhatItHasASayIn) {
  for (const ShadingModel base : BASES) {
    for (const Say& say : SAYS) {
      for (int term = 0; term < say.terms; ++term) {
        Terms terms = termsOf(base);
        if (terms.*say.member == term) continue;
        terms.*say.member = term;
        const bool withSheen = differs(say, termsOf(base), terms, true);
        EXPECT_TRUE(differs(say, termsOf(base), terms, false) || withSheen) << say.slot << " " << term;
      }
    }
  }
}

TEST(PrincipledComposed, EverySlotIsAmongTheTested) {
  int slots = 0;
#define TELAR_COUNT(define, name, ...)                                                                    \
  EXPECT_EQ(SAYS[slots].terms, static_cast<int>(std::initializer_list<const char*>{__VA_ARGS__}.size())); \
  EXPECT_EQ(SAYS[slots].member, &Terms::name);                                                            \
  ++slots;
  TELAR_SHADING_SLOTS(TELAR_COUNT)
#undef TELAR_COUNT
  EXPECT_EQ(static_cast<std::size_t>(slots), std::size(SAYS));
}

TEST(PrincipledComposed, ExtremesAreFiniteAndNotNegative) {
  std::mt19937 random(7);
  const auto unit = [&] {
    std::uniform_real_distribution<float> any(0, 1);
    const float edges[] = {0, 0, 1e-8f, 1e-6f, 1e-4f, 1e-2f, 0.5f, 1, 1};
    return random() % 2 ? any(random) : edges[random() % std::size(edges)];
  };
  const auto unitVector = [&] {
    const float z = 2 * unit() - 1, phi = 6.2831853f * unit(), r = std::sqrt(std::max(0.0f, 1 - z * z));
    return glm::vec3(r * std::cos(phi), r * std::sin(phi), z);
  };
  const auto functions = brdf_f::shadingFunctions(ShadingModel::kDisney2012);
  for (int i = 0; i < 60000; ++i) {
    brdf_f::SurfaceInfo s{};
    for (const Say& say : SAYS) s.terms.*say.member = static_cast<int>(random() % static_cast<unsigned>(say.terms));
    s.n = s.coatNormal = glm::vec3(0, 0, 1);
    s.t = glm::vec3(1, 0, 0), s.b = glm::vec3(0, 1, 0);
    s.v = unitVector();
    s.NoV = s.clearcoatNoV = brdf_f::saturate(s.v.z);
    s.baseColor = {unit(), unit(), unit()};
    s.metallic = unit();
    s.diffuse = brdf_f::diffuseAlbedo(s.baseColor, s.metallic);
    s.f0Dielectric = {unit(), unit(), unit()};
    s.perceptualRoughness = unit(), s.clearcoatRoughness = unit();
    s.sheenRoughness = std::max(unit(), brdf_f::SHEEN_ROUGHNESS_MIN);
    s.sheenColor = {unit(), unit(), unit()};
    s.clearcoat = unit(), s.anisotropyStrength = unit(), s.flatness = unit();
    s.diffuseTransmission = unit(), s.transmittedColor = {unit(), unit(), unit()};
    s.dfg = s.coatDfg = {0.3f + 0.6f * unit(), 0.05f};
    const brdf_f::SurfaceInfo prepared = functions.preparedSurface(s);
    const glm::vec3 l = random() % 16 ? unitVector() : random() % 2 ? -s.v : glm::vec3(0);
    brdf_f::Reflected sum = functions.addPunctual(brdf_f::nothingReflected(), prepared, l, glm::vec3(1));
    sum = functions.addDome(sum, prepared, glm::vec3(1));
    sum = functions.addEnvironment(sum, prepared, {glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1)});
    for (const glm::vec3& lobe : {sum.diffuse, sum.specular, sum.sheen, sum.coat}) {
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(lobe[c]) && lobe[c] >= -1e-6f) << i << ": " << lobe[c];
    }
  }
}

}  // namespace
}  // namespace telar::test::principled_test
