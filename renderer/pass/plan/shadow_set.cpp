#include "pass/plan/shadow_set.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "pass/plan/world_origin.h"
#include "telar/error.h"

namespace telar::pass {
namespace {

using Light = Shot::Light;

/// Clip space to texture coordinates.
glm::dmat4 clipToMap() {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
}

frame::Camera flatView(const Light& light) {
  const Light::Shadow& s = light.shadow;
  frame::Camera camera;
  camera.view = frame::lookAtView(light.position, light.target, glm::dvec3(0, 1, 0));
  camera.orthographic = light.type == Light::Type::kDirectional;
  camera.projection = camera.orthographic ? glm::ortho(s.left, s.right, s.bottom, s.top, s.near, s.far)
                                          : glm::perspective(2.0 * light.angle * s.focus, 1.0, s.near, s.far);
  return camera;
}

/// Faces in GL's order, each as GL lays its texels out; those of an atlas stand upright.
std::vector<frame::Camera> cubeViews(const Light& light, bool atlas) {
  struct Face {
    glm::dvec3 direction, up;
  };
  const std::array faces{Face{{1, 0, 0}, {0, -1, 0}},  Face{{-1, 0, 0}, {0, -1, 0}}, Face{{0, 1, 0}, {0, 0, 1}},
                         Face{{0, -1, 0}, {0, 0, -1}}, Face{{0, 0, 1}, {0, -1, 0}},  Face{{0, 0, -1}, {0, -1, 0}}};
  std::vector<frame::Camera> views;
  for (const Face& face : faces) {
    frame::Camera camera;
    const glm::dvec3 up = atlas && face.direction.y == 0 ? -face.up : face.up;
    camera.view = frame::lookAtView(light.position, light.position + face.direction, up);
    camera.projection = glm::perspective(glm::radians(90.0), 1.0, light.shadow.near, light.shadow.far);
    views.push_back(camera);
  }
  return views;
}

/// The same view with another origin of the world: a directional light may be far from the model.
frame::Camera movedTo(frame::Camera camera, const glm::dvec3& point) {
  const glm::dvec3 seen(camera.view * glm::dvec4(point, 1.0));
  camera.view = glm::translate(glm::dmat4(1.0), -seen) * camera.view;
  camera.projection = glm::translate(camera.projection, seen);
  return camera;
}

/// Of its shadow map.
double texelsOf(const Light& light) {
  const double size = light.shadow.mapSize;
  return size * size * (light.type == Light::Type::kPoint ? 6 : 1);
}

/// The most texels of all maps that a quality makes finer: 64 MiB.
constexpr double FINE_TEXELS = 4096.0 * 4096.0;

/// How many times the texels on a side maps have whose shadows fall on surfaces, as far as together they stay small.
/// @param texels  of these maps
int scaleOf(const Shot& shot, double texels, const Limits& limits) {
  int scale = shot.shading == ShadingModel::kFabric ? shot.shadowScale : 1;
  const double most = std::min(FINE_TEXELS, static_cast<double>(limits.shadowTexels));
  while (scale > 1 && scale * scale * texels > most) scale /= 2;
  return scale;
}

/// Biases are those of a texel.
Light finer(Light light, int scale) {
  light.shadow.mapSize *= scale;
  light.shadow.bias /= scale;
  light.shadow.normalBias /= scale;
  return light;
}

ShadowMap mapOf(const Light& light, bool lit, const ThreeTerms& three, const Bounds& bounds) {
  const glm::dvec3 origin = worldOrigin(bounds);
  const bool packed = three.shadowFilter == ThreeTerms::THREE_SHADOW_FILTER_PACKED_GRID;
  ShadowMap map{light.type, light.shadow, {}, glm::dmat4(1.0), lit, packed};
  if (three.shadowIntensity == ThreeTerms::THREE_SHADOW_INTENSITY_WHOLE) map.settings.intensity = 1;
  if (light.type == Light::Type::kPoint) {
    map.views = cubeViews(light, packed);
    map.matrix = toOrigin(glm::translate(glm::dmat4(1.0), -light.position), origin);
  } else {
    map.views = {flatView(light)};
    map.matrix = toOrigin(clipToMap() * (map.views[0].projection * map.views[0].view), origin);
    if (map.views[0].orthographic && isFarFrom(bounds, light.position))
      map.views[0] = movedTo(map.views[0], bounds.middle());
  }
  return map;
}

}  // namespace

const char* nameOf(Light::Type type) {
  return type == Light::Type::kPoint ? "point" : type == Light::Type::kSpot ? "spot" : "directional";
}

void ShadowSet::describe(shader::VariantKey& key) const {
  for (const ShadowMap& map : flat) {
    if (map.lit) ++(map.type == Light::Type::kSpot ? key.lights.spotShadows : key.lights.directionalShadows);
  }
  for (const ShadowMap& map : cube)
    key.lights.pointShadows = static_cast<std::uint16_t>(key.lights.pointShadows + map.lit);
}

ShadowSet collectShadows(const Shot& shot, const LightChoice& chosen, const Limits& limits, const Bounds& bounds) {
  double texels = 0, litTexels = 0;
  const auto casts = [&](std::size_t i) { return chosen.ofShot[i] && shot.lights[i].castShadow; };
  for (std::size_t i = 0; i < shot.lights.size(); ++i) {
    if (!casts(i)) continue;
    texels += texelsOf(shot.lights[i]);
    if (chosen.litByShot[i]) litTexels += texelsOf(shot.lights[i]);
  }
  checkLimit("L_SHADOW_TEXELS", static_cast<double>(limits.shadowTexels), texels);
  const int scale = scaleOf(shot, litTexels, limits);
  ShadowSet set;
  for (std::size_t i = 0; i < shot.lights.size(); ++i) {
    if (!casts(i)) continue;
    const Light& light = shot.lights[i];
    ++set.casting;
    const bool lit = chosen.litByShot[i];
    if (!lit && !shot.ground) {
      ++set.leftOut;
      set.leftOutTexels += static_cast<std::uint64_t>(texelsOf(light));
      continue;
    }
    (light.type == Light::Type::kPoint ? set.cube : set.flat)
        .push_back(mapOf(lit ? finer(light, scale) : light, lit, shot.three, bounds));
  }
  const auto order = [](const ShadowMap& a, const ShadowMap& b) {
    const auto rank = [](const ShadowMap& m) { return std::pair(!m.lit, m.type != Light::Type::kSpot); };
    return rank(a) < rank(b);
  };
  std::stable_sort(set.flat.begin(), set.flat.end(), order);
  std::stable_sort(set.cube.begin(), set.cube.end(), order);
  return set;
}

}  // namespace telar::pass
