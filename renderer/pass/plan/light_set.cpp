#include "pass/plan/light_set.h"

#include <cmath>
#include <cstddef>

#include "gl/program.h"

namespace telar::pass {
namespace {

// Far above white on any surface, and small enough that products in the shading stay within single precision.
constexpr double LIGHT_MAX = 1e20;

glm::vec3 bounded(const glm::dvec3& light) { return glm::vec3(glm::min(light, glm::dvec3(LIGHT_MAX))); }

glm::vec3 toView(const frame::Camera& camera, const glm::dvec3& point) {
  return glm::vec3(glm::dvec3(camera.view * glm::dvec4(point, 1.0)));
}

/// Unit direction in view space; +Y of the world where it is zero.
glm::vec3 directionToView(const frame::Camera& camera, glm::dvec3 direction) {
  if (glm::dot(direction, direction) == 0) direction = {0, 1, 0};
  return glm::vec3(glm::normalize(glm::dvec3(camera.view * glm::dvec4(glm::normalize(direction), 0.0))));
}

void addPoint(LightSet& set, const frame::Camera& camera, const glm::vec3& color, const glm::dvec3& position,
              double range) {
  set.pointPosition.push_back(toView(camera, position));
  set.pointColor.push_back(color);
  set.pointRange.push_back(static_cast<float>(range));
}

void addDirectional(LightSet& set, const frame::Camera& camera, const glm::vec3& color, const glm::dvec3& toLight) {
  set.directionalDirection.push_back(directionToView(camera, toLight));
  set.directionalColor.push_back(color);
}

void addSpot(LightSet& set, const frame::Camera& camera, const glm::vec3& color, const glm::dvec3& position,
             const glm::dvec3& toLight, double range, double angle, double penumbra) {
  set.spotPosition.push_back(toView(camera, position));
  set.spotDirection.push_back(directionToView(camera, toLight));
  set.spotColor.push_back(color);
  set.spotRange.push_back(static_cast<float>(range));
  set.spotOuterCos.push_back(static_cast<float>(std::cos(angle)));
  set.spotInnerCos.push_back(static_cast<float>(std::cos(angle * (1.0 - penumbra))));
}

void addRect(LightSet& set, const frame::Camera& camera, const glm::vec3& color, const Shot::Light& light) {
  const glm::dmat3 axes = glm::dmat3(camera.view) * frame::lookAtAxes(light.position, light.target, {0, 1, 0});
  set.rectPosition.push_back(toView(camera, light.position));
  set.rectHalfWidth.emplace_back(axes[0] * (light.width * 0.5));
  set.rectHalfHeight.emplace_back(axes[1] * (light.height * 0.5));
  set.rectColor.push_back(color);
}

void addDisk(LightSet& set, const frame::Camera& camera, const glm::vec3& color, const Shot::Light& light) {
  const glm::dmat3 axes = glm::dmat3(camera.view) * frame::lookAtAxes(light.position, light.target, {0, 1, 0});
  set.diskPosition.push_back(toView(camera, light.position));
  set.diskX.emplace_back(axes[0] * light.radius);
  set.diskY.emplace_back(axes[1] * light.radius);
  set.diskColor.push_back(color);
}

void addShotLight(LightSet& set, const frame::Camera& camera, const Shot::Light& light) {
  const glm::vec3 color = bounded(glm::dvec3(light.color) * light.intensity);
  const glm::vec3 ground = bounded(glm::dvec3(light.groundColor) * light.intensity);
  switch (light.type) {
    case Shot::Light::Type::kAmbient:
      set.ambient += color;
      set.hasAmbient = true;
      break;
    case Shot::Light::Type::kHemisphere:
      set.hemisphereUp.push_back(directionToView(camera, {0, 1, 0}));
      set.hemisphereSky.push_back(color);
      set.hemisphereGround.push_back(ground);
      break;
    case Shot::Light::Type::kDirectional:
      addDirectional(set, camera, color, light.position - light.target);
      break;
    case Shot::Light::Type::kPoint:
      addPoint(set, camera, color, light.position, light.range);
      break;
    case Shot::Light::Type::kSpot:
      addSpot(set, camera, color, light.position, light.position - light.target, light.range, light.angle,
              light.penumbra);
      break;
    case Shot::Light::Type::kRect:
      addRect(set, camera, color, light);
      break;
    case Shot::Light::Type::kDisk:
      addDisk(set, camera, color, light);
      break;
  }
}

void addModelLight(LightSet& set, const frame::Camera& camera, const ModelLight& light, const glm::dmat4& world) {
  const glm::vec3 color = bounded(glm::dvec3(light.color) * static_cast<double>(light.intensity));
  const glm::dvec3 position(world[3]);
  const glm::dvec3 toLight = towardsLight(light, world);
  switch (light.type) {
    case LightType::kDirectional:
      addDirectional(set, camera, color, toLight);
      break;
    case LightType::kPoint:
      addPoint(set, camera, color, position, light.range);
      break;
    case LightType::kSpot: {
      const double outer = light.outerConeAngle;
      addSpot(set, camera, color, position, toLight, light.range, outer, 1.0 - light.innerConeAngle / outer);
      break;
    }
  }
}

/// @param last elements that stay at the end
template <class T>
void padTo(std::vector<T>& list, std::size_t count, const T& value, std::size_t last = 0) {
  if (list.size() < count) {
    list.insert(list.end() - static_cast<std::ptrdiff_t>(last), count - list.size(), value);
  }
}

}  // namespace

void LightSet::describe(shader::VariantKey& key) const {
  key.ambient = hasAmbient;
  key.lights.hemisphere = static_cast<std::uint16_t>(hemisphereUp.size());
  key.lights.point = static_cast<std::uint16_t>(pointPosition.size());
  key.lights.spot = static_cast<std::uint16_t>(spotPosition.size());
  key.lights.directional = static_cast<std::uint16_t>(directionalDirection.size());
  key.lights.suns = static_cast<std::uint16_t>(suns);
  key.lights.rect = static_cast<std::uint16_t>(rectPosition.size());
  key.lights.disk = static_cast<std::uint16_t>(diskPosition.size());
}

void LightSet::pad(std::size_t count) {
  const glm::vec3 black(0), up(0, 1, 0);
  hasAmbient = true;
  padTo(hemisphereUp, count, up);
  padTo(hemisphereSky, count, black);
  padTo(hemisphereGround, count, black);
  padTo(pointPosition, count, up);
  padTo(pointColor, count, black);
  padTo(pointRange, count, 0.0f);
  padTo(spotPosition, count, up);
  padTo(spotDirection, count, up);
  padTo(spotColor, count, black);
  padTo(spotRange, count, 0.0f);
  padTo(spotOuterCos, count, 0.5f);
  padTo(spotInnerCos, count, 0.9f);
  padTo(directionalDirection, count, up, suns);
  padTo(directionalColor, count, black, suns);
  padTo(rectPosition, count, up);
  padTo(rectHalfWidth, count, glm::vec3(0.5, 0, 0));
  padTo(rectHalfHeight, count, glm::vec3(0, 0, 0.5));
  padTo(rectColor, count, black);
}

void LightSet::upload(const gl::Program& program) const {
  program.set("ambientIrradiance", ambient);
  program.set("hemisphereUp", hemisphereUp);
  program.set("hemisphereSky", hemisphereSky);
  program.set("hemisphereGround", hemisphereGround);
  program.set("pointPosition", pointPosition);
  program.set("pointColor", pointColor);
  program.set("pointRange", pointRange);
  program.set("spotPosition", spotPosition);
  program.set("spotDirection", spotDirection);
  program.set("spotColor", spotColor);
  program.set("spotRange", spotRange);
  program.set("spotOuterCos", spotOuterCos);
  program.set("spotInnerCos", spotInnerCos);
  program.set("directionalDirection", directionalDirection);
  program.set("directionalColor", directionalColor);
  program.set("rectPosition", rectPosition);
  program.set("rectHalfWidth", rectHalfWidth);
  program.set("rectHalfHeight", rectHalfHeight);
  program.set("rectColor", rectColor);
  program.set("diskPosition", diskPosition);
  program.set("diskX", diskX);
  program.set("diskY", diskY);
  program.set("diskColor", diskColor);
}

LightSet collectLights(const Scene& scene, const Shot& shot, const LightChoice& chosen, const frame::Camera& camera) {
  LightSet set;
  set.given = chosen.count();
  const std::size_t firstSun = shot.lights.size() - shot.suns;
  const auto add = [&](std::size_t i) {
    if (!chosen.ofShot[i]) return;
    if (chosen.litByShot[i]) {
      addShotLight(set, camera, shot.lights[i]);
    } else {
      ++set.leftOut;
    }
  };
  // Lights with shadows come first, as in three.js: the i-th light of a kind reads the i-th shadow.
  for (const bool casting : {true, false}) {
    for (std::size_t i = 0; i < firstSun; ++i) {
      if (shot.lights[i].castShadow == casting) add(i);
    }
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!chosen.ofNodes[i]) continue;
    if (chosen.litByNodes[i]) {
      const Node& node = scene.nodes[i];
      addModelLight(set, camera, scene.lights[static_cast<std::size_t>(node.light)], node.world);
    } else {
      ++set.leftOut;
    }
  }
  // Suns last: shaders tell them from the others by that.
  const std::size_t others = set.directionalColor.size();
  for (std::size_t i = firstSun; i < shot.lights.size(); ++i) add(i);
  set.suns = set.directionalColor.size() - others;
  return set;
}

}  // namespace telar::pass
