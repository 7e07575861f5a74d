#include "telar/lobes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "lobes/lobe_mixture.h"
#include "lobes/material_surface.h"

namespace telar {
namespace {

using brdf_d::Reflected;
using glm::dvec2;
using glm::dvec3;

/// Estimates that the albedo is the mean of. Each has its own scrambled points.
constexpr std::uint32_t REPLICATES = 16;
/// Points of one estimate for each sampling technique. They are doubled until the error is small.
constexpr std::uint32_t POINTS_MIN = 256, POINTS_MAX = 8192;
constexpr double ALBEDO_TOLERANCE = 1e-6;
/// Quantile of Student's distribution with 15 degrees of freedom: 999 means in 1000 are off by fewer standard errors.
constexpr double STUDENT = 4.073;
/// Relative error of points that have 24 bits.
constexpr double UNIFORM_STEP = 6e-8;

Reflected nothing() { return brdf_d::nothingReflected(); }

}  // namespace

struct ShadedMaterial::State {
  ShadingModel shading;
  brdf_d::ShadingFunctions functions;
  brdf_d::SurfaceInfo surface;

  Reflected lit(Reflected sum, const glm::dvec3& l, double irradiance) const {
    return functions.addPunctual(sum, surface, l, glm::dvec3(irradiance));
  }

  /// Radiance of each lobe. Composing is linear, so each lobe can be composed alone.
  LobeRadiance composed(const Reflected& sum) const {
    const auto alone = [&](auto lobe) {
      Reflected direct = nothing();
      direct.*lobe = sum.*lobe;
      return functions.composedRadiance(surface, direct.diffuse, direct, nothing(), glm::dvec3(0));
    };
    LobeRadiance out{alone(&Reflected::diffuse), alone(&Reflected::specular), alone(&Reflected::sheen),
                     alone(&Reflected::coat)};
    out.total = functions.composedRadiance(surface, sum.diffuse, sum, nothing(), glm::dvec3(0));
    return out;
  }
};

ShadedMaterial::ShadedMaterial(const Scene& scene, std::size_t material, const Shot& shot, double viewAngle) {
  const Material& shown = shownMaterial(scene, scene.materials[material], shot.shading);
  const brdf_d::ShadingFunctions functions = brdf_d::shadingFunctions(shot.shading);
  const glm::dvec3 v(std::sin(viewAngle), 0, std::cos(viewAngle));
  state_ = std::make_shared<State>(
      State{shot.shading, functions, functions.preparedSurface(lobes::surfaceOf(shown, shot, v))});
}

LobeRadiance ShadedMaterial::radiance(const glm::dvec3& l) const {
  return state_->composed(state_->lit(nothing(), l, 1));
}

namespace {

/// The sums of one replicate, times a factor.
LobeRadiance scaled(const LobeRadiance& x, double by) {
  return {x.diffuse * by, x.specular * by, x.sheen * by, x.coat * by, x.total * by};
}

constexpr std::array LOBES{&LobeRadiance::diffuse, &LobeRadiance::specular, &LobeRadiance::sheen, &LobeRadiance::coat,
                           &LobeRadiance::total};

/// Mean of the replicates and a bound of its error.
Albedo estimated(const std::vector<LobeRadiance>& replicates) {
  const auto count = static_cast<double>(replicates.size());
  Albedo albedo;
  for (auto lobe : LOBES) {
    dvec3 mean(0), square(0);
    for (const LobeRadiance& r : replicates) mean += r.*lobe / count;
    for (const LobeRadiance& r : replicates) square += (r.*lobe - mean) * (r.*lobe - mean) / (count * (count - 1));
    albedo.value.*lobe = mean;
    albedo.error.*lobe = STUDENT * glm::sqrt(square) + UNIFORM_STEP * mean;
  }
  return albedo;
}

bool isSettled(const Albedo& albedo) {
  return std::all_of(LOBES.begin(), LOBES.end(), [&](auto lobe) {
    const dvec3& error = albedo.error.*lobe;
    return std::max({error.x, error.y, error.z}) <= ALBEDO_TOLERANCE;
  });
}

}  // namespace

// Each replicate is an unbiased estimate, so their spread gives the error of their mean.
// src: Owen 1997, "Monte Carlo Variance of Scrambled Net Quadrature"
Albedo ShadedMaterial::albedo(const CancelToken& cancel) const {
  const lobes::LobeMixture mixture(state_->shading, state_->surface);
  std::vector<Reflected> sums(REPLICATES, nothing());
  Albedo albedo;
  std::uint32_t from = 0;
  for (std::uint32_t points = POINTS_MIN; points <= POINTS_MAX; from = points, points *= 2) {
    std::vector<LobeRadiance> replicates;
    for (std::uint32_t replicate = 0; replicate < REPLICATES; ++replicate) {
      cancel.check();
      for (std::uint32_t i = from; i < points; ++i) {
        Random random(1, replicate, i);
        for (std::size_t technique = 0; technique < mixture.techniques(); ++technique) {
          const dvec3 l = mixture.sample(technique, dvec2(random.uniform2()));
          if (l.z > 0) sums[replicate] = state_->lit(sums[replicate], l, 1 / mixture.pdfSum(l));
        }
      }
      replicates.push_back(scaled(state_->composed(sums[replicate]), 1.0 / points));
    }
    albedo = estimated(replicates);
    if (isSettled(albedo)) break;
  }
  return albedo;
}

}  // namespace telar
