#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "brdf/brdf.h"
#include "brdf/quadrature.h"
#include "brdf/shading.h"

/// Polished discs and the edges between them, finer than a pixel: two highlights against the mean over the texels.
namespace telar::test::facets_test {
namespace {

using brdf_d::Reflected;
using brdf_d::SurfaceInfo;
using glm::dvec2;
using glm::dvec3;

constexpr double COSINES[] = {0.3, 0.6, 0.9};
constexpr double ROUGHNESS = 0.18;
const dvec3 UP(0, 0, 1);

brdf_d::ShadingFunctions fabric() { return brdf_d::shadingFunctions(ShadingModel::kFabric); }

SurfaceInfo metalOf(const dvec3& n, const dvec3& v, double slopeVariance, double edgeShare) {
  SurfaceInfo s{};
  s.n = brdf_d::normalFacing(n, v);
  s.geometricNormal = UP;
  s.v = v;
  s.NoV = brdf_d::saturate(glm::dot(s.n, v));
  s.baseColor = s.metalColor = dvec3(1);
  s.metallic = 1;
  s.f0Dielectric = dvec3(0.04);
  s.f90 = 1;
  s.perceptualRoughness = ROUGHNESS;
  s.alpha = ROUGHNESS * ROUGHNESS;
  s.sheenRoughness = s.clearcoatRoughness = 0.5;
  s.coatNormal = s.n;
  s.clearcoatNoV = s.NoV;
  s.slopeVariance = slopeVariance;
  s.edges.share = edgeShare;
  return fabric().preparedSurface(s);
}

double lit(const SurfaceInfo& s, const dvec3& l) {
  return fabric().addPunctual(brdf_d::nothingReflected(), s, l, dvec3(1)).specular.x;
}

/// Slopes of discs that lean by up to 0.12 and of the steep edges around them, a third of all.
std::vector<dvec2> discs() {
  std::vector<dvec2> slopes;
  for (int i = 0; i < 300; ++i) {
    const double angle = TWO_PI * i * 0.6180339887498949;
    const double slope = i % 3 == 0 ? 0.6 + i / 300.0 : 0.12 * std::sqrt((i + 0.5) / 300);
    slopes.push_back(slope * dvec2(std::cos(angle), std::sin(angle)));
  }
  return slopes;
}

/// What the map of facets tells of them (texture/facets.glsl, material/normal.glsl).
SurfaceInfo filtered(const std::vector<dvec2>& slopes, const dvec3& v, bool apart) {
  double share = 0, square = 0;
  for (const dvec2& slope : slopes) {
    const double slope2 = glm::dot(slope, slope), flat = apart ? brdf_d::facetShare(slope2) : 1;
    share += flat;
    square += flat * slope2;
  }
  const double kept = share / double(slopes.size());
  return metalOf(UP, v, square / share, apart ? brdf_d::edgeShare(kept, square / share) : 0);
}

double ofTexels(const std::vector<dvec2>& slopes, const dvec3& v, const dvec3& l) {
  double sum = 0;
  for (const dvec2& slope : slopes) sum += lit(metalOf(glm::normalize(dvec3(slope, 1)), v, 0, 0), l);
  return sum / double(slopes.size());
}

TEST(Facets, TheirHighlightIsAsBrightAsThatOfTheTexels) {
  const std::vector<dvec2> slopes = discs();
  for (const double NoV : COSINES) {
    const dvec3 v = direction(NoV, 0), mirrored = direction(NoV, TWO_PI / 2);
    const double truth = ofTexels(slopes, v, mirrored);
    // Discs lean as on a plate and not as by GGX, whose middle is 1.7 times as high; edges are a third here and count
    // as more.
    EXPECT_NEAR(lit(filtered(slopes, v, true), mirrored) / truth, 1, 0.4) << NoV;
    EXPECT_LT(lit(filtered(slopes, v, false), mirrored) / truth, 0.3) << NoV;  // one lobe for both
  }
}

TEST(Facets, ALightBesideTheHighlightIsSeenInTheEdges) {
  const std::vector<dvec2> slopes = discs();
  const dvec3 v = direction(0.9, 0);
  double truth = 0, got = 0, without = 0;
  constexpr int AROUND = 16;
  for (int k = 0; k < AROUND; ++k) {
    const dvec3 l = direction(0.45, TWO_PI * (k + 0.5) / AROUND);
    truth += ofTexels(slopes, v, l);
    got += lit(filtered(slopes, v, true), l);
    SurfaceInfo facets = filtered(slopes, v, true);
    const double share = facets.edges.share;
    facets.edges.share = 0;
    without += (1 - share) * lit(facets, l);
  }
  EXPECT_NEAR(got / truth, 1, 0.25);  // the lobe of edges has one width for all steepnesses
  EXPECT_LT(without / truth, 0.7);    // the tails of the facets' own highlight are there without them
}

TEST(Facets, NoEdgesChangeNothing) {
  for (const double NoV : COSINES) {
    SurfaceInfo s = metalOf(UP, direction(NoV, 0), 0.01, 0);
    const double before = lit(s, direction(0.7, 2));
    s.edges.n = direction(0.5, 1);
    s.edges.reflectance = dvec3(1);
    EXPECT_EQ(lit(s, direction(0.7, 2)), before);
  }
}

/// Distribution of a place about UP at h, as light/facets.glsl has it.   across, down  by how much its slope turns
double placeAt(const dvec3& h, double alpha, const dvec2& middle, const dvec2& across, const dvec2& down) {
  const glm::dmat3 toHalfway = glm::transpose(brdf_d::basisAbout(h));
  const auto slope = [&](const dvec2& of) {
    const dvec3 n = toHalfway * dvec3(of, 1);
    return dvec2(n) / std::max(n.z, 0.3);
  };
  const dvec2 turn = slope(middle + 0.5 * across) - slope(middle - 0.5 * across);
  const dvec2 other = slope(middle + 0.5 * down) - slope(middle - 0.5 * down);
  return brdf_d::facetCellDistribution(alpha * alpha, slope(middle), turn, other);
}

/// Mean of narrow lobes over a place that turns by `across` and `down` about UP.
double meanOfNormals(const dvec3& h, double alpha, const dvec2& across, const dvec2& down) {
  constexpr int SIDE = 256;
  double mean = 0;
  for (int k = 0; k < SIDE; ++k) {
    const dvec2 slope = across * ((k + 0.5) / SIDE - 0.5) + down * (std::fmod(k * 0.6180339887498949, 1.0) - 0.5);
    const dvec3 n = glm::normalize(dvec3(slope, 1));
    mean += brdf_d::D_GGX(alpha, brdf_d::saturate(glm::dot(n, h))) / SIDE;
  }
  return mean;
}

TEST(Facets, APlaceWithoutATurnIsAFacet) {
  for (const double NoH : {1.0, 0.99, 0.9, 0.5})
    EXPECT_NEAR(placeAt(direction(NoH, 1), 0.05, dvec2(0), dvec2(0), dvec2(0)) / brdf_d::D_GGX(0.05, NoH), 1, 1e-6);
}

/// @param spread  factor on the turns that the lobe is told of      @return the lobe against the normals, in the middle
/// of the place and where it ends; and what there is far from it, against the middle
std::array<double, 3> placeAgainstItsNormals(double spread) {
  constexpr double ALPHA = 0.05;
  const dvec2 across(0.5, 0), down(0.03, 0.02);
  const auto told = [&](const dvec3& h) { return placeAt(h, ALPHA, dvec2(0), spread * across, spread * down); };
  const dvec3 end = glm::normalize(dvec3(0.25, 0.01, 1)), far = glm::normalize(dvec3(1, 0.05, 1));
  return {told(UP) / meanOfNormals(UP, ALPHA, across, down), told(end) / meanOfNormals(end, ALPHA, across, down),
          told(far) / told(UP)};
}

TEST(Facets, APlaceWhoseNormalTurnsIsAsBrightAsItsNormals) {
  const auto told = placeAgainstItsNormals(1);
  EXPECT_NEAR(told[0], 1, 0.35);
  EXPECT_NEAR(told[1], 1, 0.35);
  EXPECT_LT(told[2], 0.05);
  EXPECT_GT(placeAgainstItsNormals(0)[0], 2);  // a lobe that is not as wide as the normal turns
  EXPECT_LT(placeAgainstItsNormals(0)[1], 0.5);
  EXPECT_GT(placeAgainstItsNormals(3)[2], 0.05);
}

/// Of a lobe, its normals times their cosine make one.
TEST(Facets, APlaceMakesNoLight) {
  const auto whole = [](double turn, double factor) {
    const auto at = [&](const dvec3& h) {
      return dvec3(factor * h.z * placeAt(h, 0.3, dvec2(0), dvec2(turn, 0), dvec2(0, turn)));
    };
    return overHemisphere(256, at).x;
  };
  for (const double turn : {0.0, 0.2, 0.6}) {
    EXPECT_LT(whole(turn, 1), 1.005) << turn;
    EXPECT_GT(whole(turn, 1), 0.85) << turn;
  }
  EXPECT_GT(whole(0, 1.2), 1.1);
}

/// What is left to light/facets.glsl is taken from both highlights, and nothing of what comes from everywhere.
TEST(Facets, WhatIsToldPlaceByPlaceIsNotShadedTwice) {
  SurfaceInfo s = metalOf(UP, direction(0.9, 0), 0.02, 0.3);
  const dvec3 l = direction(0.8, 2.5), dome = fabric().addDome(brdf_d::nothingReflected(), s, dvec3(1)).specular;
  const double all = lit(s, l);
  s.facetsTold = 0.5;
  const double half = lit(s, l);
  s.facetsTold = 1;
  const double none = lit(s, l);
  EXPECT_NEAR(half - none, 0.5 * (all - none), 1e-9);
  EXPECT_LT(none, 0.05 * all);  // light that comes back from between the facets
  EXPECT_EQ(fabric().addDome(brdf_d::nothingReflected(), s, dvec3(1)).specular, dome);
}

/// The white furnace under lights, under a prefiltered sky and under a dome. @param tamper  factor on the edges' share
double brightest(double tamper) {
  double most = 0;
  for (const double NoV : COSINES) {
    for (const double share : {0.0, 0.2, 0.6, 1.0}) {
      SurfaceInfo s = metalOf(UP, direction(NoV, 0), 0.02, share);
      s.edges.share *= tamper;
      s.edges.reflectance *= tamper;
      brdf_d::Incident sky{};
      sky.environmentIrradiance = dvec3(TWO_PI / 2);
      sky.radiance = sky.edgeRadiance = dvec3(1);
      const Reflected none = brdf_d::nothingReflected();
      const dvec3 sum = overHemisphere(64, [&](const dvec3& l) { return dvec3(lit(s, l)); });
      most = std::max({most, sum.x, fabric().addEnvironment(none, s, sky).specular.x,
                       fabric().addDome(none, s, dvec3(TWO_PI / 2)).specular.x});
    }
  }
  return most;
}

TEST(Facets, MakeNoLight) {
  EXPECT_LT(brightest(1), 1.005);
  EXPECT_GT(brightest(3), 1.1);
}

/// @param factor  on the edges' share from one side
double worstReciprocity(double factor) {
  double worst = 0;
  for (const double a : COSINES) {
    for (const double b : COSINES) {
      const dvec3 v = direction(a, 0), l = direction(b, 2);
      SurfaceInfo from = metalOf(UP, v, 0.02, 0.5), back = metalOf(UP, l, 0.02, 0.5);
      back.edges.share *= factor;
      const double there = lit(from, l) / b, again = lit(back, v) / a;
      worst = std::max(worst, std::abs(there - again) / std::max(there, again));
    }
  }
  return worst;
}

TEST(Facets, AreReciprocal) {
  EXPECT_LT(worstReciprocity(1), 1e-6);
  EXPECT_GT(worstReciprocity(0.5), 0.1);
}

}  // namespace
}  // namespace telar::test::facets_test
