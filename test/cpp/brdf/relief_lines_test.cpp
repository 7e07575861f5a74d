#include <gtest/gtest.h>

#include "brdf/relief_cloth.h"

/// Cloth whose relief runs along lines, against the mean over the texels that it stands for.
namespace telar::test::relief_test {
namespace {

using LobeOf = double (*)(const Reflected&);

const Cloth PILE{0.5, 0.95, 0, 1, 0.45}, MATT{0.5, 0.95, 0, 0, 0.3};
const dvec3 ACROSS(1, 0, 0), NONE(0);

/// Half cylinders side by side: they lean along x alone.
Relief cords() {
  Relief relief{"cords", {}};
  for (double sine = -0.94; sine < 0.95; sine += 0.04) relief.normals.emplace_back(sine, 0, std::sqrt(1 - sine * sine));
  return relief;
}

SurfaceInfo cordsFromAfar(const Cloth& cloth, const Relief& relief, const dvec3& v, const dvec3& axis) {
  return surfaceOf(cloth, dvec3(0, 0, 1), v, relief.lost(), relief.slopeVariance(), axis);
}

/// Worst ratio between what cords give from afar and the mean over their texels, for views of these cosines across the
/// cords, along them and in between: calls got(v) and ofTexel(n, v).
template <class Got, class OfTexel>
double worstRatio(const Relief& relief, const std::vector<double>& viewed, const Got& got, const OfTexel& ofTexel) {
  double worst = 1;
  for (const double NoV : viewed) {
    for (const double azimuth : {0.0, 0.8, 1.57}) {
      const dvec3 v = direction(NoV, azimuth);
      double truth = 0;
      for (const dvec3& n : relief.normals) truth += ofTexel(n, v) / double(relief.normals.size());
      const double given = got(v);
      EXPECT_GT(given, 0);
      worst = std::max(worst, std::max(truth / given, given / truth));
    }
  }
  return worst;
}

/// Under three lights that graze, in the plane of the viewer.
double worstUnderLights(const Cloth& cloth, LobeOf lobe, const dvec3& axis, const std::vector<double>& viewed) {
  const Relief relief = cords();
  const auto ofLights = [&](const SurfaceInfo& s, const dvec3& v) {
    double sum = 0;
    for (const double NoL : {0.15, 0.3, 0.6}) sum += lobe(lit(s, direction(NoL, std::atan2(v.y, v.x) + 0.1)));
    return sum;
  };
  return worstRatio(
      relief, viewed, [&](const dvec3& v) { return ofLights(cordsFromAfar(cloth, relief, v, axis), v); },
      [&](const dvec3& n, const dvec3& v) { return ofLights(surfaceOf(cloth, n, v, 0, 0), v); });
}

/// Sheen under a white sky.
double worstUnderSky(const dvec3& axis, const std::vector<double>& viewed) {
  const Relief relief = cords();
  return worstRatio(
      relief, viewed, [&](const dvec3& v) { return underSky(cordsFromAfar(PILE, relief, v, axis)).sheen.x; },
      [&](const dvec3& n, const dvec3& v) {
        const SurfaceInfo s = surfaceOf(PILE, n, v, 0, 0);
        return overHemisphere(20, [&](const dvec3& l) { return dvec3(lit(s, l).sheen.x); }).x;
      });
}

// The bars are between what the axis gives and what is given without one, which the comments have.
TEST(ReliefLines, SheenOfLightsIsTheMeanOverTheirTexels) {
  EXPECT_LT(worstUnderLights(PILE, sheenOf, ACROSS, {0.3, 0.6}), 1.2);  // 1.15
  EXPECT_GT(worstUnderLights(PILE, sheenOf, NONE, {0.3, 0.6}), 1.8);    // 2.16
}

TEST(ReliefLines, DiffuseLightIsTheMeanOverTheirTexels) {
  EXPECT_LT(worstUnderLights(MATT, diffuseOf, ACROSS, {0.3, 0.6, 0.9}), 1.12);  // 1.09
  EXPECT_GT(worstUnderLights(MATT, diffuseOf, NONE, {0.3, 0.6, 0.9}), 1.18);    // 1.22
}

TEST(ReliefLines, SheenOfASkyIsTheMeanOverTheirTexels) {
  EXPECT_LT(worstUnderSky(ACROSS, {0.3, 0.6, 0.9}), 1.35);  // 1.27
  EXPECT_GT(worstUnderSky(NONE, {0.3, 0.6, 0.9}), 1.5);     // 1.60
}

}  // namespace
}  // namespace telar::test::relief_test
