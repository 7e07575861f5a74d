// Every distribution of normals projects to an area of 1, and every pdf is one whole.
#include <array>

#include "brdf/quadrature.h"
#include "checks.h"
#include "evaluate.h"
#include "mixture.h"
#include "reference/lobe_sampler.h"
#include "surface_point.h"
#include "worst.h"

namespace telar::numerics {
namespace {

using namespace brdf_d;

constexpr std::array ALPHAS{0.002025, 0.01, 0.04, 0.09, 0.25, 0.49, 0.81, 1.0};

/// Furthest that the projected area is from 1, over these widths.
template <class Distribution>
Figure isotropic(const char* name, double bar, std::initializer_list<double> alphas, Distribution d) {
  Worst worst;
  for (const double alpha : alphas) {
    const double area = test::projectedArea([&](double NoH) { return d(alpha, NoH); }, 40000);
    worst.see(std::abs(area - 1), static_cast<std::uint64_t>(alpha * 1e6));
  }
  return {std::string("|projected area - 1| of ") + name,
          "",
          worst.value,
          bar,
          -NO_BAR,
          alphas.size(),
          "alpha " + std::to_string(static_cast<double>(worst.point) * 1e-6)};
}

/// The same for D(h) of two widths: the half vectors are those of the very lobe.
template <class Distribution>
Figure stretched(const char* name, double bar, Distribution d) {
  Worst worst;
  std::uint64_t count = 0;
  std::string where;
  for (const double along : ALPHAS) {
    for (const double across : ALPHAS) {
      double sum = 0;
      constexpr int SIDE = 512;
      for (int i = 0; i < SIDE; ++i) {
        for (int j = 0; j < SIDE; ++j) {
          // Slopes spread twice as wide as the lobe: an even weight would prove nothing.
          const double u = (i + 0.5) / SIDE, slope = 2 * std::sqrt(u / (1 - u)), phi = test::TWO_PI * (j + 0.5) / SIDE;
          const vec3 h = glm::normalize(vec3(along * slope * std::cos(phi), across * slope * std::sin(phi), 1));
          const vec3 x(h.x / (2 * along), h.y / (2 * across), h.z);
          const double density = 1 / (test::TWO_PI / 2 * 4 * along * across * glm::dot(x, x) * glm::dot(x, x)) * h.z;
          sum += d(along, across, h) * h.z / density / (double(SIDE) * SIDE);
        }
      }
      const double worstBefore = worst.value;
      worst.see(std::abs(sum - 1), ++count);
      if (worst.value != worstBefore) where = "alpha " + std::to_string(along) + " by " + std::to_string(across);
    }
  }
  return {std::string("|projected area - 1| of ") + name, "", worst.value, bar, -NO_BAR, count, where};
}

}  // namespace

std::vector<Figure> checkDistributions(Scale) {
  std::vector<Figure> out;
  const auto all = {0.002025, 0.01, 0.04, 0.09, 0.25, 0.49, 0.81, 1.0};
  out.push_back(isotropic("D_GGX", 1e-3, all, [](double a, double NoH) { return D_GGX(a, NoH); }));
  out.push_back(
      isotropic("D_GGXRobust", 1e-3, all, [](double a, double NoH) { return D_GGXRobust(a, NoH, 1 - NoH * NoH); }));
  out.push_back(isotropic("D_GTR1", 1e-3, all, [](double a, double NoH) { return D_GTR1(a, NoH); }));
  out.push_back(isotropic("D_Charlie", 4e-4, all, [](double a, double NoH) { return D_Charlie(a, NoH); }));
  // Normalised about: the fit is its source's.
  out.push_back(
      isotropic("D_Ashikhmin", 1e-2, {0.2, 0.5, 1.0}, [](double a, double NoH) { return D_Ashikhmin(a, NoH); }));
  out.push_back(stretched("D_GGXAnisotropic", 1e-3,
                          [](double x, double y, const vec3& h) { return D_GGXAnisotropic(x, y, h.z, h.x, h.y); }));
  return out;
}

std::vector<Figure> checkPdfs(Scale scale) {
  // Narrow lobes need more points than a test has: from a perceptual roughness of 0.3 on.
  const std::uint64_t count = countOf(scale, 20, 400);
  constexpr int ROWS = 256;
  std::vector<Worst> parts(partCount());
  const auto surfaceOf = [](std::uint64_t seed) {
    Seeded r(seed);
    Layers layers = Layers::random(r);
    layers.transmission = false;
    Material m = randomMaterial(r, layers);
    m.roughnessFactor = std::max(m.roughnessFactor, 0.3f);
    m.layers.clearcoatRoughnessFactor = std::max(m.layers.clearcoatRoughnessFactor, 0.3f);
    for (Yarn* yarn : {&m.fabric.warp, &m.fabric.weft}) yarn->roughness = std::max(yarn->roughness, 0.3f);
    return pointOn(ShadingModel::kThree, m, {r.between(0.05, 1)});
  };
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    for (std::uint64_t i = from; i < to; ++i) {
      const reference::LobeSampler sampler(surfaceOf(i).info);
      double sum = 0;
      for (int row = 0; row < 2 * ROWS; ++row) {
        for (int column = 0; column < 4 * ROWS; ++column) {
          const glm::dvec3 l = test::direction(-1 + (row + 0.5) / ROWS, test::TWO_PI * (column + 0.5) / (4 * ROWS));
          sum += static_cast<double>(sampler.pdf(glm::vec3(l)));
        }
      }
      parts[part].see(std::abs(sum * 2 * test::TWO_PI / (8.0 * ROWS * ROWS) - 1), i);
    }
  });
  Worst worst;
  for (const Worst& part : parts) worst.see(part);
  return {{"|integral of the path tracer's pdf - 1|, any material", "", worst.value, 1e-3, -NO_BAR, count,
           "seed " + std::to_string(worst.point) + ": " + describe(surfaceOf(worst.point))}};
}

}  // namespace telar::numerics
