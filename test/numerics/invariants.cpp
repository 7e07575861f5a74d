// Reciprocity, peaks, slopes.
#include <algorithm>
#include <numbers>
#include <vector>

#include "checks.h"
#include "evaluate.h"
#include "surface_point.h"
#include "worst.h"

namespace telar::numerics {
namespace {

Directions randomDirections(Seeded& r, double least) {
  const auto cosine = [&] { return r.edged(least, 1, {least, 0.1, 1}); };
  const double NoV = cosine(), NoL = cosine();
  return {NoV, NoL, r.edged(-std::numbers::pi, std::numbers::pi, {0, 1e-3, std::numbers::pi}),
          r.between(-std::numbers::pi, std::numbers::pi)};
}

/// Without what looks at the viewer by its definition: a film's colour.
SurfacePoint exchangeable(ShadingModel model, std::uint64_t seed) {
  Seeded r(seed);
  Layers layers = Layers::random(r);
  layers.iridescence = layers.transmission = false;
  const Material material = randomMaterial(r, layers);
  return pointOn(model, material, randomDirections(r, 0.01));
}

double unequal(const glm::dvec3& a, const glm::dvec3& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c)
    worst = std::max(worst, std::abs(a[c] - b[c]) / std::max({std::abs(a[c]), std::abs(b[c]), 1e-6}));
  return worst;
}

/// The lobes of light from `l` seen from `v`, each over the cosine of the light.
/// Both are unit to a double's rounding: a float leaves 1e-7 of their length, and where they are nearly opposite (0.01
/// from the ground at both sides) that is 5e-6 of the half vector and 3e-4 of what asks for the angle to it.
brdf_d::Reflected lobesBetween(ShadingModel model, const SurfacePoint& seen, const glm::dvec3& v, const glm::dvec3& l) {
  brdf_d::SurfaceInfo info = inDouble(seen.info);
  info.v = v;
  brdf_d::Reflected lobes = Shaded<double>(model, info).lobes(l);
  for (glm::dvec3* lobe : {&lobes.diffuse, &lobes.specular, &lobes.sheen, &lobes.coat})
    *lobe /= l.z;  // the normal is +z
  return lobes;
}

}  // namespace

std::vector<Figure> checkReciprocity(const ShadingPromise& shading, Scale scale) {
  constexpr double BAR = 1e-4;
  constexpr std::uint64_t FULL = 1'000'000;
  const std::uint64_t count = countOf(scale, 20'000, FULL);
  struct Lobes {
    Worst diffuse, specular, sheen, coat;
    std::uint64_t woven = 0;
  };
  std::vector<Lobes> parts(partCount());
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    for (std::uint64_t i = from; i < to; ++i) {
      const SurfacePoint a = exchangeable(shading.model, i), b = exchanged(a);
      const glm::dvec3 v = glm::normalize(glm::dvec3(a.info.v)), l = glm::normalize(glm::dvec3(a.l));
      const auto forward = lobesBetween(shading.model, a, v, l), back = lobesBetween(shading.model, b, l, v);
      parts[part].woven += hasYarns(a) && hasYarns(b);
      parts[part].diffuse.see(unequal(forward.diffuse, back.diffuse), i);
      parts[part].specular.see(unequal(forward.specular, back.specular), i);
      parts[part].sheen.see(unequal(forward.sheen, back.sheen), i);
      parts[part].coat.see(unequal(forward.coat, back.coat), i);
    }
  });
  std::vector<Figure> out;
  const auto add = [&](const char* lobe, Worst Lobes::*member, bool promised) {
    Worst worst;
    for (const Lobes& part : parts) worst.see(part.*member);
    out.push_back({std::string("relative difference with viewer and light exchanged, ") + lobe, shading.name,
                   worst.value, promised ? BAR : NO_BAR, -NO_BAR, count,
                   "seed " + std::to_string(worst.point) + ": " + describe(exchangeable(shading.model, worst.point)),
                   FULL});
  };
  add("diffuse", &Lobes::diffuse, shading.reciprocal.diffuse);
  add("specular", &Lobes::specular, shading.reciprocal.specular);
  add("sheen", &Lobes::sheen, shading.reciprocal.sheen);
  add("coat", &Lobes::coat, shading.reciprocal.coat);
  if (shading.weaves) {
    std::uint64_t woven = 0;
    for (const Lobes& part : parts) woven += part.woven;
    out.push_back({"points that show yarns, exchanged", shading.name, static_cast<double>(woven), NO_BAR,
                   static_cast<double>(count / 4), count, "", FULL});
  }
  return out;
}

namespace {

/// Largest radiance of the GGX lobe over the plane of incidence, where its peak lies.
double peak(ShadingModel model, const Material& material, double NoV) {
  const SurfacePoint p = pointOn(model, material, {NoV});
  const Shaded<double> shaded(model, inDouble(p.info));
  const double towards = std::acos(NoV), alpha = shaded.info().alpha;
  double most = 0;
  for (int i = -400; i <= 400; ++i) {
    // Dense about the mirror direction: angles of up to a quarter turn, as the lobe is wide.
    const double t = i / 400.0,
                 angle = towards + std::copysign(std::min(std::numbers::pi, 8 * alpha + 0.05) * t * t, t);
    if (std::abs(angle) >= std::numbers::pi / 2) continue;
    const SurfacePoint lit = pointOn(model, material, {NoV, std::cos(angle), angle >= 0 ? std::numbers::pi : 0});
    most = std::max(most, shaded.lobes(glm::dvec3(lit.l)).specular.y);
  }
  return most;
}

}  // namespace

std::vector<Figure> checkMonotone(const ShadingPromise& shading, Scale scale) {
  constexpr std::uint64_t FULL = 95, CURVES = 8;  // steps of a curve; two kinds of metalness, four cosines
  const std::uint64_t steps = countOf(scale, FULL / 5, FULL);
  const double step = (1 - 0.045) / static_cast<double>(steps);
  Worst rise;
  std::string where;
  std::uint64_t count = 0;
  for (const float metallic : {0.0f, 1.0f}) {
    for (const double NoV : {0.1, 0.3, 0.6, 1.0}) {
      double lowest = -1;  // so far
      for (std::uint64_t i = 0; i <= steps; ++i) {
        const double roughness = 0.045 + step * static_cast<double>(i);
        Material m;
        m.metallicFactor = metallic;
        m.roughnessFactor = static_cast<float>(roughness);
        const double now = peak(shading.model, m, NoV), worst = rise.value;
        if (lowest >= 0) rise.see(std::max(0.0, now / lowest - 1), ++count);
        if (rise.value != worst) where = "NoV " + std::to_string(NoV) + ", " + describe(m);
        lowest = lowest < 0 ? now : std::min(lowest, now);
      }
    }
  }
  // The plane of incidence is sampled: a thousandth is its resolution. The rest of the bar is what later bounces
  // between the microfacets add where the lobe is widest.
  return {{"rise of the peak with roughness over its lowest, relative", shading.name, rise.value,
           shading.conserves ? 3e-2 : NO_BAR, -NO_BAR, count, where, FULL * CURVES}};
}

namespace {

/// A material and directions, moved a little.
SurfacePoint moved(ShadingModel model, std::uint64_t seed, double roughnessStep, double cosineStep) {
  Seeded r(seed);
  Material m = randomMaterial(r, Layers::random(r));
  Directions d = randomDirections(r, 0.1);
  // Above 0.0525 + the step, so that no floor hides the slope.
  m.roughnessFactor = static_cast<float>(0.089 + (0.998 - 0.089) * m.roughnessFactor + roughnessStep);
  m.layers.clearcoatRoughnessFactor = std::max(m.layers.clearcoatRoughnessFactor, 0.089f);
  m.fabric.warp.roughnessFactor = std::max(m.fabric.warp.roughnessFactor, 0.089f);
  m.fabric.weft.roughnessFactor = std::max(m.fabric.weft.roughnessFactor, 0.089f);
  d.NoV = 0.101 + 0.898 * (d.NoV - 0.1) / 0.9 + cosineStep;
  return pointOn(model, m, d);
}

}  // namespace

std::vector<Figure> checkGradients(const ShadingPromise& shading, Scale scale) {
  constexpr double STEP = 1e-3, BAR = 1e7;
  constexpr std::uint64_t FULL = 1'000'000;
  const std::uint64_t count = countOf(scale, 20'000, FULL);
  std::vector<std::array<Worst, 2>> parts(partCount());
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    const auto at = [&](std::uint64_t seed, double roughness, double cosine) {
      const SurfacePoint p = moved(shading.model, seed, roughness, cosine);
      return Shaded<double>(shading.model, inDouble(p.info)).direct(glm::dvec3(p.l));
    };
    for (std::uint64_t i = from; i < to; ++i) {
      const glm::dvec3 byRoughness = (at(i, STEP, 0) - at(i, -STEP, 0)) / (2 * STEP);
      const glm::dvec3 byCosine = (at(i, 0, STEP) - at(i, 0, -STEP)) / (2 * STEP);
      parts[part][0].see(std::max({std::abs(byRoughness.x), std::abs(byRoughness.y), std::abs(byRoughness.z)}), i);
      parts[part][1].see(std::max({std::abs(byCosine.x), std::abs(byCosine.y), std::abs(byCosine.z)}), i);
    }
  });
  std::vector<Figure> out;
  for (int k = 0; k < 2; ++k) {
    Worst worst;
    for (const auto& part : parts) worst.see(part[static_cast<std::size_t>(k)]);
    out.push_back({std::string("slope of the radiance by ") + (k ? "NoV" : "roughness"), shading.name, worst.value, BAR,
                   -NO_BAR, count,
                   "seed " + std::to_string(worst.point) + ": " + describe(moved(shading.model, worst.point, 0, 0)),
                   FULL});
  }
  return out;
}

}  // namespace telar::numerics
