#pragma once
#include "reference/environment_light.h"
#include "reference/geometry.h"
#include "reference/lights.h"
#include "reference/random.h"
#include "reference/surface.h"

namespace telar::reference {

/// What light is followed. Each switch answers a question of its own.
struct Transport {
  bool occlusion = false;  ///< surfaces hide lights and environment from each other
  int bounces = 0;         ///< interreflections between surfaces; needs occlusion
};

/// One path, and what it took.
struct Walk {
  Random random;
  std::uint64_t rays = 0;  ///< followed through the hierarchy
};

/// Estimates the light along one ray, without bias.
class Integrator {
 public:
  /// All are kept by reference. @param environment  null = none
  /// @param radius  of the scene, metres
  Integrator(const Scene& scene, const std::vector<PlacedMesh>& meshes, const Geometry& geometry, const Lights& lights,
             const EnvironmentLight* environment, float radius, Transport transport, ShadingModel shading,
             const ShadingTerms& terms, glm::vec2 (*dfg)(float, float));

  /// @return linear Rec.709 radiance, premultiplied with coverage, and coverage 0 or 1
  glm::vec4 radiance(Ray ray, const Footprint& footprint, Walk& walk) const;

 private:
  /// The next surface along a ray that is shown; alpha is a chance.
  bool nextSurface(Ray ray, const Footprint* footprint, Walk& walk, Surface& surface) const;
  bool hidden(const Surface& from, const glm::vec3& direction, float distance, Walk& walk) const;
  Ray leave(const Surface& from, const glm::vec3& direction) const;
  /// Reflected radiance per irradiance on a surface that faces the light; 0 below the horizon.
  glm::vec3 reflected(const brdf_f::SurfaceInfo& surface, const glm::vec3& l) const;
  /// Light of all lights that arrives directly and leaves to the viewer.
  glm::vec3 directLight(const Surface& surface, Walk& walk) const;
  glm::vec3 arriving(const Surface& surface, const PointedLight::Arrival& arrival, Walk& walk) const;

  const Scene& scene_;
  const std::vector<PlacedMesh>& meshes_;
  const Geometry& geometry_;
  const Lights& lights_;
  const EnvironmentLight* environment_;
  float radius_;
  Transport transport_;
  brdf_f::ShadingFunctions shading_;
  std::optional<ShadingTerms> terms_;  ///< of a principled shading
  glm::vec2 (*dfg_)(float, float);
};

}  // namespace telar::reference
