#include <gtest/gtest.h>

#include "brdf/relief_cloth.h"

namespace telar::test::relief_test {
namespace {

/// Round yarns side by side along two axes: slopes of a sine. The terms are fitted to other reliefs.
Relief weave(const char* name, double steepest) {
  constexpr int STEPS = 12;
  Relief relief{name, {}};
  for (int i = 0; i < STEPS; ++i) {
    for (int j = 0; j < STEPS; ++j) {
      const double x = TWO_PI * (i + 0.5) / STEPS, y = TWO_PI * (j + 0.5) / STEPS;
      relief.normals.push_back(glm::normalize(dvec3(steepest * std::sin(x), steepest * std::sin(y), 1)));
    }
  }
  return relief;
}

std::vector<Relief> reliefs() { return {weave("shallow", 0.4), weave("middle", 0.8), weave("steep", 1.4)}; }

struct Lobes {
  double diffuse = 0, specular = 0, sheen = 0;
};

/// Light of a white sky that the texels send to the viewer, by the lights' own path.
Lobes ofTexels(const Cloth& cloth, const Relief& relief, double NoV) {
  constexpr int AROUND = 4, STRATA = 20;
  Lobes lobes;
  for (int k = 0; k < AROUND; ++k) {
    const dvec3 v = direction(NoV, TWO_PI * (k + 0.37) / AROUND);
    for (const dvec3& n : relief.normals) {
      const SurfaceInfo s = surfaceOf(cloth, n, v, 0, 0);
      const dvec3 sum = overHemisphere(STRATA, [&](const dvec3& l) {
        const Reflected r = lit(s, l);
        return dvec3(r.diffuse.x, r.specular.x, r.sheen.x);
      });
      const double part = 1.0 / (AROUND * double(relief.normals.size()));
      lobes.diffuse += sum.x * part;
      lobes.specular += sum.y * part;
      lobes.sheen += sum.z * part;
    }
  }
  return lobes;
}

SurfaceInfo filtered(const Cloth& cloth, const Relief& relief, double NoV) {
  return surfaceOf(cloth, dvec3(0, 0, 1), direction(NoV, 0), relief.lost(), relief.slopeVariance());
}

/// Worst ratio between a lobe of the filtered map, as the environment gives it, and the mean over the texels.
double worstOf(const Cloth& cloth, double Lobes::*lobe, double (*ofFiltered)(const Reflected&),
               bool withRelief = true) {
  double worst = 1;
  for (const Relief& relief : reliefs()) {
    for (const double NoV : COSINES) {
      SurfaceInfo s = filtered(cloth, relief, NoV);
      if (!withRelief) s = surfaceOf(cloth, dvec3(0, 0, 1), direction(NoV, 0), 0, relief.slopeVariance());
      const double truth = ofTexels(cloth, relief, NoV).*lobe, got = ofFiltered(underSky(s));
      worst = std::max(worst, std::max(truth / got, got / truth));
    }
  }
  return worst;
}

double specularOf(const Reflected& r) { return r.specular.x; }

TEST(Relief, DiffuseLightIsTheMeanOverItsTexels) {
  const Cloth cloth{0.5, 0.9, 0, 0, 0.3};
  // 1.1 where normals that face away from the viewer are not turned to him (reliefTurned).
  EXPECT_LT(worstOf(cloth, &Lobes::diffuse, diffuseOf), 1.03);
  EXPECT_GT(worstOf(cloth, &Lobes::diffuse, diffuseOf, false), 1.3);  // a mean normal of length 1
}

TEST(Relief, DiffuseLightBelowAGlossIsTheMeanOverItsTexels) {
  const Cloth glossy{0.5, 0.4, 0, 0, 0.3};
  // 1.1 where the gloss takes from it what it takes at the mean normal (albedoOfRelief).
  EXPECT_LT(worstOf(glossy, &Lobes::diffuse, diffuseOf), 1.03);
}

TEST(Relief, DiffuseLightOfOneDirectionIsTheMeanOverItsTexels) {
  const Cloth cloth{0.5, 0.9, 0, 0, 0.3};
  constexpr int AROUND = 16;
  for (const bool withRelief : {true, false}) {
    double worst = 1;
    for (const Relief& relief : reliefs()) {
      for (const double NoL : {0.2, 0.5, 0.8, 0.97}) {
        const dvec3 v = direction(0.97, 1);
        double truth = 0;
        for (int k = 0; k < AROUND; ++k) {
          const dvec3 l = direction(NoL, TWO_PI * (k + 0.3) / AROUND);
          for (const dvec3& n : relief.normals)
            truth += lit(surfaceOf(cloth, n, v, 0, 0), l).diffuse.x / (AROUND * double(relief.normals.size()));
        }
        const double hidden = withRelief ? relief.lost() : 0;
        const SurfaceInfo s = surfaceOf(cloth, dvec3(0, 0, 1), v, hidden, relief.slopeVariance());
        const double got = lit(s, direction(NoL, 0)).diffuse.x;
        worst = std::max(worst, std::max(truth / got, got / truth));
      }
    }
    // The steep one where light grazes it. The others are within 6 %.
    if (withRelief) {
      EXPECT_LT(worst, 1.12);
    } else {
      EXPECT_GT(worst, 1.3);
    }
  }
}

TEST(Relief, GlossIsTheMeanOverItsTexels) {
  const Cloth metal{0.8, 0.6, 1, 0, 0.3};
  // The steep one again, which is steeper than what the term is fitted to. The others are within 6 %.
  EXPECT_LT(worstOf(metal, &Lobes::specular, specularOf), 1.2);
  EXPECT_GT(worstOf(metal, &Lobes::specular, specularOf, false), 1.4);
}

TEST(Relief, SheenIsTheMeanOverItsTexels) {
  const Cloth felt{0.2, 0.9, 0, 1, 0.8};
  EXPECT_LT(worstOf(felt, &Lobes::sheen, sheenOf), 1.1);
  EXPECT_GT(worstOf(felt, &Lobes::sheen, sheenOf, false), 1.3);
}

TEST(Relief, ReflectsBeforeALayerBelowAsItsTexelsDo) {
  constexpr int AROUND = 8;
  double worst = 0, ofMeanNormal = 0;
  for (const Relief& relief : reliefs()) {
    for (const double roughness : {0.3, 0.5, 0.8}) {
      for (const double NoV : COSINES) {
        const auto curve = brdf_d::grazingCurve(roughness);
        double truth = 0;
        for (int k = 0; k < AROUND; ++k) {
          const dvec3 v = direction(NoV, TWO_PI * (k + 0.37) / AROUND);
          for (const dvec3& n : relief.normals)
            truth +=
                brdf_d::glossGrazing(curve, std::max(glm::dot(n, v), 1e-3)) / (AROUND * double(relief.normals.size()));
        }
        worst = std::max(worst, std::abs(brdf_d::reliefGrazing(relief.lost(), curve, NoV) - truth));
        ofMeanNormal = std::max(ofMeanNormal, std::abs(brdf_d::glossGrazing(curve, NoV) - truth));
      }
    }
  }
  EXPECT_LT(worst,
            0.035);  // a polished one at a grazing viewer, where a third is reflected; the others are within 0.02
  EXPECT_GT(ofMeanNormal, 0.07);
}

TEST(Relief, LightFromBehindIsTheMeanOverItsTexels) {
  constexpr int AROUND = 16;
  double worst = 0, even = 0;
  for (const Relief& relief : reliefs()) {
    for (const double cosine : {-0.97, -0.6, -0.3, 0.0, 0.3, 0.6, 0.97}) {
      double truth = 0;
      for (int k = 0; k < AROUND; ++k) {
        const dvec3 l = direction(cosine, TWO_PI * (k + 0.3) / AROUND);
        for (const dvec3& n : relief.normals)
          truth += std::max(-glm::dot(n, l), 0.0) / (AROUND * double(relief.normals.size()));
      }
      worst = std::max(worst, std::abs(brdf_d::reliefBehind(relief.lost(), cosine) - truth));
      even = std::max(even, std::abs(glm::mix(std::max(-cosine, 0.0), 0.25, relief.lost()) - truth));
    }
  }
  EXPECT_LT(worst, 0.03);
  EXPECT_GT(even, 0.06);  // as if light came from everywhere
}

TEST(Relief, NoneChangesNothing) {
  for (const Cloth& cloth : WHITE) {
    for (const double NoV : COSINES) {
      const SurfaceInfo s = surfaceOf(cloth, dvec3(0, 0, 1), direction(NoV, 0), 0, 0);
      EXPECT_EQ(s.glossKept, brdf_d::vec2(1));
      EXPECT_EQ(s.alpha, cloth.roughness * cloth.roughness);
      EXPECT_EQ(brdf_d::bumpMean(1), 1);
      EXPECT_EQ(brdf_d::reliefDiffuseTowards(0, 0, NoV), 1);
      EXPECT_EQ(brdf_d::reliefTowards(0, dvec3(1, 0, 0), dvec3(0, 0, 1), direction(NoV, 1)), 0);
      EXPECT_EQ(brdf_d::reliefTurned(0, NoV), 1);
      EXPECT_EQ(brdf_d::reliefBehind(0, NoV), 0);
      EXPECT_EQ(brdf_d::reliefBehind(0, -NoV), NoV);
      EXPECT_EQ(brdf_d::reliefSheen(0, cloth.sheenRoughness), 1);
      EXPECT_NEAR(brdf_d::reliefSheenAlbedo(0, 0, cloth.sheenRoughness, NoV),
                  brdf_d::sheenFit(cloth.sheenRoughness, NoV).x, 1e-12);
    }
  }
}

/// A texel that is as large as the pixel and leans. The light of a white sky that it sends to the viewer, and its mean
/// direction.
struct Leaning {
  double lean;  ///< [0, PI / 2)
  dvec3 normal() const { return direction(std::cos(lean), 0); }
  /// xyz sum of directions, w of light
  glm::dvec4 diffuse() const {
    const Cloth cloth{0.5, 0.9, 0, 0, 0.3};
    const SurfaceInfo s = surfaceOf(cloth, normal(), direction(0.97, 0), 0, 0);
    return overHemisphere(60, [&](const dvec3& l) {
      const double light = brdf_d::saturate(glm::dot(s.n, l)) * brdf_d::bumpTerminator(s.bumpAlpha2, l.z);
      return glm::dvec4(l, 1) * light / PI;
    });
  }
};
const Leaning LEANING[] = {{0.1}, {0.3}, {0.6}, {0.9}, {1.2}, {1.5}};

TEST(Bump, LightFromBelowTheSurfaceDoesNotReachANormalThatLeans) {
  double worst = 0, withoutTerm = 0;
  for (const Leaning& texel : LEANING) {
    const double truth = texel.diffuse().w;
    worst = std::max(worst, std::abs(brdf_d::bumpMean(std::cos(texel.lean)) - truth));
    withoutTerm = std::max(withoutTerm, 1 - truth);
  }
  EXPECT_LT(worst, 0.012);
  EXPECT_GT(withoutTerm, 0.5);
}

TEST(Bump, LightOfANormalThatLeansComesFromAbove) {
  constexpr double WITHIN = 2.5 * PI / 180;
  double worst = 0, unbent = 0;
  for (const Leaning& texel : LEANING) {
    const dvec3 truth = glm::normalize(dvec3(texel.diffuse()));
    const dvec3 got = brdf_d::bumpBent({0, 0, 1}, texel.normal());
    EXPECT_NEAR(glm::length(got), 1, 1e-12);
    worst = std::max(worst, std::acos(std::min(glm::dot(truth, got), 1.0)));
    unbent = std::max(unbent, std::acos(std::min(glm::dot(truth, texel.normal()), 1.0)));
  }
  EXPECT_LT(worst, WITHIN);
  EXPECT_GT(unbent, 10 * WITHIN);
}

/// rms of the share of a gloss that a texel that leans keeps of a white sky.
/// @param withDirection false = as diffuse light keeps it
double glossOffBy(bool withDirection) {
  double squares = 0;
  int count = 0;
  for (const double roughness : {0.3, 0.5, 0.7, 0.9}) {
    const Cloth metal{0.8, roughness, 1, 0, 0.3};
    for (const Leaning& texel : LEANING) {
      for (const double NoV : {0.5, 0.97}) {
        for (const double phi : {0.0, 1.5, 3.0}) {
          const SurfaceInfo s = surfaceOf(metal, texel.normal(), direction(NoV, phi), 0, 0);
          if (s.NoV < 0.1) continue;
          const double whole = underSky(surfaceOf(metal, {0, 0, 1}, direction(s.NoV, 0), 0, 0)).specular.x;
          const double truth = overHemisphere(60, [&](const dvec3& l) { return lit(s, l).specular.x; }) / whole;
          const double share = underSky(s).specular.x / whole;
          const double got = withDirection ? share : brdf_d::bumpMean(s.n.z);
          squares += (got - truth) * (got - truth);
          ++count;
        }
      }
    }
  }
  return std::sqrt(squares / count);
}

TEST(Bump, GlossOfANormalThatLeansKeepsWhatItsDirectionSays) {
  EXPECT_LT(glossOffBy(true), 0.1);
  EXPECT_GT(glossOffBy(false), 0.15);
}

/// The white furnace: no relief makes light, under lights or under a sky.
double brightest(double tamper) {
  double most = 0;
  for (const Cloth& cloth : WHITE) {
    for (const double relief : {0.02, 0.1, 0.3, 0.6, 0.9}) {
      for (const double NoV : COSINES) {
        for (const dvec3& axis : {dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0)}) {
          SurfaceInfo s = surfaceOf(cloth, dvec3(0, 0, 1), direction(NoV, 0), relief, relief, axis);
          s.relief *= tamper;
          const dvec3 sum = overHemisphere(64, [&](const dvec3& l) { return dvec3(composed(s, lit(s, l))); });
          most = std::max({most, sum.x, composed(s, underSky(s))});
        }
      }
    }
  }
  return most;
}

TEST(Relief, MakesNoLight) {
  EXPECT_LT(brightest(1), 1.005);
  EXPECT_GT(brightest(-1), 1.1);  // a relief that gives what it should take
}

}  // namespace
}  // namespace telar::test::relief_test
