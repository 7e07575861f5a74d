#include "reference/lights.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "brdf/brdf.h"
#include "frame/camera.h"

namespace telar::reference {
namespace {

glm::vec3 directionOf(const glm::dvec3& v) {
  return glm::dot(v, v) > 0 ? glm::vec3(glm::normalize(v)) : glm::vec3(0, 1, 0);
}

PunctualLight pointLight(const glm::vec3& color, const glm::dvec3& position, double range) {
  PunctualLight light;
  light.color = color;
  light.position = glm::vec3(position);
  light.range = static_cast<float>(range);
  return light;
}

PunctualLight spotLight(const glm::vec3& color, const glm::dvec3& position, const glm::dvec3& toLight, double range,
                        double outer, double inner) {
  PunctualLight light = pointLight(color, position, range);
  light.spot = true;
  light.direction = directionOf(toLight);
  light.outerCos = static_cast<float>(std::cos(outer));
  light.innerCos = static_cast<float>(std::cos(inner));
  return light;
}

PunctualLight directionalLight(const glm::vec3& color, const glm::dvec3& toLight) {
  PunctualLight light;
  light.color = color;
  light.directional = true;
  light.direction = directionOf(toLight);
  return light;
}

AreaLight areaLight(const Shot::Light& light, const glm::vec3& color, const glm::dvec3& position) {
  const bool disk = light.type == Shot::Light::Type::kDisk;
  const glm::dvec2 half = disk ? glm::dvec2(light.radius) : glm::dvec2(light.width, light.height) / 2.0;
  const glm::dmat3 axes = frame::lookAtAxes(light.position, light.target, {0, 1, 0});
  return {disk, glm::vec3(position), glm::vec3(axes[0] * half.x), glm::vec3(axes[1] * half.y), glm::vec3(-axes[2]),
          color};
}

/// Adds a light that may cast a shadow.
void addPunctual(Lights& lights, PunctualLight punctual, const Shot::Light& light) {
  punctual.shadow = light.castShadow ? static_cast<float>(light.shadow.intensity) : 0.0f;
  lights.punctual.push_back(punctual);
}

void addShotLight(Lights& lights, const Shot::Light& light, const glm::dvec3& centre) {
  using Type = Shot::Light::Type;
  const glm::vec3 color(glm::dvec3(light.color) * light.intensity);
  const glm::dvec3 position = light.position - centre, toLight = light.position - light.target;
  switch (light.type) {
    case Type::kAmbient:
      lights.domes.push_back({color, color});
      break;
    case Type::kHemisphere:
      lights.domes.push_back({color, glm::vec3(glm::dvec3(light.groundColor) * light.intensity)});
      break;
    case Type::kDirectional:
      addPunctual(lights, directionalLight(color, toLight), light);
      break;
    case Type::kPoint:
      addPunctual(lights, pointLight(color, position, light.range), light);
      break;
    case Type::kSpot:
      addPunctual(lights,
                  spotLight(color, position, toLight, light.range, light.angle, light.angle * (1 - light.penumbra)),
                  light);
      break;
    case Type::kRect:
    case Type::kDisk:
      lights.areas.push_back(areaLight(light, color, position));
      break;
  }
}

void addModelLight(Lights& lights, const ModelLight& light, const glm::dmat4& world, const glm::dvec3& centre) {
  const glm::vec3 color(glm::dvec3(light.color) * static_cast<double>(light.intensity));
  const glm::dvec3 position = glm::dvec3(world[3]) - centre, toLight = towardsLight(light, world);
  if (!shines(light, world)) return;
  switch (light.type) {
    case LightType::kDirectional:
      lights.punctual.push_back(directionalLight(color, toLight));
      break;
    case LightType::kPoint:
      lights.punctual.push_back(pointLight(color, position, light.range));
      break;
    case LightType::kSpot:
      lights.punctual.push_back(
          spotLight(color, position, toLight, light.range, light.outerConeAngle, light.innerConeAngle));
      break;
  }
}

}  // namespace

std::optional<LightSample> PunctualLight::sampleLi(const glm::vec3& point) const {
  if (directional) return LightSample{direction, color, std::numeric_limits<float>::infinity()};
  const glm::vec3 toLight = position - point;
  const float distance = glm::length(toLight);
  if (distance == 0) return std::nullopt;
  const glm::vec3 l = toLight / distance;
  const float cone = spot ? brdf_f::spotAttenuation(outerCos, innerCos, glm::dot(l, direction)) : 1.0f;
  if (cone <= 0) return std::nullopt;
  return LightSample{l, color * cone * brdf_f::distanceAttenuation(distance, range), distance};
}

std::optional<LightSample> AreaLight::sampleLi(const glm::vec3& point, const glm::vec2& u) const {
  const float r = std::sqrt(u.x), phi = 2 * std::numbers::pi_v<float> * u.y;
  const glm::vec2 place = disk ? r * glm::vec2(std::cos(phi), std::sin(phi)) : 2.0f * u - 1.0f;
  const glm::vec3 toLight = centre + halfWidth * place.x + halfHeight * place.y - point;
  const float distance2 = glm::dot(toLight, toLight);
  if (distance2 == 0) return std::nullopt;
  const float distance = std::sqrt(distance2);
  const glm::vec3 l = toLight / distance;
  const float facing = -glm::dot(normal, l);
  if (facing <= 0) return std::nullopt;
  const float area = (disk ? std::numbers::pi_v<float> : 4.0f) * glm::length(halfWidth) * glm::length(halfHeight);
  return LightSample{l, radiance * (facing * area / distance2), distance * (1 - 1e-4f)};
}

glm::vec3 Lights::irradiance(const glm::vec3& normal) const {
  glm::vec3 sum(0);
  for (const Dome& dome : domes) sum += brdf_f::hemisphereIrradiance(dome.sky, dome.ground, normal.y);
  return sum;
}

Lights lightsOf(const Scene& scene, const Shot& shot, const glm::dvec3& centre, const Limits& limits) {
  std::size_t count = shot.lights.size();
  for (const Node& node : scene.nodes) count += shot.modelLights && node.light >= 0;
  checkLimit("L_LIGHTS", static_cast<double>(limits.lights), static_cast<double>(count));
  Lights lights;
  for (const Shot::Light& light : shot.lights) addShotLight(lights, light, centre);
  for (const Node& node : scene.nodes) {
    if (!shot.modelLights || node.light < 0) continue;
    addModelLight(lights, scene.lights[static_cast<std::size_t>(node.light)], node.world, centre);
  }
  return lights;
}

}  // namespace telar::reference
