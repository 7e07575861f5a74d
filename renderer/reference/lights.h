#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "telar/limits.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::reference {

/// A light without extent, in the tracer's world (metres about the scene's centre).
struct PointedLight {
  glm::vec3 color{0};  ///< linear Rec.709 times candela, or lux for a parallel light
  bool parallel = false;
  glm::vec3 position{0};   ///< not for parallel lights
  glm::vec3 direction{0};  ///< from the lit point to a parallel light; from the target to a spot
  float range = 0;         ///< metres, 0 = never ends
  bool spot = false;
  float outerCos = -1, innerCos = -1;
  float shadow = 0;  ///< part of the light that a shadow takes where the shot asks for one

  struct Arrival {
    glm::vec3 direction;   ///< unit, to the light
    glm::vec3 irradiance;  ///< on a surface that faces the light
    float distance;        ///< metres, infinite for parallel light
  };
  /// What arrives at a point; nothing outside of the cone, and nothing at the light itself.
  std::optional<Arrival> at(const glm::vec3& point) const;
};

/// A rectangle or a disk that shines from one side.
struct AreaLight {
  bool disk = false;
  glm::vec3 centre{0}, halfWidth{0}, halfHeight{0};  ///< the tracer's world; radii of a disk
  glm::vec3 normal{0};                               ///< unit, to the side that shines
  glm::vec3 radiance{0};                             ///< linear Rec.709 times nit

  /// What arrives from one point of it, times how many such points there are.
  /// @param u  [0, 1)^2
  std::optional<PointedLight::Arrival> at(const glm::vec3& point, const glm::vec2& u) const;
};

/// Light from all around that has no direction of its own.
struct Dome {
  glm::vec3 sky{0}, ground{0};  ///< irradiance
};

struct Lights {
  std::vector<PointedLight> pointed;
  std::vector<AreaLight> areas;
  std::vector<Dome> domes;
  glm::vec3 irradiance(const glm::vec3& normal) const;
};

/// The shot's lights, then the model's where the shot allows. @throws Error{L_LIGHTS}
Lights lightsOf(const Scene& scene, const Shot& shot, const glm::dvec3& centre, const Limits& limits);

}  // namespace telar::reference
