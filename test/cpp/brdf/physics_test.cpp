#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "brdf/brdf.h"
#include "brdf/quadrature.h"
#include "brdf/terms.h"

/// Energy, reciprocity and normalisation, by quadrature in double.
namespace telar::test::physics_test {
namespace {

using namespace brdf_d;
using glm::dvec3;

constexpr int STRATA = 256;

TEST(Distribution, GgxProjectsToUnitArea) {
  for (const double roughness : {0.0, 0.045, 0.1, 0.3, 0.5, 0.8, 1.0}) {
    const double alpha = alphaFromRoughness(roughness);
    EXPECT_NEAR(projectedArea([&](double NoH) { return D_GGX(alpha, NoH); }), 1, 1e-5) << "roughness " << roughness;
  }
}

TEST(Specular, IsReciprocal) {
  const Term* row = nullptr;
  for (const Term& term : terms()) {
    if (term.name == "Fr_GGX") row = &term;
  }
  ASSERT_TRUE(row);
  const std::vector<float> rows = samples(*row, 4096);
  for (std::size_t i = 0; i < rows.size(); i += MAX_COLUMNS) {
    std::vector<double> p(rows.begin() + i, rows.begin() + i + MAX_COLUMNS);
    const vec3 forward = row->inDouble(p.data());
    std::swap(p[5], p[6]);  // NoV, NoL
    const vec3 backward = row->inDouble(p.data());
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(forward[k], backward[k], 1e-5 * std::max(std::abs(forward[k]), 1e-6));
  }
}

TEST(Specular, NeverReflectsMoreThanArrives) {
  for (const double roughness : {0.045, 0.1, 0.3, 0.5, 0.8, 1.0}) {
    for (const double NoV : {0.02, 0.1, 0.3, 0.6, 1.0}) {
      const double alpha = alphaFromRoughness(roughness);
      const vec3 albedo = lobeOverGgx(STRATA, alpha, NoV, [&](double NoL, double NoH, double LoH) {
        return Fr_GGX(vec3(1), 1, alpha, NoV, NoL, NoH, LoH);
      });
      EXPECT_LE(albedo.x, 1.001) << roughness << " " << NoV;
      // With f0 = f90 = 1 the lobe is A + B, whatever stands for Schlick's power.
      const vec2 ab = splitSum(alpha, NoV);
      EXPECT_NEAR(albedo.x, ab.x + ab.y, 1e-9) << roughness << " " << NoV;
    }
  }
}

TEST(Fresnel, ExponentialFormStaysNearTheFifthPower) {
  for (double LoH = 0; LoH <= 1; LoH += 1e-3) EXPECT_NEAR(F_SchlickWeight(LoH), std::pow(1 - LoH, 5), 0.0038) << LoH;
}

TEST(Multiscatter, AverageReflectanceIsTheCosineMeanOfSchlick) {
  double mean = 0;
  constexpr int STEPS = 10000;
  for (int i = 0; i < STEPS; ++i) {
    const double mu = (i + 0.5) / STEPS;
    mean += 2 * mu * (0.04 + 0.96 * std::pow(1 - mu, 5)) / STEPS;
  }
  EXPECT_NEAR(F_SchlickAverage(vec3(0.04)).x, mean, 1e-6);
}

/// Colour of a white material in a uniform environment of radiance 1.
double environmentFurnace(vec2 ab, vec3 baseColor, double metallic) {
  const Scattering dielectric = multipleScattering(vec3(F0_DIELECTRIC), 1, ab);
  const Scattering metal = multipleScattering(baseColor, 1, ab);
  const vec3 specular = environmentSpecular(mixScattering(dielectric, metal, metallic), vec3(1), vec3(1));
  return (specular + diffuseAlbedo(baseColor, metallic) * diffuseShare(dielectric)).x;
}

TEST(WhiteFurnace, EnvironmentLightComesBackWhole) {
  for (const double roughness : {0.0, 0.01, 0.089, 0.2, 0.5, 0.8, 1.0}) {
    for (const double NoV : {0.001, 0.05, 0.1, 0.3, 0.6, 0.9, 1.0}) {
      const vec2 ab = splitSum(alphaFromRoughness(roughness), NoV);
      for (const double metallic : {0.0, 0.5, 1.0}) {
        EXPECT_NEAR(environmentFurnace(ab, vec3(1), metallic), 1, 1e-3) << roughness << " " << NoV << " " << metallic;
      }
      // A grey metal keeps less than it is white, and more than its single bounce.
      const double grey = environmentFurnace(ab, vec3(0.5), 1);
      EXPECT_LT(grey, 1);
      EXPECT_GE(grey, 0.5 * ab.x + ab.y);
    }
  }
}

/// Albedo of a white dielectric under punctual lights from everywhere.
double directFurnace(double roughness, double NoV) {
  const double alpha = alphaFromRoughness(roughness);
  const vec3 f0(F0_DIELECTRIC);
  const vec3 specular = lobeOverGgx(
      STRATA, alpha, NoV, [&](double NoL, double NoH, double LoH) { return Fr_GGX(f0, 1, alpha, NoV, NoL, NoH, LoH); });
  const vec3 v = direction(NoV, 0), n(0, 0, 1);
  const vec3 diffuse = overCosine(STRATA, [&](const vec3& l) {
    return Fd_Lambert(vec3(1)) * (vec3(1) - F_Schlick(f0, 1, glm::dot(l, halfVector(n, l, v))));
  });
  return (specular * directCompensation(f0, splitSum(alpha, NoV)) + diffuse).x;
}

TEST(WhiteFurnace, DirectLightIsAsOffAsThreeIs) {
  const double cosines[] = {0.05, 0.1, 0.3, 0.6, 1};
  const double smooth[] = {1.33, 1.28, 1.12, 1.01, 1.00}, rough[] = {1.00, 0.99, 0.98, 0.98, 0.97};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(directFurnace(0.3, cosines[i]), smooth[i], 0.006) << cosines[i];
    EXPECT_NEAR(directFurnace(1.0, cosines[i]), rough[i], 0.006) << cosines[i];
  }
}

TEST(WhiteFurnace, DirectLightOnWhiteMetalComesBackWhole) {
  for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
    for (const double NoV : {0.1, 0.3, 0.6, 1.0}) {
      const double alpha = alphaFromRoughness(roughness);
      const vec3 single = lobeOverGgx(STRATA, alpha, NoV, [&](double NoL, double NoH, double LoH) {
        return Fr_GGX(vec3(1), 1, alpha, NoV, NoL, NoH, LoH);
      });
      EXPECT_NEAR((single * directCompensation(vec3(1), splitSum(alpha, NoV))).x, 1, 1e-9) << roughness << " " << NoV;
      EXPECT_EQ(directCompensation(vec3(0), splitSum(alpha, NoV)), vec3(1)) << "nothing is reflected more than once";
    }
  }
}

TEST(Roughness, FloorComesFirstThenTheCurvature) {
  EXPECT_DOUBLE_EQ(shadedRoughness(0.3, 0.05), 0.35);
  EXPECT_DOUBLE_EQ(shadedRoughness(0.01, 0.02), 0.065);
  EXPECT_DOUBLE_EQ(shadedRoughness(0.9, 0.3), 1);
  EXPECT_DOUBLE_EQ(geometricRoughness(vec3(0.1, -0.4, 0), vec3(0, 0.2, -0.3)), 0.4);
  EXPECT_DOUBLE_EQ(alphaFromRoughness(0.5), 0.25);
  EXPECT_DOUBLE_EQ(alphaFromRoughness(0), 0.045 * 0.045);
}

TEST(Environment, ReflectionTurnsToTheNormalWithTheFourthPowerOfRoughness) {
  const vec3 n(0, 0, 1), v = glm::normalize(vec3(1, 0, 1)), mirrored(-v.x, 0, v.z);
  EXPECT_LT(glm::distance(dominantReflection(0, n, v), mirrored), 1e-12);
  EXPECT_LT(glm::distance(dominantReflection(1, n, v), n), 1e-12);
  EXPECT_LT(glm::distance(dominantReflection(0.5, n, v), glm::normalize(mirrored * (15.0 / 16) + n / 16.0)), 1e-12);
}

double half(unsigned bits) {
  const int exponent = (bits >> 10) & 31;
  const double fraction = bits & 1023;
  return exponent ? std::ldexp(1 + fraction / 1024, exponent - 15) : std::ldexp(fraction, -24);
}

TEST(Environment, TableOfThreeIsTheIntegralOfTheseTerms) {
  const std::string path = TELAR_SOURCE_DIR "/node_modules/three/src/renderers/shaders/DFGLUTData.js";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "three is not installed";
  const std::string text = readFile(path);
  std::vector<double> table;
  for (std::size_t at = text.find("0x"); at != std::string::npos; at = text.find("0x", at + 2)) {
    table.push_back(half(static_cast<unsigned>(std::stoul(text.substr(at + 2, 4), nullptr, 16))));
  }
  ASSERT_EQ(table.size(), 16u * 16 * 2);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column) {
      const double roughness = (column + 0.5) / 16;
      const vec2 ab = splitSum(roughness * roughness, (row + 0.5) / 16);
      EXPECT_NEAR(table[(row * 16 + column) * 2], ab.x, 0.01) << row << " " << column;
      EXPECT_NEAR(table[(row * 16 + column) * 2 + 1], ab.y, 0.001) << row << " " << column;
    }
  }
}

TEST(Light, HalfVectorOfOppositeDirectionsIsTheNormal) {
  const vec3 n(0, 0.6, 0.8);
  EXPECT_EQ(halfVector(n, vec3(0, 0, -1), vec3(0, 0, 1)), n);
}

TEST(Light, AttenuationIsTheInverseSquareWithinItsRange) {
  EXPECT_DOUBLE_EQ(distanceAttenuation(2, 0), 0.25);
  EXPECT_DOUBLE_EQ(distanceAttenuation(0, 0), 100);
  EXPECT_DOUBLE_EQ(distanceAttenuation(10, 10), 0);
  EXPECT_DOUBLE_EQ(distanceAttenuation(20, 10), 0);
  EXPECT_NEAR(distanceAttenuation(5, 10), 0.04 * std::pow(1 - std::pow(0.5, 4), 2), 1e-15);
}

TEST(Light, SpotConeIsHardWhereBothAnglesAreEqual) {
  const double outer = std::cos(0.5);
  EXPECT_EQ(spotAttenuation(outer, outer, std::cos(0.5001)), 0);
  EXPECT_EQ(spotAttenuation(outer, outer, std::cos(0.4999)), 1);
  EXPECT_NEAR(spotAttenuation(0.8, 0.9, 0.85), 0.5, 1e-12);
}

TEST(Environment, LodAndRoughnessAreInverse) {
  for (const double maxLod : {5.0, 6.0, 7.0}) {
    for (double lod = 0; lod <= maxLod; ++lod) {
      EXPECT_NEAR(lodFromRoughness(1 - std::sqrt(1 - lod / maxLod), maxLod), lod, 1e-12);
    }
  }
}

TEST(Occlusion, IsOneWithoutAnyAndZeroWhenWhole) {
  for (const double roughness : {0.0, 0.3, 1.0}) {
    for (const double NoV : {0.0, 0.2, 1.0}) {
      EXPECT_NEAR(specularOcclusion(roughness, 1, NoV), 1, 1e-12);
      EXPECT_NEAR(specularOcclusion(roughness, 0, NoV), 0, 1e-12);
    }
  }
  EXPECT_DOUBLE_EQ(diffuseOcclusion(0.25, 0.5), 0.625);
}

TEST(AmbientVisibility, ChangesNothingWhereNothingHides) {
  for (const double albedo : {0.0, 0.5, 1.0}) EXPECT_NEAR(multiBounceVisibility(1, dvec3(albedo)).x, 1, 4e-4);
  for (const double roughness : {0.0, 0.3, 0.7, 1.0}) {
    for (const double cosine : {0.02, 0.3, 1.0}) EXPECT_EQ(specularVisibility(1, roughness, cosine, cosine), 1);
    EXPECT_EQ(specularVisibility(0, roughness, 1, 1), 0);
  }
  // A mirror sees what is open and nothing of what is not, but for a cone's width.
  EXPECT_GT(specularVisibility(0.5, 0, 1, 1), 0.99);
  EXPECT_EQ(specularVisibility(0.5, 0, 0.2, 0.9), 0);
}

TEST(AmbientVisibility, LightBetweenFoldsIsThatOfTheirColour) {
  // Jimenez et al. 2016, figure 7: a white corner is lighter than its visibility says, a black one is not.
  for (double visibility = 0.05; visibility < 1; visibility += 0.05) {
    const dvec3 lit = multiBounceVisibility(visibility, dvec3(0, 0.5, 0.9));
    EXPECT_EQ(lit.x, visibility);
    EXPECT_GT(lit.y, visibility);
    EXPECT_GT(lit.z, lit.y);
    EXPECT_LE(lit.z, 1);
  }
}

TEST(AmbientVisibility, ArcCosineIsWithinItsBound) {
  double most = 0;
  for (double x = -1; x <= 1; x += 1e-4) most = std::max(most, std::abs(arcCosine(x) - std::acos(x)));
  EXPECT_LT(most, 7e-5);
}

/// Of a sphere cut into rings, the part within both cones.
double conesByQuadrature(double a, double b, double between) {
  constexpr int RINGS = 800, STEPS = 1600;
  const double pi = std::numbers::pi;
  const dvec3 axis(std::sin(between), 0, std::cos(between));
  double sum = 0;
  for (int i = 0; i < RINGS; ++i) {
    const double theta = a * (i + 0.5) / RINGS;
    for (int k = 0; k < STEPS; ++k) {
      const double phi = 2 * pi * (k + 0.5) / STEPS;
      const dvec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      if (dot(d, axis) > std::cos(b)) sum += std::sin(theta);
    }
  }
  return sum * (a / RINGS) * (2 * pi / STEPS) / (2 * pi);
}

TEST(AmbientVisibility, ConesMeetAboutAsTheyDo) {
  // The smooth step of the source is that far from the lens of two caps: told where half of the smaller one is within.
  constexpr double STEP_ERROR = 0.12;
  double most = 0;
  for (const double a : {0.4, 0.9, 1.4}) {
    for (const double b : {0.5, 1.2}) {
      for (const double between : {0.0, 0.3, 0.8, 1.3, 1.9}) {
        const double whole = std::min(1 - std::cos(a), 1 - std::cos(b));
        const double fit = conesIntersection(std::cos(a), std::cos(b), std::cos(between));
        most = std::max(most, std::abs(fit - conesByQuadrature(a, b, between)) / whole);
      }
    }
  }
  EXPECT_LT(most, STEP_ERROR);
  EXPECT_GT(
      std::abs(conesIntersection(std::cos(0.9), std::cos(0.5), std::cos(0.8)) - conesByQuadrature(0.9, 0.5, 1.2)) /
          (1 - std::cos(0.5)),
      STEP_ERROR)
      << "an axis 0.4 radians farther";
  EXPECT_EQ(conesIntersection(std::cos(0.4), std::cos(0.4), std::cos(1.0)), 0) << "apart";
}

}  // namespace
}  // namespace telar::test::physics_test
