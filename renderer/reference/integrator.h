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

  static constexpr std::size_t MAX_PATHS = 8;
  /// One estimate of the light along each of some camera rays. Their paths are followed side by side: while one waits
  /// for memory, the others go on.
  /// @param from  MAX_PATHS or fewer
  /// @param samplers  of each ray
  /// @param[out] light  of each: linear Rec.709 radiance, premultiplied with coverage, and coverage: 0..1 in the mean
  ///   of many
  void Li(std::span<const PixelPoint> from, std::span<Sampler> samplers, glm::vec4* light) const;

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
  static constexpr int MAX_STRATA = 2;
  /// For the surface that the path has arrived at.
  SampleCounts sampleCounts(const Path& path) const;

  /// A hit that a ray ends at, and the culled back sides that it passed closely before it.
  struct Seen {
    Hit hit;
    int shells = 0;
  };
  /// The next hit along a ray that is not culled or cut out. Alpha below 1 is a probability.
  /// @param opaque  passes through what transmits
  std::optional<Seen> firstSeen(const Ray& ray, Sampler& sampler, bool opaque) const;
  /// The same where the nearest hit is known. @param hit  of the ray; none where it meets nothing
  std::optional<Seen> firstSeen(Ray ray, std::optional<Hit> hit, Sampler& sampler, bool opaque) const;
  /// The nearest hit of a ray, which is counted.
  std::optional<Hit> nearest(const Ray& ray, Sampler& sampler) const;
  /// Makes `surface` what was seen, with its material read and prepared. @param from  of a camera ray, else null
  void read(const Seen& seen, const Ray& ray, const PixelPoint* from, Surface& surface) const;
  /// firstSeen() and read(). @return false: nothing is seen
  bool intersect(const Ray& ray, Sampler& sampler, Surface& surface, bool opaque = false) const;
  bool occluded(const Ray& ray, float distance, Sampler& sampler) const;
  Ray spawnRay(const Surface& from, const glm::vec3& direction) const;

  /// Follows paths from surface to surface, in the steps below, until all have ended.
  void follow(std::span<Path> paths) const;
  /// Finds what the rays of all paths meet.
  void look(std::span<Path* const> paths) const;
  /// Reads that surface, and adds what it emits and what it reflects of lamps. Where there is none: leave().
  /// @return false: the path ends there, or by Russian roulette
  bool arrive(Path& path) const;
  /// Adds what a path sees whose ray meets nothing: the background, or the environment, weighted against its own samples.
  void leave(Path& path) const;
  /// Draws directions from the environment for the surfaces of all paths. @param drawn  MAX_SAMPLES, kept by the caller
  void drawEnvironment(std::span<Path* const> paths, EnvironmentLight::Sample* drawn) const;
  /// Adds the light of these directions, and goes on by transmit() or reflect(). @return false: the path ends
  bool scatter(Path& path) const;
  /// The light of a camera ray with the shadow on the ground. @param distance  of its first surface
  glm::vec4 withGround(const glm::vec4& light, const Ray& ray, float distance, Sampler& sampler) const;
  /// Moves the path to what is seen through its surface. @return false: there is none, or it has passed too many
  bool transmit(Path& path) const;
  /// The surface that is seen through another. @return false: none
  bool intersectBehind(const Surface& surface, const TransmissionSample& sample, Sampler& sampler, Surface& next) const;
  /// Turns the path to a direction drawn from the lobes. @return false: it ends
  bool reflect(Path& path) const;

  /// The BSDF times the cosine: reflected radiance per irradiance on a surface that faces the light.
  /// @param ambient  light of the environment: baked occlusion counts where surfaces hide nothing
  glm::vec3 bsdfCosine(const Surface& surface, const glm::vec3& l, bool ambient) const;
  /// What baked occlusion leaves of ambient light.
  brdf_f::Reflected withBakedOcclusion(brdf_f::Reflected light, const Surface& surface) const;
  /// By the material's map alone.
  brdf_f::Reflected withOcclusionMap(brdf_f::Reflected light, const Surface& surface) const;

  /// The light of all lamps.
  glm::vec3 sampleLights(const Surface& surface, Sampler& sampler) const;
  /// Whether something hides the environment in the direction `l`, unit.
  bool hidden(const Surface& surface, const glm::vec3& l, Sampler& sampler) const;
  /// The environment by samples of its own map, weighted against those of the lobes.
  glm::vec3 sampleEnvironment(const Path& path) const;
  /// The environment by samples of the lobes, for a path that ends here: leave() does it for the others.
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
