#include "reference/integrator.h"

#include <cmath>

#include "reference/lobe_sampler.h"
#include "reference/sampling.h"

namespace telar::reference {
namespace {

constexpr int MOST_LAYERS = 256;  ///< of transparent surfaces that one ray passes

}  // namespace

Integrator::Integrator(const Scene& scene, const std::vector<PlacedMesh>& meshes, const Geometry& geometry,
                       const Lights& lights, const EnvironmentLight* environment, float radius, Transport transport,
                       ShadingModel shading, const ShadingTerms& terms, glm::vec2 (*dfg)(float, float))
    : scene_(scene),
      meshes_(meshes),
      geometry_(geometry),
      lights_(lights),
      environment_(environment),
      radius_(radius),
      transport_(transport),
      shading_(brdf_f::shadingFunctions(shading)),
      terms_(isPrincipled(shading) ? std::optional(terms) : std::nullopt),
      dfg_(dfg) {}

glm::vec3 Integrator::reflected(const brdf_f::SurfaceInfo& surface, const glm::vec3& l) const {
  const brdf_f::Reflected direct = shading_.addPunctual(brdf_f::nothingReflected(), surface, l, glm::vec3(1));
  return shading_.composedRadiance(surface, direct.diffuse, direct, brdf_f::nothingReflected(), glm::vec3(0));
}

bool Integrator::nextSurface(Ray ray, const Footprint* footprint, Walk& walk, Surface& surface) const {
  Hit hit;
  for (int layer = 0; layer < MOST_LAYERS; ++layer) {
    ++walk.rays;
    if (!geometry_.intersect(ray, hit)) return false;
    surface = surfaceAt(scene_, meshes_[hit.mesh], hit, ray, footprint, dfg_, terms_ ? &*terms_ : nullptr);
    surface.info = shading_.preparedSurface(surface.info);
    if (surface.shown && (surface.alpha >= 1 || walk.random.uniform() < surface.alpha)) return true;
    ray.from = hit.distance + radius_ * 1e-5f;
  }
  return false;
}

Ray Integrator::leave(const Surface& from, const glm::vec3& direction) const {
  const float side = glm::dot(from.geometricNormal, direction) < 0 ? -1.0f : 1.0f;
  return {from.position + from.geometricNormal * (side * radius_ * 1e-5f), direction};
}

bool Integrator::hidden(const Surface& from, const glm::vec3& direction, float distance, Walk& walk) const {
  const Ray ray = leave(from, direction);
  Surface blocker;
  if (!nextSurface(ray, nullptr, walk, blocker)) return false;
  return glm::distance(blocker.position, ray.origin) < distance;
}

glm::vec3 Integrator::arriving(const Surface& surface, const PointedLight::Arrival& arrival, Walk& walk) const {
  const glm::vec3 share = reflected(surface.info, arrival.direction) * arrival.irradiance;
  if (share == glm::vec3(0)) return share;
  return transport_.occlusion && hidden(surface, arrival.direction, arrival.distance, walk) ? glm::vec3(0) : share;
}

glm::vec3 Integrator::directLight(const Surface& surface, Walk& walk) const {
  glm::vec3 sum(0);
  for (const PointedLight& light : lights_.pointed) {
    if (const auto arrival = light.at(surface.position)) sum += arriving(surface, *arrival, walk);
  }
  for (const RectLight& light : lights_.rects) {
    if (const auto arrival = light.at(surface.position, walk.random.uniform2()))
      sum += arriving(surface, *arrival, walk);
  }
  const glm::vec3 dome = lights_.irradiance(surface.info.n);
  if (dome != glm::vec3(0)) {
    const brdf_f::Reflected lit = shading_.addDome(brdf_f::nothingReflected(), surface.info, dome);
    sum += shading_.composedRadiance(surface.info, lit.diffuse, brdf_f::nothingReflected(), lit, glm::vec3(0));
  }
  return sum;
}

glm::vec4 Integrator::radiance(Ray ray, const Footprint& footprint, Walk& walk) const {
  Surface surface;
  if (!nextSurface(ray, &footprint, walk, surface)) return glm::vec4(0);
  glm::vec3 light(0), throughput(1);
  for (int bounce = 0;; ++bounce) {
    light += throughput * surface.emitted;
    if (surface.unlit) break;
    const LobeSampler lobes(surface.info);
    light += throughput * directLight(surface, walk);
    if (environment_) {
      const auto drawn = environment_->sample(walk.random.uniform2());
      const glm::vec3 share = drawn.pdf > 0 ? reflected(surface.info, drawn.direction) : glm::vec3(0);
      if (share != glm::vec3(0) &&
          !(transport_.occlusion && hidden(surface, drawn.direction, std::numeric_limits<float>::infinity(), walk))) {
        const float weight = powerHeuristic(drawn.pdf, lobes.pdf(drawn.direction)) / drawn.pdf;
        light += throughput * share * environment_->radiance(drawn.direction) * weight;
      }
    }
    const auto drawn = lobes.sample(walk.random);
    if (!(drawn.pdf > 0)) break;
    throughput *= reflected(surface.info, drawn.direction) / drawn.pdf;
    if (throughput == glm::vec3(0)) break;
    Surface next;
    if (!transport_.occlusion || !nextSurface(leave(surface, drawn.direction), nullptr, walk, next)) {
      if (environment_) {
        const float weight = powerHeuristic(drawn.pdf, environment_->pdf(drawn.direction));
        light += throughput * environment_->radiance(drawn.direction) * weight;
      }
      break;
    }
    if (bounce == transport_.bounces) break;
    // Russian roulette: long paths end by chance and the others stand for them.
    if (bounce >= 2) {
      const float going = glm::min(brdf_f::max3(throughput), 0.95f);
      if (walk.random.uniform() >= going) break;
      throughput /= going;
    }
    surface = next;
  }
  return glm::vec4(light, 1.0f);
}

}  // namespace telar::reference
