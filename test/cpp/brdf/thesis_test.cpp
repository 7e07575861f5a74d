#include <gtest/gtest.h>

#include <cmath>

#include "brdf/brdf.h"
#include "brdf/quadrature.h"

/// The models of the thesis: directional albedos by quadrature in double, against figures computed apart from this
/// code.
namespace telar::test::thesis_test {
namespace {

using namespace brdf_d;

constexpr int STRATA = 400;  // a side
constexpr double NOV[] = {0.02, 0.1, 0.3, 0.6, 1};

/// Integral of f(l, h, NoL, NoH, LoH) NoL over the hemisphere, for one view.
template <class Lobe>
double albedo(double NoV, Lobe f) {
  const vec3 v = direction(NoV, 0);
  return overHemisphere(STRATA, [&](const vec3& l) {
    const vec3 h = halfVector(vec3(0, 0, 1), l, v);
    return f(l, h, l.z, h.z, glm::dot(l, h)) * l.z;
  });
}

template <class Lobe>
void expectAlbedos(const double (&expected)[5], double tolerance, Lobe lobeOf) {
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(albedo(NOV[i], lobeOf(NOV[i])), expected[i], tolerance) << "NoV " << NOV[i];
}

auto burley(double roughness) {
  return [=](double NoV) {
    return
        [=](vec3, vec3, double NoL, double, double LoH) { return RECIPROCAL_PI * Fd_Burley(roughness, NoV, NoL, LoH); };
  };
}

TEST(Disney2012, DiffuseAlbedo) {
  // Figures have two decimals.
  expectAlbedos({0.54, 0.69, 0.89, 0.97, 0.98}, 0.006, burley(0));
  expectAlbedos({1.01, 1.02, 1.02, 1.01, 1.01}, 0.006, burley(0.5));
  expectAlbedos({1.52, 1.38, 1.15, 1.04, 1.04}, 0.006, burley(1));
  expectAlbedos({1.01, 0.91, 0.76, 0.69, 0.69}, 0.006, [](double NoV) {
    return [=](vec3, vec3, double NoL, double, double LoH) {
      return RECIPROCAL_PI * Fd_BurleyRenormalised(1, NoV, NoL, LoH);
    };
  });
  expectAlbedos({1.50, 1.49, 1.31, 1.01, 0.76}, 0.006, [](double NoV) {
    return [=](vec3, vec3, double NoL, double, double LoH) {
      return RECIPROCAL_PI * Fd_HanrahanKrueger(1, NoV, NoL, LoH);
    };
  });
}

TEST(Disney2012, SheenAlbedo) {
  expectAlbedos({0.084, 0.066, 0.034, 0.010, 0.000}, 1e-3, [](double) {
    return [](vec3, vec3, double, double, double LoH) { return Fr_SheenDisney(vec3(1), 1, 0, LoH).x; };
  });
}

TEST(Disney2012, Gtr1ProjectsToUnitArea) {
  for (const double alpha : {0.001, 0.01, 0.1, 0.5, 0.99, 1.0}) {
    EXPECT_NEAR(projectedArea([&](double NoH) { return D_GTR1(alpha, NoH); }, 40000), 1, 1e-3) << alpha;
  }
}

TEST(Disney2012, ClearcoatIsAFaintGlaze) {
  const double grazing = albedo(0.05, [](vec3, vec3, double NoL, double NoH, double LoH) {
    return Fr_ClearcoatDisney(1, 0, 0.05, NoL, NoH, LoH);
  });
  const double normal = albedo(
      1, [](vec3, vec3, double NoL, double NoH, double LoH) { return Fr_ClearcoatDisney(1, 0, 1, NoL, NoH, LoH); });
  EXPECT_NEAR(grazing, 0.044, 1e-3);
  EXPECT_NEAR(normal, 0.008, 1e-3);
}

TEST(R115, ClearcoatDhr) {
  const double expected[] = {0.404, 0.318, 0.119, 0.045, 0.040}, cosines[] = {0.05, 0.1, 0.3, 0.6, 1};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(clearcoatDHR(0.3, cosines[i]), expected[i], 1e-3) << cosines[i];
}

TEST(R115, SheenAlbedoWithAlphaNotSquared) {
  const auto lobe = [](double alpha) {
    return albedo(
        0.1, [=](vec3, vec3, double NoL, double NoH, double) { return Fr_SheenR115(vec3(1), alpha, 0.1, NoL, NoH).x; });
  };
  EXPECT_NEAR(lobe(0.5), 0.54, 6e-3);   // as it was
  EXPECT_NEAR(lobe(0.25), 0.62, 6e-3);  // as r187 shades the same roughness
}

TEST(R115, ReflectivityOfAnIndexOf1_5IsFourPercent) {
  EXPECT_NEAR(specularF0R115(vec3(0.3, 0.6, 0.9), 0.5, 0).x, 0.04, 1e-12);
  EXPECT_NEAR(specularF0R115(vec3(0.3, 0.6, 0.9), 0.5, 1).y, 0.6, 1e-12);
}

TEST(Cloth, RobustGgxIsGgx) {
  for (const double alpha : {0.002025, 0.04, 0.25, 1.0}) {
    for (const double NoH : {0.0, 0.3, 0.9, 0.9999, 1.0}) {
      EXPECT_NEAR(D_GGXRobust(alpha, NoH, 1 - NoH * NoH) / D_GGX(alpha, NoH), 1, 1e-8) << alpha << " " << NoH;
    }
  }
}

TEST(Cloth, RobustGgxHoldsInSinglePrecision) {
  const float alpha = 0.002025f;
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = 3 * alpha * i / 1000;
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.5, 0.8)),
                     t = glm::normalize(glm::cross(n, glm::dvec3(1, 0, 0)));
    const glm::vec3 nf(n), hf(std::cos(angle) * n + std::sin(angle) * t);
    const glm::dvec3 nd = glm::dvec3(nf), hd = glm::dvec3(hf);  // the rounded vectors are what both sides see
    const glm::vec3 x = glm::cross(nf, hf);
    const glm::dvec3 xd = glm::cross(nd, hd);
    const float single = brdf_f::D_GGXRobust(alpha, glm::dot(nf, hf), glm::dot(x, x));
    const double exact = D_GGXRobust(alpha, glm::dot(nd, hd), glm::dot(xd, xd));
    worst = std::max(worst, std::abs(single - exact) / exact);
  }
  EXPECT_LT(worst, 2e-4);
}

TEST(Cloth, CharlieWithItsOwnVisibility) {
  // sheenRoughness 0.3, 0.5, 1 at NoV 0.1 and 0.5
  const double roughness[] = {0.3, 0.5, 1}, grazing[] = {0.54, 0.57, 0.72}, half[] = {0.09, 0.19, 0.36};
  for (int i = 0; i < 3; ++i) {
    const double alpha = roughness[i] * roughness[i];
    const auto lobe = [=](double NoV) {
      return albedo(NoV, [=](vec3, vec3, double NoL, double NoH, double) {
        const double masking = 1 + lambdaCharlie(alpha, NoV) + lambdaCharlie(alpha, NoL);
        return D_Charlie(alpha, NoH) / (masking * 4 * NoV * NoL);
      });
    };
    EXPECT_NEAR(lobe(0.1), grazing[i], 6e-3) << roughness[i];
    EXPECT_NEAR(lobe(0.5), half[i], 6e-3) << roughness[i];
  }
}

TEST(Cloth, FuzzOfUncharted4IsItsThreeParts) {
  // Of fibres that lie: the rim alone. Of fibres that stand: all three, each where it is said to be.
  for (const double NoV : {0.0, 0.3, 1.0}) EXPECT_NEAR(fuzzUncharted4(0, NoV), 0.7 * std::pow(1 - NoV, 8), 1e-15);
  EXPECT_NEAR(fuzzUncharted4(1, 0), 1, 1e-15);
  EXPECT_NEAR(fuzzUncharted4(1, 1), 0.2, 1e-15);
  EXPECT_NEAR(fuzzUncharted4(1, 0.5), 0.7 / 8 + 0.3 / 4 + 0.2 / 4, 1e-15);
  for (double roughness = 0; roughness <= 1; roughness += 0.05) {
    for (double NoV = 0; NoV <= 1; NoV += 0.05) EXPECT_LE(fuzzUncharted4(roughness, NoV), 1);
  }
}

TEST(Cloth, FuzzOfUncharted4ConservesNothingAndIsNotReciprocal) {
  // What the page tells of it is so: a lobe that were reciprocal would have one value both ways.
  const auto lobe = [](double NoV) { return fuzzUncharted4(0.5, NoV) / PI; };
  EXPECT_GT(lobe(std::cos(1.4)) / lobe(std::cos(0.3)), 2);
}

TEST(Cloth, AshikhminProjectsToUnitAreaAbout) {
  for (const double alpha : {0.2, 0.5, 1.0}) {
    EXPECT_NEAR(projectedArea([&](double NoH) { return D_Ashikhmin(alpha, NoH); }), 1, 0.01) << alpha;
  }
}

TEST(Cloth, LtcSheenReflectsItsAlbedo) {
  for (const double roughness : {0.1, 0.3, 0.5, 1.0}) {
    for (const double NoV : {0.05, 0.1, 0.3, 0.6, 1.0}) {
      const vec3 ltc = sheenLtc(roughness, NoV);
      const double sum = overHemisphere(STRATA, [&](const vec3& l) { return sheenLtcCosine(ltc, l); });
      EXPECT_NEAR(sum, ltc.x, 5e-3) << roughness << " " << NoV;
      EXPECT_LE(ltc.x, 0.76);
    }
  }
}

TEST(DraftEnvironment, FitsStayNearTheIntegralOfADielectric) {
  for (const double roughness : {0.3, 0.5, 0.7, 1.0}) {
    const double alpha = roughness * roughness;
    for (const double NoV : {0.05, 0.1, 0.3, 0.6, 1.0}) {
      const double exact = albedo(NoV, [=](vec3, vec3, double NoL, double NoH, double LoH) {
        return (0.04 + 0.96 * F_SchlickWeight5(LoH)) * V_SmithGGXCorrelated(alpha, NoV, NoL) * D_GGX(alpha, NoH);
      });
      const vec2 karis = dfgKaris(roughness, NoV), lazarov = dfgLazarov(roughness, NoV);
      EXPECT_NEAR(0.04 * karis.x + karis.y, exact, 0.085) << roughness << " " << NoV;
      EXPECT_NEAR(0.04 * lazarov.x + lazarov.y, exact, 0.105) << roughness << " " << NoV;
    }
  }
}

}  // namespace
}  // namespace telar::test::thesis_test
