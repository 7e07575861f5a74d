#pragma once
#include "core/random.h"
#include "reference/background.h"
#include "reference/environment_light.h"
#include "reference/geometry.h"
#include "reference/ground.h"
#include "reference/lights.h"
#include "reference/ray_camera.h"
#include "reference/surface.h"
#include "reference/transmission.h"

namespace telar::reference {

/// What light is followed. Each switch answers a question of its own.
struct Transport {
  bool occlusion = false;  ///< surfaces hide lights and environment from each other
  int bounces = 0;         ///< interreflections between surfaces; needs occlusion
};

/// Random numbers of one path, and a count of its rays.
struct Sampler {
  Random random;
  std::uint64_t rays = 0;  ///< followed through the hierarchy
};

/// What a path can meet. Everything is kept by reference.
struct TracedScene {
  const Textures& textures;
  const std::vector<PlacedMesh>& meshes;
  const Geometry& geometry;
  const Lights& lights;
  const EnvironmentLight* environment;  ///< null = none
  const Background& background;
  const Ground* ground;  ///< null = none
  float radius;          ///< of the scene, metres
};

/// A path tracer with next event estimation and multiple importance sampling of the environment. It has no bias.
/// src: Pharr, Jakob & Humphreys 2023, "Physically Based Rendering", 4th ed., section 13.4; the names are theirs
class Integrator {
 public:
  Integrator(const TracedScene& scene, Transport transport, ShadingModel shading, const ShadingTerms& terms,
             const ThreeTerms& three);

  /// One estimate of the light along a camera ray.
  /// @return linear Rec.709 radiance, premultiplied with coverage, and coverage: 0..1 in the mean of many
  glm::vec4 Li(const PixelPoint& from, Sampler& sampler) const;

 private:
  struct Path;
  /// How many samples one surface takes of the environment, by each of two techniques.
  struct SampleCounts {
    int strata = 1;             ///< squares of them are drawn from the environment
    int lobes = 1;              ///< are drawn from the lobes
    float lobeProbability = 1;  ///< with which the path samples the lobes at all
    /// Expected count of each technique: the factors n_i of the MIS weight.
    float environment() const { return static_cast<float>(strata * strata); }
    float lobe() const { return lobeProbability * static_cast<float>(lobes); }
  };
  SampleCounts sampleCounts(const Path& path, float lobeProbability) const;

  /// A hit that a ray ends at, and the culled back sides that it passed closely before it.
  struct Seen {
    Hit hit;
    int shells = 0;
  };
  /// The next hit along a ray that is not culled or cut out. Alpha below 1 is a probability.
  /// @param opaque  passes through what transmits
  std::optional<Seen> firstSeen(Ray ray, Sampler& sampler, bool opaque) const;
  /// firstSeen() with its material read and prepared. @param from  of a camera ray, else null
  bool intersect(const Ray& ray, const PixelPoint* from, Sampler& sampler, Surface& surface, bool opaque = false) const;
  bool occluded(const Ray& ray, float distance, Sampler& sampler) const;
  Ray spawnRay(const Surface& from, const glm::vec3& direction) const;

  /// Follows a path whose first surface is known. @return as Li()
  glm::vec4 follow(Path& path, Sampler& sampler) const;
  /// Moves the path to what is seen through its surface. @return false: it meets no other surface
  bool transmit(Path& path, Sampler& sampler) const;
  /// The surface that is seen through another. @return false: none
  bool intersectBehind(const Surface& surface, const TransmissionSample& sample, Sampler& sampler, Surface& next) const;
  /// Moves the path along a direction drawn from the lobes. @return false: it ends
  bool reflect(Path& path, const brdf_f::LobeMixture& lobes, const SampleCounts& counts, Sampler& sampler) const;

  /// The BSDF times the cosine: reflected radiance per irradiance on a surface that faces the light.
  /// @param ambient  light of the environment: baked occlusion counts where surfaces hide nothing
  glm::vec3 bsdfCosine(const Surface& surface, const glm::vec3& l, bool ambient) const;
  /// What baked occlusion leaves of ambient light.
  brdf_f::Reflected withBakedOcclusion(brdf_f::Reflected light, const Surface& surface) const;
  /// By the material's map alone.
  brdf_f::Reflected withOcclusionMap(brdf_f::Reflected light, const Surface& surface) const;

  /// Direct light: all lights, and the environment by samples of its own map, weighted against those of the lobes.
  glm::vec3 sampleLd(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                     Sampler& sampler) const;
  glm::vec3 sampleLights(const Surface& surface, Sampler& sampler) const;
  /// Whether something hides the environment in the direction `l`, unit.
  bool hidden(const Surface& surface, const glm::vec3& l, Sampler& sampler) const;
  glm::vec3 sampleEnvironment(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                              Sampler& sampler) const;
  /// The environment by samples of the lobes, for a path that ends here: reflect() does it for the others.
  glm::vec3 sampleLobes(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                        Sampler& sampler) const;
  /// Light of one sample of a light. @param shadow  part that a shadow takes where the shot asks for one
  glm::vec3 estimateDirect(const Surface& surface, const LightSample& light, float shadow, Sampler& sampler) const;

  TracedScene scene_;
  Transport transport_;
  ShadingModel model_;
  std::optional<ShadingTerms> terms_;  ///< of a principled shading
  ThreeTerms three_;                   ///< of the shading kThree
  bool blended_;                       ///< a ray may pass some material at random
};

}  // namespace telar::reference
