// White furnace: what a white cloth sends back of light that comes from everywhere, by direct lights and by an
// environment, for each layer alone and for any mix of them.
#include "checks.h"
#include "evaluate.h"
#include "mixture.h"
#include "surface_point.h"
#include "worst.h"

namespace telar::numerics {
namespace {

constexpr double COSINES[] = {0.02, 0.05, 0.1, 0.2, 0.3, 0.6, 1.0};
constexpr double ROUGHNESSES[] = {0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1.0};

struct Sheet {
  std::string layer;
  Material material;
};

Material white(double roughness, double metallic = 0) {
  Material m;
  m.physical = true;
  m.roughnessFactor = static_cast<float>(roughness);
  m.metallicFactor = static_cast<float>(metallic);
  return m;
}

/// White cloths: each layer at every roughness, and mixes.
std::vector<Sheet> sheets(Scale scale) {
  std::vector<Sheet> list;
  for (const double roughness : ROUGHNESSES) {
    list.push_back({"base", white(roughness)});
    for (const double metallic : {0.5, 1.0}) list.push_back({"metal", white(roughness, metallic)});
    Material sheen = white(scale == Scale::kFull ? 0.8 : 1.0);
    sheen.layers.sheen = true;
    sheen.layers.sheenColorFactor = glm::vec3(1);
    sheen.layers.sheenRoughnessFactor = static_cast<float>(roughness);
    list.push_back({"sheen", sheen});
    Material coat = white(0.7);
    coat.layers.clearcoatFactor = 1;
    coat.layers.clearcoatRoughnessFactor = static_cast<float>(roughness);
    list.push_back({"coat", coat});
    Material stretched = white(roughness);
    stretched.layers.anisotropyStrength = 0.9f;
    list.push_back({"stretched", stretched});
    Material rough = white(roughness);
    rough.layers.diffuseRoughnessFactor = 1;
    list.push_back({"rough diffuse", rough});
    Material woven = white(roughness);
    woven.fabric.weave = true;
    woven.fabric.warp = {0.55f, static_cast<float>(roughness), 0.8f};
    woven.fabric.weft = {0.45f, static_cast<float>(roughness), 0.8f};
    list.push_back({"yarns", woven});
  }
  for (std::uint64_t seed = 0; seed < countOf(scale, 24, 300); ++seed) {
    Seeded random(seed);
    list.push_back({"any mix", whiteCloth(random)});
  }
  return list;
}

/// Of direct light from everywhere, radiance 1: the quadrature knows the lobes of every shading.
double directAlbedo(ShadingModel model, const Sheet& sheet, double NoV, int points) {
  const SurfacePoint p = pointOn(model, sheet.material, {NoV});
  const Shaded<double> shaded(model, inDouble(p.info));
  const auto& s = shaded.info();
  std::vector<Lobe> lobes{{glm::dmat3(s.t, s.b, s.n), {std::max(s.alphaT, s.alpha), s.alpha}}};
  if (s.clearcoat > 0) lobes.push_back({glm::dmat3(1.0), glm::dvec2(s.clearcoatRoughness * s.clearcoatRoughness)});
  if (sheet.material.fabric.weave) {
    for (const bool across : {false, true}) {
      const Yarn& yarn = across ? sheet.material.fabric.weft : sheet.material.fabric.warp;
      const double narrow = std::max(yarn.roughness * yarn.roughness, 0.002f);
      lobes.push_back({glm::dmat3(across ? s.b : s.t, across ? -s.t : s.b, s.n), {std::max(narrow, 0.5), narrow}});
    }
  }
  std::optional<Fuzz> fuzz;
  if (s.sheenColor != glm::dvec3(0)) {
    const glm::dvec3 ltc = brdf_d::sheenLtc(std::max(s.sheenRoughness, brdf_d::CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
    const glm::dvec3 along(s.v.x, s.v.y, 0);
    fuzz = Fuzz{glm::length(along) > 1e-9 ? glm::normalize(along) : glm::dvec3(1, 0, 0), ltc.y, ltc.z};
  }
  return Mixture(s.v, lobes, points, fuzz).integrate([&](const glm::dvec3& l) { return shaded.direct(l).y; });
}

/// Least and largest albedo of the sheets of each layer.
template <class Albedo>
std::vector<Figure> extremes(const ShadingPromise& shading, const std::vector<Sheet>& list, const std::string& light,
                             Albedo albedo) {
  struct Range {
    std::string layer;
    double least = 1e9, most = -1e9;
    std::string leastAt, mostAt;
    std::uint64_t points = 0;
  };
  std::vector<std::array<double, std::size(COSINES)>> all(list.size());
  inParallel(list.size(), [&](std::uint64_t from, std::uint64_t to, unsigned) {
    for (std::uint64_t i = from; i < to; ++i)
      for (std::size_t j = 0; j < std::size(COSINES); ++j) all[i][j] = albedo(list[i], COSINES[j]);
  });
  std::vector<Range> ranges;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Sheet& sheet = list[i];
    auto range = std::find_if(ranges.begin(), ranges.end(), [&](const Range& r) { return r.layer == sheet.layer; });
    if (range == ranges.end()) range = ranges.insert(ranges.end(), {sheet.layer});
    for (std::size_t j = 0; j < std::size(COSINES); ++j) {
      const double e = all[i][j];
      const std::string at = "NoV " + std::to_string(COSINES[j]).substr(0, 4) + ", " + describe(sheet.material);
      if (!(e >= range->least)) range->least = e, range->leastAt = at;
      if (!(e <= range->most)) range->most = e, range->mostAt = at;
      ++range->points;
    }
  }
  std::vector<Figure> out;
  for (const Range& r : ranges) {
    const double high = shading.conserves ? 1.005 : NO_BAR, low = shading.conserves ? 0.90 : -NO_BAR;
    out.push_back({light + ", " + r.layer + ": most", shading.name, r.most, high, -NO_BAR, r.points, r.mostAt});
    out.push_back({light + ", " + r.layer + ": least", shading.name, r.least, NO_BAR, low, r.points, r.leastAt});
  }
  return out;
}

}  // namespace

std::vector<Figure> checkFurnaceDirect(const ShadingPromise& shading, Scale scale) {
  const int points = static_cast<int>(countOf(scale, 1 << 12, 1 << 14));
  return extremes(shading, sheets(scale), "direct light",
                  [&](const Sheet& sheet, double NoV) { return directAlbedo(shading.model, sheet, NoV, points); });
}

std::vector<Figure> checkFurnaceEnvironment(const ShadingPromise& shading, Scale scale) {
  return extremes(shading, sheets(scale), "environment", [&](const Sheet& sheet, double NoV) {
    return Shaded<double>(shading.model, inDouble(pointOn(shading.model, sheet.material, {NoV}).info)).environment().y;
  });
}

}  // namespace telar::numerics
