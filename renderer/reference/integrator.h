#pragma once
#include "core/random.h"
#include "reference/environment_light.h"
#include "reference/geometry.h"
#include "reference/ground.h"
#include "reference/lights.h"
#include "reference/lobe_sampler.h"
#include "reference/sky.h"
#include "reference/surface.h"
#include "reference/transmission.h"

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

/// What light meets: all are kept by reference.
struct Stage {
  const Textures& textures;
  const std::vector<PlacedMesh>& meshes;
  const Geometry& geometry;
  const Lights& lights;
  const EnvironmentLight* environment;  ///< null = none
  const Sky& sky;
  const Ground* ground;  ///< null = none
  float radius;          ///< of the scene, metres
};

/// Estimates the light along one ray, without bias.
class Integrator {
 public:
  Integrator(const Stage& stage, Transport transport, ShadingModel shading, const ShadingTerms& terms,
             glm::vec2 (*dfg)(float, float));

  /// @return linear Rec.709 radiance, premultiplied with coverage, and coverage: 0..1 in the mean of many
  glm::vec4 radiance(const Ray& ray, const Footprint& footprint, Walk& walk) const;

 private:
  /// A path on its way.
  struct Path;
  /// How often one surface asks each way for light.
  struct Draws {
    int strata = 1;   ///< squares of them are drawn from the environment
    int lobes = 1;    ///< drawn from the lobes
    float share = 1;  ///< chance that the path draws from the lobes at all
    float environment() const { return static_cast<float>(strata * strata); }
    float lobe() const { return share * static_cast<float>(lobes); }
  };
  Draws drawsAt(const Path& path, float share) const;
  /// The next surface along a ray that is shown; alpha is a chance.
  /// @param opaque  pass over what transmits
  bool nextSurface(Ray ray, const Footprint* footprint, Walk& walk, Surface& surface, bool opaque = false) const;
  bool hidden(const Ray& ray, float distance, Walk& walk) const;
  Ray leave(const Surface& from, const glm::vec3& direction) const;
  /// Light of a path whose first surface is found.
  glm::vec4 pathLight(Path& path, Walk& walk) const;
  /// What is seen through a surface. @return false: nothing
  bool behind(const Surface& surface, const Passage& passage, Walk& walk, Surface& next) const;
  /// The path goes on through the surface. @return false: it meets no other
  bool passThrough(Path& path, Walk& walk) const;
  /// The path is reflected. @return false: it ends
  bool reflect(Path& path, const LobeSampler& lobes, const Draws& draws, Walk& walk) const;
  /// Reflected radiance per irradiance on a surface that faces the light.
  /// @param around  of the environment: a baked occlusion counts where nothing is hidden by surfaces
  glm::vec3 reflected(const Surface& surface, const glm::vec3& l, bool around) const;
  /// What baked occlusion leaves of light from everywhere.
  brdf_f::Reflected baked(brdf_f::Reflected light, const Surface& surface) const;
  /// Light of all lights that arrives directly and leaves to the viewer.
  glm::vec3 directLight(const Surface& surface, Walk& walk) const;
  /// Light of the environment that draws from it find.
  glm::vec3 environmentLight(const Surface& surface, const LobeSampler& lobes, const Draws& draws, Walk& walk) const;
  /// Light of the environment that draws from the lobes find, of a path that ends there.
  glm::vec3 lobeLight(const Surface& surface, const LobeSampler& lobes, const Draws& draws, Walk& walk) const;
  glm::vec3 arriving(const Surface& surface, const PointedLight::Arrival& arrival, float shadow, Walk& walk) const;

  Stage stage_;
  Transport transport_;
  brdf_f::ShadingFunctions shading_;
  std::optional<ShadingTerms> terms_;  ///< of a principled shading
  glm::vec2 (*dfg_)(float, float);
};

}  // namespace telar::reference
