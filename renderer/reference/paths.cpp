#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "reference/integrator.h"

namespace telar::reference {
namespace {

constexpr int MAX_TRANSMISSIONS = 64;  ///< of one path

}  // namespace

struct Integrator::Path {
  const PixelPoint* from = nullptr;  ///< of a camera ray that is on its way, else null
  Sampler* sampler = nullptr;
  Ray ray{};                 ///< to the next surface
  std::optional<Hit> hit;    ///< its nearest one
  std::optional<Seen> seen;  ///< what it ends at
  bool arrived = false;      ///< the next surface is `surface`, as it was met on the way through another
  Surface surface;
  brdf_f::LobeMixture lobes;                        ///< of the surface
  SampleCounts counts;                              ///< of the surface
  std::span<const EnvironmentLight::Sample> drawn;  ///< from the environment for the surface; follow() keeps them
  EnvironmentLight::Place place{};                  ///< of the ray in the environment
  float pdf = 0;                                    ///< of the ray among the lobes that it was drawn from
  glm::vec3 radiance{0}, throughput{1};
  float coverage = 1;                                       ///< of the picture by what the path met
  float distance = std::numeric_limits<float>::infinity();  ///< of its first surface
  bool straight = true;  ///< nothing has reflected it yet: where it meets nothing, the background shows
  int bounces = 0, transmissions = 0;
};

Integrator::SampleCounts Integrator::sampleCounts(const Path& path) const {
  // Transmission takes the place of the diffuse lobe alone, so some paths must still be reflected.
  const float lobeProbability = 1 - path.surface.glass.weight * 0.75f;
  // At the first surface of a path, finding it costs more than one more sample: it takes several, stratified.
  const bool first = path.bounces == 0 && path.transmissions == 0;
  if (!first) return {1, 1, lobeProbability};
  if (!transport_.occlusion) return {MAX_STRATA, 2, lobeProbability};
  return {MAX_STRATA, transport_.bounces == 0 ? 3 : 1, lobeProbability};
}

glm::vec3 Integrator::sampleEnvironment(const Path& path) const {
  glm::vec3 sum(0);
  const Surface& surface = path.surface;
  const SampleCounts& counts = path.counts;
  for (const EnvironmentLight::Sample& light : path.drawn) {
    if (!(light.pdf > 0)) continue;
    const glm::vec3 f = bsdfCosine(surface, light.direction, true);
    if (f == glm::vec3(0) || hidden(surface, light.direction, *path.sampler)) continue;
    const float misWeight = brdf_f::powerHeuristic(
        counts.environment() * light.pdf, counts.lobe() * surface.shading->pdfMixture(path.lobes, light.direction));
    sum += f * scene_.environment->radiance(light) * (misWeight / light.pdf);
  }
  return sum / counts.environment();
}

bool Integrator::intersectBehind(const Surface& surface, const TransmissionSample& sample, Sampler& sampler,
                                 Surface& next) const {
  const float length = glm::length(sample.path);
  if (length == 0) return intersect(spawnRay(surface, sample.direction), sampler, next, !transport_.occlusion);
  const glm::vec3 exit = surface.position + sample.path;
  if (!transport_.occlusion) {
    // As in the raster: what the viewer would see at the point where the light leaves. Only the first layer of glass
    // counts.
    return intersect({exit - sample.direction * (surface.distance + length), sample.direction}, sampler, next, true);
  }
  if (intersect(spawnRay(surface, sample.path / length), sampler, next) && next.distance < length) return true;
  return intersect({exit, sample.direction}, sampler, next);
}

bool Integrator::transmit(Path& path) const {
  if (++path.transmissions > MAX_TRANSMISSIONS) return false;
  const TransmissionSample sample = sampleTransmission(path.surface, path.sampler->random);
  path.throughput *= path.surface.shading->composed(path.surface.info, sample.share, brdf_f::nothingReflected());
  Surface next;
  if (intersectBehind(path.surface, sample, *path.sampler, next)) {
    path.surface = next;
    path.arrived = true;
    return true;
  }
  if (!path.straight) {
    if (scene_.environment) path.radiance += path.throughput * scene_.environment->radiance(sample.direction);
  } else if (scene_.background.shown()) {
    path.radiance += path.throughput * scene_.background.radiance(sample.direction, path.sampler->random);
  } else if (scene_.background.color()) {
    path.radiance += path.throughput * *scene_.background.color();
  } else {
    path.coverage = 1 - (path.throughput.r + path.throughput.g + path.throughput.b) / 3;
  }
  return false;
}

bool Integrator::reflect(Path& path) const {
  const Surface& surface = path.surface;
  if (path.bounces == transport_.bounces) {
    path.radiance += path.throughput * sampleLobes(surface, path.lobes, path.counts, *path.sampler);
    return false;
  }
  const glm::vec3 l = surface.shading->sampleMixture(path.lobes, path.sampler->random.uniform2());
  path.pdf = surface.shading->pdfMixture(path.lobes, l);
  if (!(path.pdf > 0)) return false;
  path.throughput *= bsdfCosine(surface, l, true) / (path.counts.lobe() * path.pdf);
  if (path.throughput == glm::vec3(0)) return false;
  path.straight = false;
  if (scene_.environment) path.place = scene_.environment->find(l);
  path.ray = spawnRay(surface, l);
  return true;
}

void Integrator::look(std::span<Path* const> paths) const {
  if (std::ranges::all_of(paths, [](const Path* path) { return path->from != nullptr; })) {
    static_assert(MAX_PATHS <= Geometry::MAX_COHERENT);
    std::array<Ray, MAX_PATHS> rays;
    std::array<std::optional<Hit>, MAX_PATHS> hits;
    for (std::size_t i = 0; i < paths.size(); ++i) rays[i] = paths[i]->ray, ++paths[i]->sampler->rays;
    scene_.geometry.intersect(std::span(rays).first(paths.size()), hits);
    for (std::size_t i = 0; i < paths.size(); ++i) paths[i]->hit = hits[i];
  } else {
    for (Path* path : paths)
      if (!path->arrived) path->hit = nearest(path->ray, *path->sampler);
  }
  // What each reads of memory is on its way while the others are looked at.
  const auto met = [&](const std::optional<Hit>& hit) -> const PlacedMesh& { return scene_.meshes[hit->mesh]; };
  for (const Path* path : paths)
    if (!path->arrived && path->hit) prefetchTriangle(met(path->hit), *path->hit);
  for (const Path* path : paths)
    if (!path->arrived && path->hit) prefetchVertices(met(path->hit), *path->hit);
  for (Path* path : paths) {
    if (path->arrived) continue;
    path->seen = firstSeen(path->ray, path->hit, *path->sampler, false);
    if (path->seen) prefetchTexels(scene_.textures, met(path->seen->hit), path->seen->hit);
  }
}

void Integrator::leave(Path& path) const {
  if (path.from) {
    path.coverage = scene_.background.shown() ? 1 : 0;
    if (scene_.background.shown()) path.radiance = scene_.background.radiance(path.ray.direction, path.sampler->random);
  } else if (scene_.environment) {
    const EnvironmentLight& environment = *scene_.environment;
    const float misWeight =
        brdf_f::powerHeuristic(path.counts.lobe() * path.pdf, path.counts.environment() * environment.pdf(path.place));
    path.radiance += path.throughput * environment.radiance(path.place) * misWeight;
  }
}

bool Integrator::arrive(Path& path) const {
  if (!path.arrived) {
    if (!path.seen) {
      leave(path);
      return false;
    }
    // Russian roulette: a long path ends at random, and those that survive make up for it.
    if (!path.from && ++path.bounces > 2) {
      const float survival = glm::min(brdf_f::max3(path.throughput), 0.95f);
      if (path.sampler->random.uniform() >= survival) return false;
      path.throughput /= survival;
    }
    read(*path.seen, path.ray, path.from, path.surface);
    if (path.from) path.distance = path.surface.distance;
    path.from = nullptr;
  }
  path.arrived = false;
  const Surface& surface = path.surface;
  path.radiance += path.throughput * surface.emitted;
  if (surface.unlit) return false;
  surface.shading->lobeMixture(surface.info, path.lobes);
  path.counts = sampleCounts(path);
  path.radiance += path.throughput * sampleLights(surface, *path.sampler);
  return true;
}

void Integrator::drawEnvironment(std::span<Path* const> paths, EnvironmentLight::Sample* drawn) const {
  if (!scene_.environment) return;
  std::array<glm::vec2, EnvironmentLight::MAX_SAMPLES> us;
  std::size_t count = 0;
  for (Path* path : paths) {
    const int strata = path->counts.strata;
    path->drawn = {drawn + count, static_cast<std::size_t>(strata * strata)};
    for (int i = 0; i < strata * strata; ++i) {
      us[count++] = (glm::vec2(i % strata, i / strata) + path->sampler->random.uniform2()) / static_cast<float>(strata);
    }
  }
  scene_.environment->sample(std::span(us).first(count), drawn);
}

bool Integrator::scatter(Path& path) const {
  path.radiance += path.throughput * sampleEnvironment(path);
  const float transmitProbability = 1 - path.counts.lobeProbability;
  if (transmitProbability > 0 && path.sampler->random.uniform() < transmitProbability) {
    path.throughput *= path.surface.glass.weight / transmitProbability;
    return transmit(path);
  }
  return reflect(path);
}

void Integrator::follow(std::span<Path> paths) const {
  static_assert(MAX_PATHS * MAX_STRATA * MAX_STRATA <= EnvironmentLight::MAX_SAMPLES);
  std::array<EnvironmentLight::Sample, EnvironmentLight::MAX_SAMPLES> drawn;
  std::array<Path*, MAX_PATHS> onTheirWay;
  std::size_t count = 0;
  for (Path& path : paths) onTheirWay[count++] = &path;
  const auto going = [&] { return std::span(onTheirWay).first(count); };
  const auto keep = [&](bool (Integrator::*step)(Path&) const) {
    std::size_t kept = 0;
    for (Path* path : going())
      if ((this->*step)(*path)) onTheirWay[kept++] = path;
    count = kept;
  };
  while (count > 0) {
    look(going());
    keep(&Integrator::arrive);
    drawEnvironment(going(), drawn.data());
    keep(&Integrator::scatter);
  }
}

void Integrator::Li(std::span<const PixelPoint> from, std::span<Sampler> samplers, glm::vec4* light) const {
  assert(from.size() <= MAX_PATHS);
  std::array<Path, MAX_PATHS> paths;
  for (std::size_t i = 0; i < from.size(); ++i) {
    paths[i].from = &from[i];
    paths[i].sampler = &samplers[i];
    paths[i].ray = from[i].ray();
  }
  follow(std::span(paths).first(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    light[i] = glm::vec4(paths[i].radiance, paths[i].coverage);
    if (scene_.ground) light[i] = withGround(light[i], from[i].ray(), paths[i].distance, samplers[i]);
  }
}

glm::vec4 Integrator::withGround(const glm::vec4& light, const Ray& ray, float distance, Sampler& sampler) const {
  const auto ground = scene_.ground->distance(ray);
  if (!ground || *ground >= distance) return light;
  const float dark = scene_.ground->opacity(
      ray, *ground, sampler.random, [&](const Ray& towards, float far) { return occluded(towards, far, sampler); });
  return {glm::vec3(light) * (1 - dark), 1 - (1 - light.a) * (1 - dark)};
}

}  // namespace telar::reference
