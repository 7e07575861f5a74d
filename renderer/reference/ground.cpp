#include "reference/ground.h"

#include <cmath>

#include "brdf/brdf.h"

namespace telar::reference {
namespace {

constexpr double TAP = 0.5;  ///< texels, half the width of a bilinear tap

}  // namespace

Ground::Ground(const Shot& shot, const glm::dvec3& centre)
    : opacity_(static_cast<float>(shot.ground->opacity)),
      centre_(shot.ground->position - centre),
      half_(shot.ground->size / 2.0) {
  using Type = Shot::Light::Type;
  for (const Shot::Light& light : shot.lights) {
    if (!light.castShadow) continue;
    const Shot::Light::Shadow& shadow = light.shadow;
    // A map of the raster whose shadows fall on the model has finer texels too.
    const int finer = shot.shading == ShadingModel::kFabric && shines(light) ? shot.shadowScale : 1;
    const double texels = (shadow.radius + TAP) / (shadow.mapSize * finer);  // parts of the map's side
    Caster caster;
    caster.intensity = static_cast<float>(shadow.intensity);
    caster.directional = light.type == Type::kDirectional;
    caster.position = light.position - centre;
    if (caster.directional) {
      caster.direction = glm::normalize(light.position - light.target);
      caster.spread = static_cast<float>(texels * (shadow.right - shadow.left));
    } else {
      const double slope = light.type == Type::kSpot ? std::tan(std::min(light.angle * shadow.focus, 1.4)) : 1.0;
      caster.spread = static_cast<float>(texels * 2 * slope);
    }
    casters_.push_back(caster);
  }
}

std::optional<float> Ground::distance(const Ray& ray) const {
  if (ray.direction.y >= 0) return std::nullopt;
  const float t = (centre_.y - ray.origin.y) / ray.direction.y;
  const glm::vec3 point = ray.origin + ray.direction * t - centre_;
  if (t < ray.from || std::abs(point.x) > half_.x || std::abs(point.z) > half_.y) return std::nullopt;
  return t;
}

Ray Ground::Caster::ray(const glm::vec3& point, const glm::vec2& u) const {
  const glm::vec3 toLight = directional ? direction : position - point;
  const float distance = glm::length(toLight);
  const glm::vec3 l = toLight / distance;
  const float radius = std::sqrt(u.x) * spread * (directional ? 1.0f : distance), phi = 6.2831853f * u.y;
  const glm::mat3 frame = brdf_f::basisAbout(l);
  // The raster filters its shadow map. Here the point moves across the light's direction by as much.
  const glm::vec3 origin = point + frame[0] * (radius * std::cos(phi)) + frame[1] * (radius * std::sin(phi));
  return {origin, directional ? l : glm::normalize(position - origin)};
}

}  // namespace telar::reference
