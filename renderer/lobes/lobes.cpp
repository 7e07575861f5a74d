#include "telar/lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lobes/gauss_legendre.h"
#include "lobes/material_surface.h"

namespace telar {
namespace {

using brdf_d::Reflected;

/// Nodes from the peak of a lobe to the horizon, and the power that gathers them at the peak.
constexpr int RINGS = 128;
constexpr int RING_POWER = 4;
/// Nodes around the normal: a grazing view bends the horizon sharply within 1 / NoV of them.
constexpr int SECTORS_MIN = 256, SECTORS_MAX = 4096;
constexpr double SECTORS_BY_COSINE = 24;

Reflected nothing() { return brdf_d::nothingReflected(); }

}  // namespace

struct ShadedMaterial::State {
  brdf_d::ShadingFunctions functions;
  brdf_d::SurfaceInfo surface;

  Reflected lit(Reflected sum, const glm::dvec3& l, double irradiance) const {
    return functions.addPunctual(sum, surface, l, glm::dvec3(irradiance));
  }

  /// Each lobe as it leaves: composed alone, since composing is linear in the lobes.
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
  state_ = std::make_shared<State>(State{functions, functions.preparedSurface(lobes::surfaceOf(shown, shot, v))});
}

LobeRadiance ShadedMaterial::radiance(const glm::dvec3& l) const {
  return state_->composed(state_->lit(nothing(), l, 1));
}

// Over the half vector h = (sin t cos p, sin t sin p, cos t), around which specular lobes are peaked: dl = 4 VoH dh,
// and NoL = cos(2 t - d) times a constant with tan d = tan(view angle) cos p, so that the horizon lies at t = pi / 4 +
// d / 2.
LobeRadiance ShadedMaterial::albedo(const CancelToken& cancel) const {
  constexpr double PI = std::numbers::pi;
  const glm::dvec3 v = state_->surface.v;
  const int sectors =
      static_cast<int>(std::clamp(SECTORS_BY_COSINE / std::max(v.z, 1e-9), double{SECTORS_MIN}, double{SECTORS_MAX}));
  const std::vector<lobes::Node> rings = lobes::gaussLegendre(RINGS);
  Reflected sum = nothing();
  for (int i = 0; i < sectors; ++i) {
    if (i % 64 == 0) cancel.check();
    const double p = 2 * PI * (i + 0.5) / sectors;
    const double horizon = PI / 4 + std::atan2(v.x * std::cos(p), v.z) / 2;
    for (const auto& [u, weight] : rings) {
      const double t = horizon * std::pow(u, RING_POWER);
      const double dt = horizon * RING_POWER * std::pow(u, RING_POWER - 1) * weight;
      const glm::dvec3 h(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
      const double VoH = glm::dot(v, h);
      sum = state_->lit(sum, 2 * VoH * h - v, 4 * VoH * std::sin(t) * dt * 2 * PI / sectors);
    }
  }
  return state_->composed(sum);
}

}  // namespace telar
