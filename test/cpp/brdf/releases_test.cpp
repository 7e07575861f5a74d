#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "brdf/quadrature.h"
#include "brdf/release_factors.h"
#include "brdf/shading.h"

/// Surfaces as releases of three.js shade them: every term of every slot against its formula in js/docs/families.md,
/// written out here once more. Each term of another family in its place is a fault that the same line has to catch.
namespace telar::test::releases_test {
namespace {

using namespace brdf_d;
using Three = ThreeTerms;

const ShadingFunctions& shading() {
  static const ShadingFunctions functions = shadingFunctions(ShadingModel::kThree);
  return functions;
}

/// A material on which every slot shows, seen and lit at one angle each.
struct Point {
  MaterialInputs m{};
  double NoV = 0.6, NoL = 0.35;
  Normals normals{};
  vec3 v, l;
  SurfaceInfo s;

  /// @param change  of the material, before it is shaded
  explicit Point(const Three& three, const std::function<void(Point&)>& change = {}) {
    m.three = three;
    m.baseColor = vec3(0.8, 0.5, 0.2);
    m.metallic = 0.3;
    m.roughness = 0.6;
    m.ior = 1.5;
    m.specular = 0.7;
    m.specularColor = vec3(1, 0.9, 0.8);
    m.anisotropyTexel = vec3(1, 0.5, 1);
    m.iridescenceIor = 1.3;
    m.iridescenceThickness = 400;
    if (change) change(*this);
    normals.geometric = normals.shading = normals.coat = vec3(0, 0, 1);
    normals.frame = mat3(1);
    v = direction(NoV, 0);
    l = direction(NoL, 2.5);
    s = withLayers(withSpecular(baseSurface(withShadedRoughness(m, 0.01), normals, v), m), m, normals);
    s.dfg = brdf_d::splitSum(three, s.perceptualRoughness, s.NoV);
    s = shading().preparedSurface(s);
  }
  Reflected lit() const { return shading().addPunctual(nothingReflected(), s, l, vec3(1)); }
  Reflected dome() const { return shading().addDome(nothingReflected(), s, vec3(1)); }
  Reflected around() const {
    Incident incident{};
    incident.environmentIrradiance = vec3(PI * 0.5);
    incident.radiance = vec3(0.8);
    return shading().addEnvironment(nothingReflected(), s, incident);
  }
};

void withSheenOn(Point& p) {
  p.m.sheenColor = vec3(0.9, 0.4, 0.2);
  p.m.sheenRoughness = 0.5;
}
void withFilmOn(Point& p) { p.m.iridescence = 0.8; }
void stretched(Point& p) { p.m.anisotropyVector = vec2(0.48, 0.36); }

// The formulas.
double weight(double c) { return std::exp2((-5.55473 * c - 6.98316) * c); }
vec3 average(const vec3& f0) { return f0 + (1.0 - f0) / 21.0; }
double exponentialSheen(double r, double c) {
  const double a = -1.9362 + 1.0678 * r + 0.4573 * r * r - 0.8469 / (r + 0.1);
  const double b = -0.6014 + 0.5538 * r - 0.4670 * r * r - 0.1255 / (r + 0.1);
  return std::min(std::exp(a * c + b), 1.0);
}
double rangedSheen(double r, double c) {
  const double x =
      r < 0.25 ? std::exp((-339.2 * r * r + 161.4 * r - 25.9) * c + 44 * r * r - 23.7 * r + 3.26)
               : std::exp((-8.48 * r * r + 14.3 * r - 9.95) * c + 1.97 * r * r - 3.27 * r + 0.72) + 0.1 * (r - 0.25);
  return std::min(x / PI, 1.0);
}
/// What an interface sends back: single f / (1 - m f) m beside single.
std::pair<vec3, vec3> bounces(const vec3& f0, double f90, const vec2& dfg) {
  const vec3 single = f0 * dfg.x + vec3(f90 * dfg.y), f = average(f0);
  const double m = 1 - dfg.x - dfg.y;
  return {single, single * f / (1.0 - m * f) * m};
}

struct Row {
  const char* name;
  int Three::*slot;
  int terms;  ///< of the slot
  int term;
  std::function<std::vector<vec3>(const Three&)> actual, expected;
  double tolerance = 1e-6;  ///< relative: what the constant 0.047619 for 1/21 is off
};

/// The GGX lobe of one bounce, times N.L.
vec3 oneBounce(const Point& p) {
  const vec3 h = normalize(p.l + p.v);
  const double VoH = dot(p.v, h), a2 = std::pow(p.s.perceptualRoughness, 4), NoH = h.z;
  const double D = a2 / (PI * std::pow(NoH * NoH * (a2 - 1) + 1, 2));
  const double V =
      0.5 / (p.NoL * std::sqrt(a2 + (1 - a2) * p.NoV * p.NoV) + p.NoV * std::sqrt(a2 + (1 - a2) * p.NoL * p.NoL));
  const vec3 F = p.s.f0 * (1 - weight(VoH)) + vec3(p.s.f90 * weight(VoH));
  return F * (D * V * p.NoL);
}

vec3 addedBounces(const Point& p, bool squared) {
  const vec2 toLight = brdf_d::splitSum(p.m.three, p.s.perceptualRoughness, p.NoL), toViewer = p.s.dfg;
  const vec3 f = average(p.s.f0), passes = squared ? f * f : f;
  const double mm = (1 - toLight.x - toLight.y) * (1 - toViewer.x - toViewer.y);
  const auto s = [&](const vec2& dfg) { return p.s.f0 * dfg.x + vec3(p.s.f90 * dfg.y); };
  return s(toViewer) * s(toLight) * f / (1.0 - mm * passes + 1e-6) * (mm * p.NoL);
}

std::vector<Row> directRows() {
  const auto specular = [](const Three& t) { return std::vector{Point(t).lit().specular}; };
  const auto diffuse = [](const Three& t) { return std::vector{Point(t).lit().diffuse}; };
  const auto lambert = [](const Point& p) { return p.m.baseColor * (0.7 / PI * p.NoL); };
  return {
      {"turquin", &Three::directMultiscatter, 4, Three::THREE_DIRECT_MULTISCATTER_TURQUIN, specular,
       [](const Three& t) {
         const Point p(t);
         return std::vector{oneBounce(p) * (1.0 + p.s.f0 * (1 / (p.s.dfg.x + p.s.dfg.y) - 1))};
       }},
      {"added lobe", &Three::directMultiscatter, 4, Three::THREE_DIRECT_MULTISCATTER_ADDED_LOBE, specular,
       [](const Three& t) { return std::vector{oneBounce(Point(t)) + addedBounces(Point(t), false)}; }, 1e-7},
      {"added lobe, squared", &Three::directMultiscatter, 4, Three::THREE_DIRECT_MULTISCATTER_ADDED_LOBE_SQUARED,
       specular, [](const Three& t) { return std::vector{oneBounce(Point(t)) + addedBounces(Point(t), true)}; }, 1e-7},
      {"one bounce", &Three::directMultiscatter, 4, Three::THREE_DIRECT_MULTISCATTER_NONE, specular,
       [](const Three& t) { return std::vector{oneBounce(Point(t))}; }},
      {"diffuse under Fresnel", &Three::directDiffuse, 2, Three::THREE_DIRECT_DIFFUSE_UNDER_FRESNEL, diffuse,
       [=](const Three& t) {
         const Point p(t);
         const double w = weight(dot(p.v, normalize(p.l + p.v)));
         const vec3 f0 = 0.04 * vec3(1, 0.9, 0.8) * 0.7;
         return std::vector{lambert(p) * (1.0 - (f0 * (1 - w) + vec3((0.7 * 0.7 + 0.3) * w)))};
       }},
      {"diffuse", &Three::directDiffuse, 2, Three::THREE_DIRECT_DIFFUSE_LAMBERT, diffuse,
       [=](const Three& t) { return std::vector{lambert(Point(t))}; }},
  };
}

std::vector<Row> indirectRows() {
  const auto dome = [](const Three& t) { return std::vector{Point(t).dome().diffuse}; };
  const auto around = [](const Three& t) { return std::vector{Point(t).around().specular, Point(t).around().diffuse}; };
  const auto dielectric = [](const Point& p) { return bounces(0.04 * vec3(1, 0.9, 0.8) * 0.7, p.s.f90, p.s.dfg); };
  return {
      {"ambient under the interface", &Three::ambientDiffuse, 2, Three::THREE_AMBIENT_DIFFUSE_UNDER_INTERFACE, dome,
       [=](const Three& t) {
         const Point p(t);
         const auto [single, multiple] = dielectric(p);
         return std::vector{p.m.baseColor * (0.7 / PI) * (1.0 - single - multiple)};
       }},
      {"ambient", &Three::ambientDiffuse, 2, Three::THREE_AMBIENT_DIFFUSE_LAMBERT, dome,
       [](const Three& t) { return std::vector{Point(t).m.baseColor * (0.7 / PI)}; }},
      {"two interfaces", &Three::environmentMetal, 2, Three::THREE_ENVIRONMENT_METAL_TWO_INTERFACES, around,
       [=](const Three& t) {
         const Point p(t);
         const auto [single, multiple] = dielectric(p);
         const auto [bright, again] = bounces(p.m.baseColor, p.s.f90, p.s.dfg);
         return std::vector{0.8 * (0.7 * single + 0.3 * bright) + 0.5 * (0.7 * multiple + 0.3 * again),
                            p.m.baseColor * (0.7 * 0.5) * (1.0 - single - multiple)};
       }},
      {"one interface", &Three::environmentMetal, 2, Three::THREE_ENVIRONMENT_METAL_ONE_INTERFACE, around,
       [](const Three& t) {
         const Point p(t);
         const auto [single, multiple] = bounces(p.s.f0, p.s.f90, p.s.dfg);
         return std::vector{0.8 * single + 0.5 * multiple, p.m.baseColor * (0.7 * 0.5 * (1 - max3(single + multiple)))};
       }},
  };
}

std::vector<Row> sheenRows() {
  const auto around = [](const Three& t) { return std::vector{Point(t, withSheenOn).around().sheen}; };
  const auto dome = [](const Three& t) { return std::vector{Point(t, withSheenOn).dome().sheen}; };
  // What the sheen leaves of the base: under a lamp, a dome, the environment, and of what it emits.
  const auto base = [](const Three& t) {
    const Point p(t, withSheenOn), bare(t);
    const Reflected none = nothingReflected();
    const auto shown = [&](const Point& from, Reflected direct, Reflected indirect, const vec3& emitted) {
      direct.sheen = indirect.sheen = vec3(0);
      return shading().composedRadiance(from.s, direct.diffuse + indirect.diffuse, direct, indirect, emitted);
    };
    return std::vector{shown(p, p.lit(), none, vec3(0)) / shown(bare, bare.lit(), none, vec3(0)),
                       shown(p, none, p.dome(), vec3(0)) / shown(bare, none, bare.dome(), vec3(0)),
                       shown(p, none, p.around(), vec3(0)) / shown(bare, none, bare.around(), vec3(0)),
                       shown(p, none, none, vec3(1))};
  };
  const vec3 color(0.9, 0.4, 0.2);
  return {
      {"exponential sheen", &Three::sheenAlbedo, 2, Three::THREE_SHEEN_ALBEDO_EXPONENTIAL, around,
       [=](const Three&) { return std::vector{color * (0.5 * exponentialSheen(0.5, 0.6))}; }},
      {"sheen in ranges", &Three::sheenAlbedo, 2, Three::THREE_SHEEN_ALBEDO_TWO_RANGES, around,
       [=](const Three&) { return std::vector{color * (0.5 * PI * rangedSheen(0.5, 0.6))}; }},
      {"sheen under ambient light", &Three::ambientSheen, 2, Three::THREE_AMBIENT_SHEEN_ALBEDO, dome,
       [=](const Three&) { return std::vector{color * (exponentialSheen(0.5, 0.6) / PI)}; }},
      {"no sheen under ambient light", &Three::ambientSheen, 2, Three::THREE_AMBIENT_SHEEN_NONE, dome,
       [](const Three&) { return std::vector{vec3(0)}; }},
      {"sheen by albedo", &Three::sheenEnergy, 2, Three::THREE_SHEEN_ENERGY_ALBEDO, base,
       [](const Three&) {
         const double seen = 1 - 0.9 * exponentialSheen(0.5, 0.6), lamp = 1 - 0.9 * exponentialSheen(0.5, 0.35);
         return std::vector{vec3(std::min(seen, lamp)), vec3(seen), vec3(seen), vec3(1)};
       }},
      {"sheen by colour", &Three::sheenEnergy, 2, Three::THREE_SHEEN_ENERGY_CONSTANT, base,
       [](const Three&) { return std::vector<vec3>(4, vec3(1 - 0.157 * 0.9)); }},
  };
}

std::vector<Row> layerRows() {
  const auto film = [](const Three& t) { return std::vector{Point(t, withFilmOn).s.filmFresnel}; };
  const auto filmF0 = [](const Three& t) {
    return std::vector{Point(t, withFilmOn).s.filmF0Dielectric, Point(t, withFilmOn).s.filmF0Metal};
  };
  const auto over = [](const vec3& f0) { return F_Iridescence(1.3, 400, 0.6, f0); };
  const auto axes = [](const Three& t) { return std::vector{Point(t, stretched).s.t, Point(t, stretched).s.b}; };
  const auto grazing = [](Point& p) {
    stretched(p);
    p.m.roughness = 0.3;
    p.NoV = p.NoL = 1e-7;  // where the floors differ
  };
  const auto gloss = [=](const Three& t) { return std::vector{Point(t, grazing).lit().specular}; };
  const auto glossBy = [=](const std::function<double(double)>& visibility) {
    return [=](const Three& t) {
      const Point p(t, grazing);
      const vec3 h = normalize(p.l + p.v);
      const double aT = p.s.alphaT, aB = p.s.alpha;
      const auto length = [&](const vec3& d) { return std::hypot(aT * dot(p.s.t, d), aB * dot(p.s.b, d), d.z); };
      const double a2 = aT * aB, ToH = dot(p.s.t, h), BoH = dot(p.s.b, h);
      const double D = a2 / PI * std::pow(a2 / (aB * aB * ToH * ToH + aT * aT * BoH * BoH + a2 * a2 * h.z * h.z), 2);
      const double w = weight(dot(p.v, h));
      const vec3 F = p.s.f0 * (1 - w) + vec3(p.s.f90 * w);
      const double V = visibility(p.NoL * length(p.v) + p.NoV * length(p.l));
      return std::vector{F * (D * V * p.NoL) * p.s.compensation};
    };
  };
  return {
      {"two films", &Three::filmMetal, 2, Three::THREE_FILM_METAL_TWO_FILMS, film,
       [=](const Three& t) {
         const Point p(t, withFilmOn);
         return std::vector{0.7 * over(p.s.f0Dielectric) + 0.3 * over(p.m.baseColor)};
       }},
      {"one film", &Three::filmMetal, 2, Three::THREE_FILM_METAL_ONE_FILM, film,
       [=](const Three& t) { return std::vector{over(Point(t, withFilmOn).s.f0)}; }},
      {"film as F0", &Three::filmEnvironment, 2, Three::THREE_FILM_ENVIRONMENT_SCHLICK_F0, filmF0,
       [=](const Three& t) {
         const Point p(t, withFilmOn);
         const double x = std::pow(0.4, 5);
         return std::vector{(over(p.s.f0Dielectric) - x) / (1 - x), (over(p.m.baseColor) - x) / (1 - x)};
       }},
      {"film as it reflects", &Three::filmEnvironment, 2, Three::THREE_FILM_ENVIRONMENT_REFLECTANCE, filmF0,
       [=](const Three& t) {
         const Point p(t, withFilmOn);
         return std::vector{over(p.s.f0Dielectric), over(p.m.baseColor)};
       }},
      {"stretched", &Three::anisotropyDirection, 3, Three::THREE_ANISOTROPY_DIRECTION_VECTOR, axes,
       [](const Three&) {
         return std::vector{vec3(0.8, 0.6, 0), vec3(-0.6, 0.8, 0)};
       }},
      {"turned back", &Three::anisotropyDirection, 3, Three::THREE_ANISOTROPY_DIRECTION_TURNED_BACK, axes,
       [](const Three&) {
         return std::vector{vec3(0.8, -0.6, 0), vec3(0.6, 0.8, 0)};
       }},
      {"not stretched", &Three::anisotropyDirection, 3, Three::THREE_ANISOTROPY_DIRECTION_NONE,
       [](const Three& t) {
         return std::vector{vec3(Point(t, stretched).s.alphaT, Point(t, stretched).s.anisotropyStrength, 0)};
       },
       [](const Three&) { return std::vector{vec3(std::pow(0.61, 2), 0, 0)}; }},
      {"visibility with a floor", &Three::anisotropicVisibility, 3, Three::THREE_ANISOTROPIC_VISIBILITY_FLOORED, gloss,
       glossBy([](double sum) { return 0.5 / std::max(sum, 1e-6); })},
      {"visibility up to 1", &Three::anisotropicVisibility, 3, Three::THREE_ANISOTROPIC_VISIBILITY_SATURATED, gloss,
       glossBy([](double sum) { return std::min(0.5 / sum, 1.0); })},
  };
}

std::vector<Row> inputRows() {
  const auto smooth = [](const Three& t) {
    const Point p(t, [](Point& q) { q.m.roughness = q.m.clearcoatRoughness = 0.01; });
    return std::vector{vec3(p.s.perceptualRoughness, withShadedRoughness(p.m, 0.01).clearcoatRoughness, 0)};
  };
  const auto rough = [](const Three& t) {
    return std::vector{vec3(Point(t, [](Point& q) { q.m.diffuseRoughness = 0.7; }).s.diffuseRoughness)};
  };
  // Between the last texel and the border of the table it is that texel.
  const auto corner = [](const Three& t) { return std::vector{vec3(brdf_d::splitSum(t, 1, 1), 0)}; };
  const auto tabulated = [](double at) {
    return [=](const Three&) { return std::vector{vec3(test::splitSum(at * at, at), 0)}; };
  };
  const auto glass = [](const Three& t) {
    PhysicalLayers file;
    file.ior = 1000;  // the loader's word for an index of 0
    const double ior = iorOf(file, t);
    return std::vector{vec3(std::pow((ior - 1) / (ior + 1), 2))};
  };
  return {
      {"roughness from 0.045 on", &Three::roughnessMin, 2, Three::THREE_ROUGHNESS_MIN_0_045, smooth,
       [](const Three&) { return std::vector{vec3(0.055, 0.055, 0)}; }},
      {"roughness from 0.0525 on", &Three::roughnessMin, 2, Three::THREE_ROUGHNESS_MIN_0_0525, smooth,
       [](const Three&) { return std::vector{vec3(0.0625, 0.0625, 0)}; }},
      {"rough diffuse", &Three::diffuseRoughness, 2, Three::THREE_DIFFUSE_ROUGHNESS_EON, rough,
       [](const Three&) { return std::vector{vec3(0.7)}; }},
      {"no rough diffuse", &Three::diffuseRoughness, 2, Three::THREE_DIFFUSE_ROUGHNESS_NONE, rough,
       [](const Three&) { return std::vector{vec3(0)}; }},
      {"table of 16", &Three::dfg, 3, Three::THREE_DFG_TABLE_16, corner, tabulated(1 - 0.5 / 16), 2e-3},
      {"table of 32", &Three::dfg, 3, Three::THREE_DFG_TABLE_32, corner, tabulated(1 - 0.5 / 32), 2e-3},
      {"fit", &Three::dfg, 3, Three::THREE_DFG_KARIS, corner,
       [](const Three&) {
         const double k = 0 * std::min(0.0, std::exp2(-9.28)) + 0.0425 - 0.0275;
         return std::vector{vec3(-1.04 * k + 1.04 - 0.572, 1.04 * k + 0.022 - 0.04, 0)};
       }},
      {"an index of 1000", &Three::ior0, 2, Three::THREE_IOR0_INFINITE, glass,
       [](const Three&) { return std::vector{vec3(std::pow(999.0 / 1001, 2))}; }},
      {"an index of 0", &Three::ior0, 2, Three::THREE_IOR0_ZERO, glass,
       [](const Three&) { return std::vector{vec3(1)}; }},
  };
}

/// Largest difference of a channel, relative to the largest number of either.
double apart(const std::vector<vec3>& actual, const std::vector<vec3>& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double scale = std::max({max3(abs(actual[i])), max3(abs(expected[i])), 1e-12});
    worst = std::max(worst, max3(abs(actual[i] - expected[i])) / scale);
  }
  return worst;
}

/// Two tables of one integral are 5 % apart where they clamp; the two added lobes, which differ least, 4e-6.
constexpr double CAUGHT = 2;

TEST(Releases, EveryTermIsItsFormulaAndEveryOtherTermIsCaught) {
  for (const auto& rows : {directRows(), indirectRows(), sheenRows(), layerRows(), inputRows()}) {
    for (const Row& row : rows) {
      for (int term = 0; term < row.terms; ++term) {
        Three three;
        three.*row.slot = term;
        Three right;
        right.*row.slot = row.term;
        const double error = apart(row.actual(three), row.expected(right));
        if (term == row.term)
          EXPECT_LE(error, row.tolerance) << row.name;
        else
          EXPECT_GT(error, CAUGHT * row.tolerance) << row.name << " does not catch term " << term;
      }
    }
  }
}

TEST(Releases, TheFloorsOfAnisotropicVisibilityDifferWhereNothingElseDoes) {
  // gv + gl = 2e-8: below the floor of the newest term.
  EXPECT_NEAR(smithSumAnisotropic(0.1, 0.1, 1e-7, 1e-7, 1, 0, 1, 0), 2e-8, 1e-15);
  EXPECT_NEAR(V_SmithGGXCorrelatedAnisotropic(0.1, 0.1, 1e-7, 1e-7, 1, 0, 1, 0), 0.5 / 1e-6, 1);
  // Where both are 0 the release divides by 0, and the oracle has no light.
  Three three;
  three.anisotropicVisibility = Three::THREE_ANISOTROPIC_VISIBILITY_UNBOUNDED;
  EXPECT_EQ(Point(three, [](Point& p) { stretched(p), p.NoV = p.NoL = 0; }).lit().specular, vec3(0));
}

TEST(Releases, SheenRoughnessIsHeldBeforeTheTexture) {
  PhysicalLayers file;
  file.sheenRoughnessFactor = 0.02f;
  Three three;
  EXPECT_EQ(sheenRoughnessOf(file, three), 0.02f);
  three.sheenAlbedo = Three::THREE_SHEEN_ALBEDO_TWO_RANGES;
  EXPECT_EQ(sheenRoughnessOf(file, three), 0.07f);
  file.sheenRoughnessFactor = 0.3f;
  EXPECT_EQ(sheenRoughnessOf(file, three), 0.3f);
}

/// Light of radiance 1 from everywhere comes back whole from white, by both of the ways to mix a metal and by every
/// table.
TEST(Releases, WhiteFurnace) {
  for (const int interfaces : {0, 1}) {
    for (const int dfg : {0, 1, 2}) {
      for (const double metallic : {0.0, 1.0}) {
        Three three;
        three.environmentMetal = interfaces;
        three.dfg = dfg;
        const Point p(three, [&](Point& q) {
          q.m.baseColor = q.m.specularColor = vec3(1);
          q.m.metallic = metallic;
          q.m.specular = 1;
        });
        Incident incident{};
        incident.environmentIrradiance = vec3(PI);
        incident.radiance = vec3(1);
        const Reflected out = shading().addEnvironment(nothingReflected(), p.s, incident);
        EXPECT_NEAR(out.specular.x + out.diffuse.x, 1, 1e-6) << interfaces << " " << dfg << " " << metallic;
      }
    }
  }
}

}  // namespace
}  // namespace telar::test::releases_test
