// Woven cloth of any yarns, white, in light of radiance 1 from everywhere, seen from any side.
#include "weaves.h"

#include <algorithm>
#include <numbers>

#include "albedo.h"
#include "checks.h"
#include "worst.h"

namespace telar::numerics {
namespace {

Yarn yarn(Seeded& r, double coverage) {
  const auto roughness = static_cast<float>(r.edged(0, 1, {0, 0.045, 0.1, 1}, 0.2));
  return {static_cast<float>(coverage), roughness, static_cast<float>(r.edged(0, 1, {0, 0.5, 1}, 0.2)), glm::vec3(1)};
}

struct Albedos {
  double direct, environment;
  bool yarns;  ///< it is shaded as woven cloth
};

Albedos albedosOf(const ShadingPromise& shading, const SeenWeave& weave, int points) {
  const SurfacePoint p = pointOn(shading.model, weave.material, weave.seen);
  const Shaded<double> shaded(shading.model, inDouble(p.info));
  return {directAlbedo(shaded, points), shaded.environment().y, hasYarns(p)};
}

/// Three quadratures in turn, each with twice the points of the one before, that are no further apart than this give
/// the integral. Two are not enough: among 20,000 weaves some agree by chance while both are wrong by a hundredth.
constexpr double SETTLED = 5e-4;

/// The albedos by as many directions as they need: narrow lobes that graze need 64 times as many as wide ones.
Albedos settledAlbedosOf(const ShadingPromise& shading, const SeenWeave& weave) {
  constexpr int MOST_POINTS = 1 << 17;
  Albedos last = albedosOf(shading, weave, 1 << 9);
  for (int points = 1 << 10, agreed = 0;; points *= 2) {
    const Albedos now = albedosOf(shading, weave, points);
    agreed = std::abs(now.direct - last.direct) < SETTLED ? agreed + 1 : 0;
    if (agreed == 2 || points == MOST_POINTS) return now;
    last = now;
  }
}

std::vector<Albedos> measured(const ShadingPromise& shading, std::uint64_t count) {
  std::vector<Albedos> all(count);
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned) {
    for (std::uint64_t i = from; i < to; ++i) all[i] = settledAlbedosOf(shading, randomWeave(i));
  });
  return all;
}

}  // namespace

SeenWeave randomWeave(std::uint64_t seed) {
  Seeded r(seed ^ 0x77656176u);
  SeenWeave weave;
  Material& m = weave.material;
  m.physical = true;
  m.baseColorFactor = glm::vec4(1);
  m.metallicFactor = static_cast<float>(r.edged(0, 1, {0, 1}, 0.8));
  m.roughnessFactor = static_cast<float>(r.unit());
  const double covered = 1 - r.edged(0, 0.5, {0, 0.5}, 0.4), warp = covered * r.edged(0, 1, {0, 0.5, 1}, 0.3);
  m.fabric.weave = true;
  m.fabric.warp = yarn(r, warp);
  m.fabric.weft = yarn(r, covered - warp);
  weave.seen.NoV = r.edged(0.02, 1, {0.02, 0.05, 0.1, 1}, 0.3);
  weave.seen.turn = r.between(-std::numbers::pi, std::numbers::pi);
  return weave;
}

std::string describe(const SeenWeave& weave) {
  return "NoV " + std::to_string(weave.seen.NoV) + ", azimuth " + std::to_string(weave.seen.turn) + ", " +
         describe(weave.material);
}

std::vector<Figure> checkWeaves(const ShadingPromise& shading, Scale scale) {
  constexpr std::uint64_t FULL = 20'000;
  const std::vector<Albedos> all = measured(shading, countOf(scale, 200, FULL));
  Worst most, apart, mostOfEnvironment;
  double leastWhole = 1e9, leastWithGaps = 1e9;
  std::uint64_t wholeAt = 0, gapsAt = 0, woven = 0, far = 0;
  for (std::uint64_t i = 0; i < all.size(); ++i) {
    const SeenWeave weave = randomWeave(i);
    const auto& [direct, environment, yarns] = all[i];
    woven += yarns;
    most.see(direct, i);
    mostOfEnvironment.see(environment, i);
    apart.see(std::abs(direct - environment), i);
    far += std::abs(direct - environment) > 0.02;
    const double least = std::min(direct, environment) / weave.coverage();
    double& lowest = weave.hasGaps() ? leastWithGaps : leastWhole;
    if (!(least >= lowest)) lowest = least, (weave.hasGaps() ? gapsAt : wholeAt) = i;
  }
  std::vector<Figure> out;
  const auto add = [&](const char* what, double value, double high, double low, std::uint64_t at) {
    out.push_back({what, shading.name, value, high, low, all.size(),
                   "weave " + std::to_string(at) + ": " + describe(randomWeave(at)), FULL});
  };
  const auto count = static_cast<double>(all.size());
  out.push_back(
      {"weaves that show yarns", shading.name, static_cast<double>(woven), count, count, all.size(), "", FULL});
  add("any weave, light from everywhere: most", most.value, 1.005, -NO_BAR, most.point);
  add("any weave, environment: most", mostOfEnvironment.value, 1.005, -NO_BAR, mostOfEnvironment.point);
  add("any weave without gaps: least of both", leastWhole, NO_BAR, 0.90, wholeAt);
  add("any weave with gaps: least of both, of what the yarns cover", leastWithGaps, NO_BAR, 0.90, gapsAt);
  add("any weave: largest difference of light from everywhere and environment", apart.value, NO_BAR, -NO_BAR,
      apart.point);
  // The fits of what yarns reflect are less close where they graze.
  add("weaves for which they are more than 0.02 apart", static_cast<double>(far), count / 100, -NO_BAR, apart.point);
  return out;
}

}  // namespace telar::numerics
