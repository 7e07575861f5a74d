#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "brdf/shading.h"
#include "core/random.h"

namespace telar::brdf {
namespace {

constexpr double PI = 3.14159265358979;

struct Lobes {
  const char* name;
  float elevation;  ///< of the viewer, degrees
  float alpha, alphaT, metallic, sheen, coat, coatAlpha, through, yarns;
};

/// Wide and narrow, stretched, coated with a normal of its own, seen flat, thin.
constexpr std::array<Lobes, 8> SURFACES{{{"matt", 60, 1, 1, 0, 0, 0, 0.5f, 0},
                                         {"satin", 40, 0.15f, 0.15f, 0, 0.4f, 0, 0.5f, 0},
                                         {"metal", 70, 0.1f, 0.1f, 1, 0, 0, 0.5f, 0},
                                         {"stretched", 35, 0.12f, 0.6f, 1, 0, 0, 0.5f, 0},
                                         {"coated", 50, 0.5f, 0.5f, 0, 0, 1, 0.1f, 0},
                                         {"thin", 65, 0.5f, 0.5f, 0, 0.2f, 0, 0.5f, 0.7f},
                                         {"flat", 4, 0.2f, 0.2f, 0, 0, 0.5f, 0.2f, 0.3f},
                                         {"woven", 45, 0.4f, 0.5f, 0, 0, 0, 0.5f, 0, 0.8f}}};

brdf_f::SurfaceInfo surfaceOf(const Lobes& lobes) {
  brdf_f::SurfaceInfo s{};
  const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  const glm::mat3 frame = brdf_f::basisAbout(n);
  const auto elevation = glm::radians(lobes.elevation);
  s.n = n;
  s.v = frame * glm::vec3(std::cos(elevation) * 0.6f, std::cos(elevation) * 0.8f, std::sin(elevation));
  // Leans, as an axis of texture coordinates does.
  s.t = glm::normalize(frame[0] + 0.4f * n + 0.3f * frame[1]);
  s.b = frame[1];
  s.baseColor = s.metalColor = glm::vec3(0.5f, 0.6f, 0.7f);
  s.metallic = lobes.metallic;
  s.diffuse = s.baseColor * (1 - lobes.metallic);
  s.f0 = glm::mix(glm::vec3(0.04f), s.baseColor, lobes.metallic);
  s.f90 = 1;
  s.NoV = glm::dot(n, s.v);
  s.alpha = lobes.alpha;
  s.alphaT = lobes.alphaT;
  s.perceptualRoughness = std::sqrt(lobes.alpha);
  s.sheenColor = glm::vec3(lobes.sheen);
  s.coatNormal = glm::normalize(n + 0.3f * frame[1]);
  s.clearcoat = lobes.coat;
  s.clearcoatRoughness = std::sqrt(lobes.coatAlpha);
  s.clearcoatNoV = brdf_f::saturate(glm::dot(s.coatNormal, s.v));
  s.diffuseTransmission = lobes.through;
  // The weft lies across the warp, which dips.
  s.warp.metallic = s.weft.metallic = lobes.metallic;
  s.warp.coverage = 0.6f * lobes.yarns, s.weft.coverage = 0.4f * lobes.yarns;
  s.warp.t = glm::normalize(frame[1] + 0.3f * n), s.warp.b = frame[0], s.warp.n = glm::normalize(n - 0.3f * frame[1]);
  s.weft.t = frame[0], s.weft.b = frame[1], s.weft.n = n;
  s.warp.alphaT = s.weft.alphaT = 0.1f, s.warp.alphaB = s.weft.alphaB = 0.5f;
  return s;
}

constexpr int BANDS = 12, SECTORS = 16, FINE = 40;  ///< cells over the sphere; points along a side of one

/// Direction of a place of the sphere, of equal areas. @param x, y  [0, 1)
glm::vec3 directionOf(double x, double y) {
  const double z = 1 - 2 * y, r = std::sqrt(1 - z * z), phi = 2 * PI * x;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

std::size_t cellOf(const glm::vec3& l) {
  double turn = std::atan2(l.y, l.x) / (2 * PI);
  if (turn < 0) turn += 1;
  const int band = std::min(static_cast<int>((1 - l.z) / 2 * BANDS), BANDS - 1);
  const int sector = std::min(static_cast<int>(turn * SECTORS), SECTORS - 1);
  return static_cast<std::size_t>(band * SECTORS + sector);
}

/// Chance of each cell, by quadrature of the pdf.
std::vector<double> chancesOf(const brdf_f::LobeMixture& lobes) {
  std::vector<double> chances;
  constexpr double AREA = 4 * PI / (BANDS * SECTORS * FINE * FINE);
  for (int band = 0; band < BANDS; ++band) {
    for (int sector = 0; sector < SECTORS; ++sector) {
      double sum = 0;
      for (int i = 0; i < FINE * FINE; ++i) {
        const double x = (sector + (i % FINE + 0.5) / FINE) / SECTORS, y = (band + (i / FINE + 0.5) / FINE) / BANDS;
        sum += brdf_f::pdfMixture(lobes, directionOf(x, y));
      }
      chances.push_back(sum * AREA);
    }
  }
  return chances;
}

TEST(LobeMixture, TheDensityIsOneOverTheSphere) {
  for (const Lobes& lobes : SURFACES) {
    double whole = 0;
    for (const double chance : chancesOf(brdf_f::lobeMixture(surfaceOf(lobes)))) whole += chance;
    EXPECT_NEAR(whole, 1, 2e-3) << lobes.name;
  }
}

TEST(LobeMixture, DrawsFallAsTheDensitySays) {
  constexpr int DRAWS = 200000;
  for (const Lobes& lobes : SURFACES) {
    const brdf_f::LobeMixture mixture = brdf_f::lobeMixture(surfaceOf(lobes));
    const std::vector<double> chances = chancesOf(mixture);
    std::vector<int> counts(chances.size());
    Random random(11, 0, 0);
    for (int i = 0; i < DRAWS; ++i) {
      const glm::vec3 l = brdf_f::sampleMixture(mixture, random.uniform2());
      ASSERT_NEAR(glm::length(l), 1, 1e-4) << lobes.name;
      ++counts[cellOf(l)];
    }
    // Pearson's chi-square; cells that are hardly ever hit count as one.
    double square = 0, restExpected = 0, restCount = 0;
    int cells = 0;
    for (std::size_t i = 0; i < chances.size(); ++i) {
      const double expected = chances[i] * DRAWS;
      if (expected < 10) {
        restExpected += expected, restCount += counts[i];
        continue;
      }
      square += (counts[i] - expected) * (counts[i] - expected) / expected;
      ++cells;
    }
    if (restExpected > 10) square += (restCount - restExpected) * (restCount - restExpected) / restExpected, ++cells;
    // Mean and spread of the distribution: 4 sigma, and what the quadrature may be off.
    EXPECT_LT(square, cells + 4 * std::sqrt(2.0 * cells)) << lobes.name;
    EXPECT_GT(cells, 10) << lobes.name;
  }
}

}  // namespace
}  // namespace telar::brdf
