#pragma once
#include <optional>

#include "core/random.h"
#include "reference/geometry.h"
#include "telar/shot.h"

namespace telar::reference {

/// A shadow catcher: a level rectangle that shows the shadows of the shot's lights and nothing else. It is black, and
/// as opaque as the shadow.
class Ground {
 public:
  /// @param centre  world position that is the tracer's origin
  Ground(const Shot& shot, const glm::dvec3& centre);

  /// Metres along a ray to its upper side. None where the ray misses it.
  std::optional<float> distance(const Ray& ray) const;
  /// One sample of its opacity there. @param occluded  whether a ray meets a surface within a distance: (ray, metres)
  template <class Occluded>
  float opacity(const Ray& ray, float distance, Random& random, const Occluded& occluded) const {
    const glm::vec3 point = ray.origin + ray.direction * distance;
    float visible = 1;
    for (const Caster& caster : casters_) {
      const Ray towards = caster.ray(point, random.uniform2());
      const float far = caster.directional ? std::numeric_limits<float>::infinity()
                                           : glm::distance(caster.position, towards.origin) * (1 - 1e-4f);
      if (occluded(towards, far)) visible *= 1 - caster.intensity;
    }
    return opacity_ * (1 - visible);
  }

 private:
  /// A light that casts a shadow, and the blur of its shadow map.
  struct Caster {
    bool directional = false;
    glm::vec3 position{0};   ///< not of a directional light
    glm::vec3 direction{0};  ///< to a directional light
    float intensity = 1;     ///< part of the light that the shadow takes
    float spread = 0;        ///< radius of the blur: metres of a directional light, else metres a metre of distance
    Ray ray(const glm::vec3& point, const glm::vec2& u) const;
  };

  float opacity_ = 0;
  glm::vec3 centre_{0};
  glm::vec2 half_{0};
  std::vector<Caster> casters_;
};

}  // namespace telar::reference
