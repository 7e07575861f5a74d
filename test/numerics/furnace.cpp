// White furnace: what a white cloth sends back of light that comes from everywhere, by direct lights and by an
// environment, for each layer alone and for any mix of them, from all sides.
#include <algorithm>
#include <array>
#include <numbers>

#include "albedo.h"
#include "checks.h"
#include "evaluate.h"
#include "surface_point.h"

namespace telar::numerics {
namespace {

constexpr double COSINES[] = {0.02, 0.05, 0.1, 0.2, 0.3, 0.6, 1.0};
constexpr double ROUGHNESSES[] = {0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1.0};

/// Of the viewer against the tangent. A quarter turn is all of a lobe of two axes.
constexpr double AZIMUTHS[] = {0,
                               std::numbers::pi / 12,
                               std::numbers::pi / 6,
                               std::numbers::pi / 4,
                               std::numbers::pi / 3,
                               5 * std::numbers::pi / 12,
                               std::numbers::pi / 2};
constexpr std::uint64_t MIXES = 300;

struct Sheet {
  std::string layer;
  Material material;
  bool turned = false;     ///< it looks different from other azimuths
  std::uint64_t seed = 0;  ///< of the azimuths of a mix
};

/// Of the lists: at the least scale, each third.
std::size_t stepOf(Scale scale) { return scale == Scale::kLeast ? 3 : 1; }

/// Of the azimuths: each 30 degrees, and between them at the full scale alone.
std::size_t azimuthStepOf(Scale scale) { return scale == Scale::kQuick ? 2 : stepOf(scale); }

struct View {
  double NoV, azimuth;
};

/// Every cosine, and every azimuth where it matters, or some of both; of a mix one azimuth a cosine.
std::vector<View> viewsOf(const Sheet& sheet, Scale scale) {
  const std::size_t step = stepOf(scale);
  std::vector<View> views;
  Seeded random(~sheet.seed);
  for (std::size_t c = 0; c < std::size(COSINES); c += step) {
    const double cosine = COSINES[c];
    if (sheet.seed > 0) {
      views.push_back({cosine, random.between(-std::numbers::pi, std::numbers::pi)});
    } else if (sheet.turned) {
      for (std::size_t a = 0; a < std::size(AZIMUTHS); a += azimuthStepOf(scale))
        views.push_back({cosine, AZIMUTHS[a]});
    } else {
      views.push_back({cosine, 0});
    }
  }
  return views;
}

Material white(double roughness, double metallic = 0) {
  Material m;
  m.physical = true;
  m.roughnessFactor = static_cast<float>(roughness);
  m.metallicFactor = static_cast<float>(metallic);
  return m;
}

Material woven(double roughness, double metallic) {
  Material m = white(roughness, metallic);
  m.fabric.weave = true;
  m.fabric.warp = {0.55f, static_cast<float>(roughness), 0.8f};
  m.fabric.weft = {0.45f, static_cast<float>(1 - roughness), 0.8f};  // one smooth, one rough
  return m;
}

/// White cloths: each layer at every roughness, and mixes.
std::vector<Sheet> sheets(Scale scale) {
  std::vector<Sheet> list;
  for (std::size_t i = 0; i < std::size(ROUGHNESSES); i += stepOf(scale)) {
    const double roughness = ROUGHNESSES[i];
    list.push_back({"base", white(roughness)});
    for (const double metallic : {0.5, 1.0}) list.push_back({"metal", white(roughness, metallic)});
    Material sheen = white(0.8);
    sheen.layers.sheenColorFactor = glm::vec3(1);
    sheen.layers.sheenRoughnessFactor = static_cast<float>(roughness);
    list.push_back({"sheen", sheen});
    Material coat = white(0.7);
    coat.layers.clearcoatFactor = 1;
    coat.layers.clearcoatRoughnessFactor = static_cast<float>(roughness);
    list.push_back({"coat", coat});
    Material stretched = white(roughness);
    stretched.layers.anisotropyStrength = 0.9f;
    list.push_back({"stretched", stretched, true});
    Material rough = white(roughness);
    rough.layers.diffuseRoughnessFactor = 1;
    list.push_back({"rough diffuse", rough});
    for (const double metallic : {0.0, 1.0})
      list.push_back({metallic == 0 ? "yarns" : "metal yarns", woven(roughness, metallic), true});
  }
  for (std::uint64_t seed = 0; seed < countOf(scale, 24, MIXES); ++seed) {
    Seeded random(seed);
    list.push_back({"any mix", whiteCloth(random), true, seed + 1});
  }
  return list;
}

/// Of the surface, what shows gloss: light that falls through the gaps of a metal weave has nothing to send it back.
double covered(const Shaded<double>& shaded) {
  const double yarns = shaded.info().warp.coverage + shaded.info().weft.coverage;
  return yarns > 0 ? yarns : 1;
}

struct Range {
  std::string layer;
  double least = 1e9, most = -1e9;
  std::string leastAt, mostAt;
  std::uint64_t points = 0, full = 0, woven = 0;

  void see(double albedo, double coverage, bool yarns, const std::string& at) {
    woven += yarns;
    if (!(albedo / coverage >= least)) least = albedo / coverage, leastAt = at;
    if (!(albedo <= most)) most = albedo, mostAt = at;
    ++points;
  }
};

std::string placeOf(const Sheet& sheet, const View& view) {
  const std::string azimuth = sheet.turned ? ", azimuth " + std::to_string(view.azimuth) : "";
  return "NoV " + std::to_string(view.NoV).substr(0, 4) + azimuth + ", " + describe(sheet.material);
}

/// Least and largest albedo of the sheets of each layer.
template <class Albedo>
std::vector<Figure> extremes(const ShadingPromise& shading, Scale scale, const std::string& light, Albedo albedo) {
  struct Measured {
    std::vector<View> views;
    std::vector<double> albedos;
    double coverage;
    bool yarns;
  };
  const std::vector<Sheet> list = sheets(scale);
  std::vector<Measured> all(list.size());
  inParallel(list.size(), [&](std::uint64_t from, std::uint64_t to, unsigned) {
    for (std::uint64_t i = from; i < to; ++i) {
      all[i].views = viewsOf(list[i], scale);
      for (const auto& [NoV, azimuth] : all[i].views) {
        const SurfacePoint p = pointOn(shading.model, list[i].material, {NoV, 1, 0, azimuth});
        const Shaded<double> shaded(shading.model, inDouble(p.info));
        all[i].albedos.push_back(albedo(shaded));
        all[i].coverage = covered(shaded);
        all[i].yarns = hasYarns(p);
      }
    }
  });
  std::vector<Range> ranges;
  const auto rangeOf = [&](const std::string& layer) -> Range& {
    const auto found = std::find_if(ranges.begin(), ranges.end(), [&](const Range& r) { return r.layer == layer; });
    return found == ranges.end() ? *ranges.insert(ranges.end(), {layer}) : *found;
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = 0; j < all[i].views.size(); ++j)
      rangeOf(list[i].layer).see(all[i].albedos[j], all[i].coverage, all[i].yarns, placeOf(list[i], all[i].views[j]));
  }
  for (const Sheet& sheet : sheets(Scale::kFull)) rangeOf(sheet.layer).full += viewsOf(sheet, Scale::kFull).size();
  std::vector<Figure> out;
  for (const Range& r : ranges) {
    const double high = shading.conserves ? 1.005 : NO_BAR, low = shading.conserves ? 0.90 : -NO_BAR;
    const std::string what = light + ", " + r.layer;
    out.push_back({what + ": most", shading.name, r.most, high, -NO_BAR, r.points, r.mostAt, r.full});
    out.push_back({what + ": least", shading.name, r.least, NO_BAR, low, r.points, r.leastAt, r.full});
    if (!shading.weaves || r.layer != "yarns") continue;
    const auto views = static_cast<double>(r.points);
    out.push_back({what + ": views that show them", shading.name, static_cast<double>(r.woven), views, views, r.points,
                   "", r.full});
  }
  return out;
}

}  // namespace

std::vector<Figure> checkFurnaceDirect(const ShadingPromise& shading, Scale scale) {
  const int points = scale == Scale::kFull ? 1 << 13 : 1 << 12;
  return extremes(shading, scale, "direct light",
                  [&](const Shaded<double>& shaded) { return directAlbedo(shaded, points); });
}

std::vector<Figure> checkFurnaceEnvironment(const ShadingPromise& shading, Scale scale) {
  return extremes(shading, scale, "environment", [](const Shaded<double>& shaded) { return shaded.environment().y; });
}

}  // namespace telar::numerics
