// Every distribution of normals projects to an area of 1, and every pdf is one whole.
#include <algorithm>
#include <array>
#include <atomic>

#include "brdf/quadrature.h"
#include "checks.h"
#include "evaluate.h"
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
          "alpha " + std::to_string(static_cast<double>(worst.point) * 1e-6),
          alphas.size()};
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
      constexpr int GRID = 512;
      for (int i = 0; i < GRID; ++i) {
        for (int j = 0; j < GRID; ++j) {
          // Slopes spread twice as wide as the lobe: an even weight would prove nothing.
          const double u = (i + 0.5) / GRID, slope = 2 * std::sqrt(u / (1 - u)), phi = test::TWO_PI * (j + 0.5) / GRID;
          const vec3 h = glm::normalize(vec3(along * slope * std::cos(phi), across * slope * std::sin(phi), 1));
          const vec3 x(h.x / (2 * along), h.y / (2 * across), h.z);
          const double density = 1 / (test::TWO_PI / 2 * 4 * along * across * glm::dot(x, x) * glm::dot(x, x)) * h.z;
          sum += d(along, across, h) * h.z / density / (double(GRID) * GRID);
        }
      }
      const double worstBefore = worst.value;
      worst.see(std::abs(sum - 1), ++count);
      if (worst.value != worstBefore) where = "alpha " + std::to_string(along) + " by " + std::to_string(across);
    }
  }
  return {std::string("|projected area - 1| of ") + name, "", worst.value, bar, -NO_BAR, count, where, count};
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

namespace {

/// Nodes and weights of a cell's side, on [0, 1].
/// src: Abramowitz & Stegun 1964, "Handbook of Mathematical Functions", table 25.4, five points
struct Node {
  double at, weight;
};
constexpr std::array<Node, 5> NODES{{{0.046910077030668, 0.118463442528095},
                                     {0.230765344947158, 0.239314335249683},
                                     {0.5, 0.284444444444444},
                                     {0.769234655052842, 0.239314335249683},
                                     {0.953089922969332, 0.118463442528095}}};

/// A part of the sphere: from and to in the cosine with +z and in the azimuth, radians.
struct Cell {
  glm::dvec2 from, to;
};

template <class Density>
double once(const Cell& cell, const Density& density) {
  const glm::dvec2 size = cell.to - cell.from;
  double sum = 0;
  for (const Node& x : NODES) {
    for (const Node& y : NODES)
      sum += x.weight * y.weight * density(test::direction(cell.from.x + size.x * x.at, cell.from.y + size.y * y.at));
  }
  return sum * size.x * size.y;
}

/// Integral over the cell, halved in both ways until its quarters say the same.
template <class Density>
double integral(const Cell& cell, const Density& density, double whole, int depth) {
  constexpr double ERROR = 1e-8;
  constexpr int DEEPEST = 12;
  const glm::dvec2 middle = (cell.from + cell.to) * 0.5;
  const Cell quarters[] = {{cell.from, middle},
                           {{middle.x, cell.from.y}, {cell.to.x, middle.y}},
                           {{cell.from.x, middle.y}, {middle.x, cell.to.y}},
                           {middle, cell.to}};
  double parts[4], sum = 0;
  for (int i = 0; i < 4; ++i) sum += parts[i] = once(quarters[i], density);
  if (depth == DEEPEST || std::abs(sum - whole) < ERROR) return sum;
  sum = 0;
  for (int i = 0; i < 4; ++i) sum += integral(quarters[i], density, parts[i], depth + 1);
  return sum;
}

/// Integral over the sphere of a density that is smooth but where the cosine is one of `steps`.
template <class Density>
double overSphere(std::vector<double> steps, const Density& density) {
  constexpr int BANDS = 8, SECTORS = 32;  // narrower than the lobes
  steps.insert(steps.end(), {-1, 1});
  std::sort(steps.begin(), steps.end());
  double sum = 0;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    for (int i = 0; i < BANDS * SECTORS; ++i) {
      const double band = (steps[k + 1] - steps[k]) / BANDS, sector = test::TWO_PI / SECTORS;
      const glm::dvec2 from(steps[k] + band * (i % BANDS), sector * (i / BANDS));
      const Cell cell{from, from + glm::dvec2(band, sector)};
      sum += integral(cell, density, once(cell, density), 0);
    }
  }
  return sum;
}

/// A surface of any lobes that are no narrower than the cells of overSphere(): a perceptual roughness of 0.3.
SurfacePoint drawnFrom(std::uint64_t seed) {
  constexpr float NARROWEST = 0.3f;
  Seeded r(seed);
  Layers layers = Layers::random(r);
  layers.transmission = false;
  Material m = randomMaterial(r, layers);
  m.roughnessFactor = std::max(m.roughnessFactor, NARROWEST);
  m.layers.clearcoatRoughnessFactor = std::max(m.layers.clearcoatRoughnessFactor, NARROWEST);
  for (Yarn* yarn : {&m.fabric.warp, &m.fabric.weft})
    yarn->roughnessFactor = std::max(yarn->roughnessFactor, NARROWEST);
  return pointOn(ShadingModel::kFabric, m, {r.between(0.05, 1)});
}

}  // namespace

std::vector<Figure> checkPdfs(Scale scale) {
  constexpr std::uint64_t FULL = 400;
  const std::uint64_t count = scale == Scale::kFull ? FULL : 20;
  std::vector<Worst> parts(partCount());
  std::atomic<std::uint64_t> woven = 0;
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    for (std::uint64_t i = from; i < to; ++i) {
      const SurfacePoint point = drawnFrom(i);
      woven += hasYarns(point);
      const brdf_f::LobeMixture lobes = brdf_f::lobeMixture(point.info);
      // Densities end at the horizon, and those of reflection where the half vector lies in the surface.
      const double whole = overSphere({0, -double{point.info.v.z}}, [&](const glm::dvec3& l) {
        return static_cast<double>(brdf_f::pdfMixture(lobes, glm::vec3(l)));
      });
      parts[part].see(std::abs(whole - 1), i);
    }
  });
  Worst worst;
  for (const Worst& part : parts) worst.see(part);
  return {{"|integral of the path tracer's pdf - 1|, any material", "", worst.value, 1e-3, -NO_BAR, count,
           "seed " + std::to_string(worst.point) + ": " + describe(drawnFrom(worst.point)), FULL},
          {"materials that show yarns, of these", "", static_cast<double>(woven), NO_BAR,
           static_cast<double>(count / 4), count, "", FULL}};
}

}  // namespace telar::numerics
