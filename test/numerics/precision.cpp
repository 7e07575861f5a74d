#include "precision.h"

#include <algorithm>
#include <cmath>

#include "check.h"
#include "evaluate.h"

namespace telar::numerics {
namespace {

constexpr double STEPS = 4;  // of single precision
constexpr float SMOOTH = 0.2f, THIN_FUZZ = 0.07f;

double worstOf(const glm::dvec3& error, const glm::dvec3& expected) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double relative = error[c] / std::max(std::abs(expected[c]), RADIANCE_FLOOR);
    if (!(relative <= worst)) worst = relative;
  }
  return worst;
}

/// How far the radiance moves, per channel, when the parts of v, n and l move by STEPS steps of single precision.
glm::dvec3 roundingReach(ShadingModel model, const brdf_d::SurfaceInfo& info, const glm::dvec3& l) {
  constexpr double STEP = STEPS * 0x1p-23;
  const glm::dvec3 centre = Shaded<double>(model, info).direct(l);
  glm::dvec3 reach(0);
  const auto see = [&](const brdf_d::SurfaceInfo& moved, const glm::dvec3& light) {
    reach += glm::abs(Shaded<double>(model, moved).direct(light) - centre);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {-STEP, STEP}) {
      for (glm::dvec3 brdf_d::SurfaceInfo::*member :
           {&brdf_d::SurfaceInfo::v, &brdf_d::SurfaceInfo::n, &brdf_d::SurfaceInfo::coatNormal}) {
        brdf_d::SurfaceInfo moved = info;
        (moved.*member)[axis] += step;
        see(moved, l);
      }
      brdf_d::SurfaceInfo leaning = info;
      leaning.warp.n[axis] += step;
      leaning.weft.n[axis] += step;
      see(leaning, l);
      glm::dvec3 light = l;
      light[axis] += step;
      see(info, light);
    }
  }
  return reach;
}

}  // namespace

double relativeError(const glm::vec3& actual, const glm::dvec3& expected) {
  return worstOf(glm::abs(glm::dvec3(actual) - expected), expected);
}

double unexplainedError(ShadingModel model, const SurfacePoint& point, const glm::vec3& actual,
                        const glm::dvec3& expected) {
  const glm::dvec3 reach = roundingReach(model, inDouble(point.info), glm::dvec3(point.l));
  return worstOf(glm::max(glm::abs(glm::dvec3(actual) - expected) - reach, glm::dvec3(0)), expected);
}

Width widthOf(const ShadingPromise& shading, const SurfacePoint& p) {
  const bool sheen = p.info.sheenColor != glm::vec3(0);
  if (sheen && !shading.robust && p.info.sheenRoughness < THIN_FUZZ) return Width::kThinFuzz;
  const bool woven = shading.weaves && hasYarns(p);
  const auto isSmooth = [](const brdf_f::YarnLobe& yarn) {
    return yarn.coverage > 0 && std::min(yarn.alphaT, yarn.alphaB) < SMOOTH * SMOOTH;
  };
  const bool gloss = woven ? isSmooth(p.info.warp) || isSmooth(p.info.weft) : p.info.perceptualRoughness < SMOOTH;
  const bool smooth = gloss || (p.info.clearcoat > 0 && p.info.clearcoatRoughness < SMOOTH) ||
                      (sheen && p.info.sheenRoughness < SMOOTH);
  return smooth ? Width::kSmooth : Width::kRough;
}

const char* nameOf(Width width) {
  return width == Width::kThinFuzz ? "sheen roughness < 0.07"
         : width == Width::kSmooth ? "roughness < 0.2"
                                   : "roughness >= 0.2";
}

double errorBar(const ShadingPromise& shading, Width width) {
  return width == Width::kThinFuzz ? NO_BAR : width == Width::kSmooth ? shading.smoothError : shading.roughError;
}

}  // namespace telar::numerics
