#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "brdf/brdf.h"

namespace telar::test::tone_mapping_test {
namespace {

using Curve = glm::dvec3 (*)(glm::dvec3, double);

int encoded8(double linear) {
  return static_cast<int>(std::lround(255 * brdf_d::srgbFromLinear(std::min(std::max(linear, 0.0), 1.0))));
}

struct Greys {
  const char* name;
  Curve curve;
  int codes[4];  ///< 8-bit sRGB for scene greys 0.04, 0.18, 1 and 4
};

// Code values that three.js 0.187 draws for these greys at exposure 1; cineon from the published formula.
const Greys GREYS[] = {
    {"neutral", brdf_d::toneMapNeutral, {25, 105, 240, 253}},
    {"aces", brdf_d::toneMapAces, {41, 127, 226, 250}},
    {"agx", brdf_d::toneMapAgx, {61, 128, 202, 239}},
    {"reinhard", brdf_d::toneMapReinhard, {55, 109, 188, 231}},
    {"linear", brdf_d::toneMapLinear, {56, 118, 255, 255}},
    {"cineon", brdf_d::toneMapCineon, {48, 131, 216, 244}},
};

TEST(ToneMapping, EachOfTheTableHasGreys) {
  std::vector<Curve> table;
#define TELAR_TONE_CURVE(name, function, three) table.push_back(brdf_d::function);
  TELAR_TONE_MAPPINGS(TELAR_TONE_CURVE)
#undef TELAR_TONE_CURVE
  for (const Curve curve : table) {
    const auto has = [curve](const Greys& greys) { return greys.curve == curve; };
    EXPECT_EQ(std::count_if(std::begin(GREYS), std::end(GREYS), has), 1);
  }
}

TEST(ToneMapping, GreysHaveTheCodeValuesOfThree) {
  const double scene[] = {0.04, 0.18, 1, 4};
  for (const Greys& greys : GREYS) {
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 out = greys.curve(glm::dvec3(scene[i]), 1);
      EXPECT_EQ(encoded8(out.x), greys.codes[i]) << greys.name << " of " << scene[i];
      EXPECT_EQ(encoded8(out.z), greys.codes[i]) << greys.name << " of " << scene[i] << ", blue";
    }
  }
}

TEST(ToneMapping, ExposureIsAFactorOnTheScene) {
  for (const Greys& greys : GREYS) {
    const glm::dvec3 color(0.3, 0.1, 0.02);
    EXPECT_LT(glm::distance(greys.curve(color, 2.5), greys.curve(2.5 * color, 1)), 1e-12) << greys.name;
  }
}

TEST(ToneMapping, RisesWithTheSceneAndWhiteStaysWhiteHoweverBright) {
  for (const Greys& greys : GREYS) {
    double before = -1;
    for (double grey = 0; grey < 20; grey += 0.01) {
      const double out = greys.curve(glm::dvec3(grey), 1).y;
      // AgX's polynomial falls by 1e-4 where its clamp sets in.
      ASSERT_GE(out, before - 1e-4) << greys.name << " at " << grey;
      before = out;
    }
    for (const double bright : {1e5, 1e12, 1e38, HUGE_VAL}) {
      const glm::dvec3 out = greys.curve(glm::dvec3(bright), 1);
      EXPECT_EQ(encoded8(out.x), encoded8(greys.curve(glm::dvec3(65504), 1).x)) << greys.name << " of " << bright;
      EXPECT_GE(encoded8(out.x), 251) << greys.name << " of " << bright;
    }
  }
}

TEST(Srgb, TransferFunctionsAreInverse) {
  for (int code = 0; code < 256; ++code) {
    EXPECT_NEAR(255 * brdf_d::srgbFromLinear(brdf_d::linearFromSrgb(code / 255.0)), code, 0.005) << code;
  }
}

TEST(Srgb, MatchesTheStandardWithinAHundredthOfACode) {
  for (double x = 0; x <= 1; x += 1.0 / 4096) {
    const double standard = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    EXPECT_NEAR(255 * brdf_d::srgbFromLinear(x), 255 * standard, 0.01) << x;
  }
}

TEST(ToneMapping, NeutralFadesToItsPeakAndInR162ToWhite) {
  using namespace brdf_d;
  const vec3 bright(3, 1, 0.5);
  const auto by = [&](double faded) {
    const double peak = 3 - 0.04, rolled = 1 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
    const double g = 1 - 1 / (0.15 * (peak - rolled) + 1);
    return glm::mix((bright - 0.04) * (rolled / peak), vec3(faded == 0 ? rolled : faded), g);
  };
  EXPECT_LT(max3(abs(toneMapNeutralWhite(bright, 1) - by(1))), 1e-12);
  EXPECT_LT(max3(abs(toneMapNeutral(bright, 1) - by(0))), 1e-12);
  EXPECT_GT(max3(abs(by(0) - by(1))), 1e-3);
  EXPECT_EQ(toneMapNeutralWhite(vec3(0.5, 0.4, 0.3), 1), toneMapNeutral(vec3(0.5, 0.4, 0.3), 1));
}

}  // namespace
}  // namespace telar::test::tone_mapping_test
