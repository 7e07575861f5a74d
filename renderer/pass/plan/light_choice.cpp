#include "pass/plan/light_choice.h"

#include <algorithm>
#include <cmath>

#include "brdf/brdf.h"
#include "frame/light_reach.h"
#include "telar/error.h"
#include "telar/luminance.h"

namespace telar::pass {
namespace {

using Light = Shot::Light;

/// A sphere about what is drawn, metres.
struct Middle {
  glm::dvec3 point{0};
  double radius = 0;

  explicit Middle(const Bounds& bounds) {
    if (bounds.empty()) return;
    point = bounds.middle();
    radius = bounds.diagonal() * 0.5;
  }
  /// To a light, which may be inside.
  double distance(const glm::dvec3& light) const { return std::max(glm::length(light - point), radius); }
};

/// A point, or a cone of light.
struct Punctual {
  glm::dvec3 position, toLight;
  double range = 0, outer = glm::pi<double>(), inner = glm::pi<double>();  ///< half angles, radians
};

/// Part of the intensity that the middle has, 1/m^2. A cone that meets the sphere counts by where it is nearest to its
/// axis.
double attenuation(const Middle& middle, const Punctual& light) {
  const double distance = middle.distance(light.position);
  double cone = 1;
  if (light.outer < glm::pi<double>()) {
    const glm::dvec3 toMiddle = middle.point - light.position;
    const double lengths = glm::length(toMiddle) * glm::length(light.toLight);
    const double cosine = lengths > 0 ? -glm::dot(toMiddle, light.toLight) / lengths : 1;
    const double off = std::acos(std::clamp(cosine, -1.0, 1.0)) - std::asin(std::min(middle.radius / distance, 1.0));
    cone = brdf_d::spotAttenuation(std::cos(light.outer), std::cos(light.inner), std::cos(std::max(off, 0.0)));
  }
  return cone * brdf_d::distanceAttenuation(distance, light.range);
}

/// Irradiance of an area light that is turned to the middle, by its area and the cosine at it.
double areaFactor(const Middle& middle, const Light& light, double area) {
  const glm::dvec3 toMiddle = middle.point - light.position, normal = light.target - light.position;
  const double lengths = glm::length(toMiddle) * glm::length(normal);
  const double cosine = lengths > 0 ? std::max(glm::dot(toMiddle, normal) / lengths, 0.0) : 1;
  const double distance = std::max(middle.distance(light.position), 1e-6);
  return std::min(area * cosine / (distance * distance), glm::pi<double>());
}

double strengthOf(const Middle& middle, const Light& light) {
  const double power = luminance(glm::dvec3(light.color)) * light.intensity;
  switch (light.type) {
    case Light::Type::kPoint:
      return power * attenuation(middle, {light.position, {}, light.range});
    case Light::Type::kSpot:
      return power * attenuation(middle, {light.position, light.position - light.target, light.range, light.angle,
                                          light.angle * (1 - light.penumbra)});
    case Light::Type::kRect:
      return power * areaFactor(middle, light, light.width * light.height);
    case Light::Type::kDisk:
      return power * areaFactor(middle, light, glm::pi<double>() * light.radius * light.radius);
    default:
      return power;
  }
}

double strengthOf(const Middle& middle, const ModelLight& light, const glm::dmat4& world) {
  const double power = shines(light, world) ? luminance(glm::dvec3(light.color)) * light.intensity : 0;
  Punctual at{glm::dvec3(world[3]), towardsLight(light, world), light.range};
  if (light.type == LightType::kDirectional) return power;
  if (light.type == LightType::kSpot) at.outer = light.outerConeAngle, at.inner = light.innerConeAngle;
  return power * attenuation(middle, at);
}

/// One that costs time for each fragment that it may reach.
bool counts(const Light& light) {
  return shines(light) && light.type != Light::Type::kAmbient && light.type != Light::Type::kHemisphere;
}

/// Leaves out all but `maxLights` of those that count.
void chooseStrongest(const Scene& scene, const Shot& shot, LightChoice& chosen) {
  struct Candidate {
    double strength;
    std::vector<bool>& list;
    std::size_t index;
  };
  const Middle middle(scene.bounds);
  std::vector<Candidate> all;
  // Suns are a part of the environment, whose map has lost their light.
  for (std::size_t i = 0; i < shot.lights.size() - shot.suns; ++i) {
    if (counts(shot.lights[i])) all.push_back({strengthOf(middle, shot.lights[i]), chosen.ofShot, i});
  }
  for (std::size_t i = 0; i < chosen.ofNodes.size(); ++i) {
    if (!chosen.ofNodes[i]) continue;
    const ModelLight& light = scene.lights[static_cast<std::size_t>(scene.nodes[i].light)];
    all.push_back({strengthOf(middle, light, scene.nodes[i].world), chosen.ofNodes, i});
  }
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].strength > all[b].strength; });
  for (std::size_t i = static_cast<std::size_t>(shot.maxLights); i < order.size(); ++i)
    all[order[i]].list[all[order[i]].index] = false;
}

}  // namespace

LightChoice::LightChoice(const Scene& scene, const Shot& shot, const frame::Camera& camera, const Limits& limits)
    : ofShot(shot.lights.size(), true),
      ofNodes(scene.nodes.size()),
      litByShot(ofShot.size()),
      litByNodes(ofNodes.size()) {
  for (std::size_t i = 0; i < ofNodes.size(); ++i) ofNodes[i] = shot.modelLights && scene.nodes[i].light >= 0;
  if (shot.maxLights > 0) chooseStrongest(scene, shot, *this);
  checkLimit("L_LIGHTS", static_cast<double>(limits.lights), static_cast<double>(count()));
  for (std::size_t i = 0; i < ofShot.size(); ++i) {
    const Light& light = shot.lights[i];
    const bool hasRange = light.type == Light::Type::kPoint || light.type == Light::Type::kSpot;
    litByShot[i] =
        ofShot[i] && shines(light) && (!hasRange || frame::reaches(scene, shot, camera, light.position, light.range));
  }
  for (std::size_t i = 0; i < ofNodes.size(); ++i) {
    if (!ofNodes[i]) continue;
    const Node& node = scene.nodes[i];
    const ModelLight& light = scene.lights[static_cast<std::size_t>(node.light)];
    litByNodes[i] =
        shines(light, node.world) && (light.type == LightType::kDirectional ||
                                      frame::reaches(scene, shot, camera, glm::dvec3(node.world[3]), light.range));
  }
}

std::size_t LightChoice::count() const {
  return static_cast<std::size_t>(std::count(ofShot.begin(), ofShot.end(), true) +
                                  std::count(ofNodes.begin(), ofNodes.end(), true));
}

}  // namespace telar::pass
