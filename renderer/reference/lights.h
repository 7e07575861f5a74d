#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "telar/limits.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::reference {

/// Light that arrives at a point from one direction.
struct LightSample {
  glm::vec3 direction;   ///< unit, to the light
  glm::vec3 irradiance;  ///< on a surface that faces the light
  float distance;        ///< metres, infinite for a directional light
};

/// A point, spot or directional light, in the tracer's world (metres about the scene's centre).
struct PunctualLight {
  glm::vec3 color{0};  ///< linear Rec.709 times candela, or lux of a directional light
  bool directional = false;
  glm::vec3 position{0};   ///< not of a directional light
  glm::vec3 direction{0};  ///< to a directional light; from its target to a spot light
  float range = 0;         ///< metres, 0 = never ends
  bool spot = false;
  float outerCos = -1, innerCos = -1;
  float shadow = 0;  ///< part of the light that a shadow takes where the shot asks for one

  /// Light that arrives at a point. None outside of the cone, and none at the light itself.
  std::optional<LightSample> sampleLi(const glm::vec3& point) const;
};

/// A rect or disk light. One side shines.
struct AreaLight {
  bool disk = false;
  glm::vec3 centre{0}, halfWidth{0}, halfHeight{0};  ///< the tracer's world; radii of a disk
  glm::vec3 normal{0};                               ///< unit, of the side that shines
  glm::vec3 radiance{0};                             ///< linear Rec.709 times nit

  /// Light of one point of it, drawn by area, over the density of that point: the mean of many is the light that
  /// arrives.
  /// @param u  [0, 1)^2
  std::optional<LightSample> sampleLi(const glm::vec3& point, const glm::vec2& u) const;
};

/// An ambient or hemisphere light.
struct Dome {
  glm::vec3 sky{0}, ground{0};  ///< irradiance
};

struct Lights {
  std::vector<PunctualLight> punctual;
  std::vector<AreaLight> areas;
  std::vector<Dome> domes;
  glm::vec3 irradiance(const glm::vec3& normal) const;
};

/// The shot's lights, then the model's where the shot allows. @throws Error{L_LIGHTS}
Lights lightsOf(const Scene& scene, const Shot& shot, const glm::dvec3& centre, const Limits& limits);

}  // namespace telar::reference
