#include <gtest/gtest.h>

#include "brdf/brdf.h"
#include "brdf/quadrature.h"

/// The prefiltered lobe that cloth reads an environment by, against the lobe that it stands for.
namespace telar::test::prefiltered_lobe_test {
namespace {

using glm::dvec3;

constexpr int STRATA = 160;
constexpr double DIELECTRIC = 0.045, METAL = 0.9;

double lengthOfMean(const glm::dvec4& sum) { return glm::length(dvec3(sum)) / sum.w; }

/// Of a level of a prefiltered environment: GGX for a viewer along the normal, weighted by the cosine of the light.
double prefiltered(double roughness) {
  return lengthOfMean(overHemisphere(STRATA, [&](const dvec3& l) {
    const dvec3 h = glm::normalize(l + dvec3(0, 0, 1));
    return glm::dvec4(l, 1) * (brdf_d::D_GGX(roughness * roughness, h.z) * l.z);
  }));
}

double reflected(double roughness, double f0, double NoV) {
  const dvec3 v = direction(NoV, 0);
  return lengthOfMean(overHemisphere(STRATA, [&](const dvec3& l) {
    const double alpha = roughness * roughness;
    const dvec3 h = glm::normalize(l + v);
    const double fresnel = f0 + (1 - f0) * brdf_d::F_SchlickWeight5(glm::dot(v, h));
    return glm::dvec4(l, 1) * (fresnel * brdf_d::D_GGX(alpha, h.z) * brdf_d::V_SmithGGXCosine(alpha, NoV, l.z));
  }));
}

/// @param exact  false = by the lobe of the same roughness
double worstOf(double f0, bool exact) {
  double worst = 0;
  for (const double roughness : {0.3, 0.4, 0.5, 0.6, 0.8}) {
    for (const double NoV : {0.2, 0.35, 0.5, 0.7, 0.9}) {
      const double read = exact ? brdf_d::prefilteredRoughness(roughness, f0, NoV) : roughness;
      worst = std::max(worst, std::abs(prefiltered(read) - reflected(roughness, f0, NoV)));
    }
  }
  return worst;
}

TEST(PrefilteredLobe, IsAsWideAsWhatItStandsFor) {
  EXPECT_LT(worstOf(DIELECTRIC, true), 0.03);
  EXPECT_LT(worstOf(METAL, true), 0.03);
  EXPECT_GT(worstOf(DIELECTRIC, false), 0.05);
  EXPECT_GT(worstOf(METAL, false), 0.05);
}

}  // namespace
}  // namespace telar::test::prefiltered_lobe_test
