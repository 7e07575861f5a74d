#pragma once
#include <optional>

#include "core/random.h"
#include "reference/geometry.h"
#include "telar/shot.h"

namespace telar::reference {

/// The level rectangle that shows nothing but the shadows of the shot's lights: black, as opaque as it lies in shadow.
class Ground {
 public:
  /// @param centre  world position that is the tracer's origin
  Ground(const Shot& shot, const glm::dvec3& centre);

  /// Where a ray meets its upper side, metres along the ray.
  std::optional<float> distance(const Ray& ray) const;
  /// One sample of its opacity there. @param hidden  whether something stands between a point and a light: (origin,
  /// direction, distance)
  template <class Hidden>
  float opacity(const Ray& ray, float distance, Random& random, const Hidden& hidden) const {
    const glm::vec3 point = ray.origin + ray.direction * distance;
    float visible = 1;
    for (const Caster& caster : casters_) {
      const Ray towards = caster.ray(point, random.uniform2());
      const float far = caster.parallel ? std::numeric_limits<float>::infinity()
                                        : glm::distance(caster.position, towards.origin) * (1 - 1e-4f);
      if (hidden(towards, far)) visible *= 1 - caster.intensity;
    }
    return opacity_ * (1 - visible);
  }

 private:
  /// A light that casts a shadow, and how far its map's filter spreads it.
  struct Caster {
    bool parallel = false;
    glm::vec3 position{0};   ///< not of a parallel light
    glm::vec3 direction{0};  ///< to a parallel light
    float intensity = 1;     ///< part of the light that the shadow takes
    float spread = 0;        ///< radius of the filter: metres, of a parallel light; else a slope
    Ray ray(const glm::vec3& point, const glm::vec2& u) const;
  };

  float opacity_ = 0;
  glm::vec3 centre_{0};
  glm::vec2 half_{0};
  std::vector<Caster> casters_;
};

}  // namespace telar::reference
