#include "reference/integrator.h"

#include <limits>

namespace telar::reference {
namespace {

constexpr int MAX_LAYERS = 256;        ///< transparent surfaces that one ray passes
constexpr int MAX_TRANSMISSIONS = 64;  ///< of one path
constexpr float FAR = std::numeric_limits<float>::infinity();

}  // namespace

struct Integrator::Path {
  Surface surface;
  glm::vec3 radiance{0}, throughput{1};
  float coverage = 1;    ///< of the picture by what the path met
  bool straight = true;  ///< nothing has reflected it yet: where it meets nothing, the background shows
  int bounces = 0, transmissions = 0;
};

Integrator::Integrator(const TracedScene& scene, Transport transport, ShadingModel shading, const ShadingTerms& terms,
                       const ThreeTerms& three)
    : scene_(scene),
      transport_{transport.occlusion, transport.occlusion ? transport.bounces : 0},
      shading_(brdf_f::shadingFunctions(shading)),
      terms_(isPrincipled(shading) ? std::optional(terms) : std::nullopt),
      three_(three) {}

brdf_f::Reflected Integrator::withBakedOcclusion(brdf_f::Reflected light, const Surface& surface) const {
  if (transport_.occlusion) return light;
  if (surface.hasVisibility) light = brdf_f::visibleLight(light, surface.info);
  return withOcclusionMap(light, surface);
}

brdf_f::Reflected Integrator::withOcclusionMap(brdf_f::Reflected light, const Surface& surface) const {
  if (surface.occlusion >= 1) return light;
  light.diffuse *= surface.occlusion;
  if (three_.layerOcclusion == ThreeTerms::THREE_LAYER_OCCLUSION_OCCLUDED) {
    light.coat *= surface.occlusion;
    light.sheen *= surface.occlusion;
  }
  light.specular *= brdf_f::specularOcclusion(surface.info.perceptualRoughness, surface.occlusion, surface.info.NoV);
  return light;
}

glm::vec3 Integrator::bsdfCosine(const Surface& surface, const glm::vec3& l, bool ambient) const {
  // Light from behind reaches the viewer only through a cloth that transmits.
  const brdf_f::SurfaceInfo& s = surface.info;
  const bool behind = glm::dot(s.n, l) <= 0 && glm::dot(s.coatNormal, l) <= 0;
  if (behind && s.diffuseTransmission == 0) return glm::vec3(0);
  brdf_f::Reflected direct = shading_.addPunctual(brdf_f::nothingReflected(), surface.info, l, glm::vec3(1));
  if (ambient && surface.hasVisibility && !transport_.occlusion && glm::dot(s.n, l) <= 0) {
    direct.diffuse *= s.visibilityBehind;
    direct = withOcclusionMap(direct, surface);
  } else if (ambient) {
    direct = withBakedOcclusion(direct, surface);
  }
  return shading_.composedRadiance(surface.info, direct.diffuse * (1 - surface.glass.weight), direct,
                                   brdf_f::nothingReflected(), glm::vec3(0));
}

bool Integrator::intersect(Ray ray, const Footprint* footprint, Sampler& sampler, Surface& surface, bool opaque) const {
  Hit hit;
  int shells = 0;
  float lastShell = -FAR;
  const float close = scene_.radius * SHELL;
  for (int layer = 0; layer < MAX_LAYERS; ++layer) {
    ++sampler.rays;
    if (!scene_.geometry.intersect(ray, hit)) return false;
    surface =
        surfaceAt(scene_.textures, scene_.meshes[hit.mesh], hit, ray, footprint, three_, terms_ ? &*terms_ : nullptr);
    const bool oneSided = !scene_.meshes[hit.mesh].material->doubleSided;
    const bool solid = surface.shown && !(opaque && surface.glass.weight > 0);
    if (solid && (surface.alpha >= 1 || sampler.random.uniform() < surface.alpha)) {
      if (!oneSided || ray.passes == 0 || hit.distance > close) {
        surface.shells = hit.distance - lastShell <= close ? shells : 0;
        if (!surface.unlit) surface.info = shading_.preparedSurface(surface.info);
        return true;
      }
      --ray.passes;
    } else if (oneSided && !surface.front) {
      shells = hit.distance - lastShell <= close ? shells + 1 : 1;
      lastShell = hit.distance;
    }
    ray.from = hit.distance + scene_.radius * 1e-5f;
  }
  return false;
}

Ray Integrator::spawnRay(const Surface& from, const glm::vec3& direction) const {
  const float side = glm::dot(from.geometricNormal, direction) < 0 ? -1.0f : 1.0f;
  // A ray back to the viewer's side leaves through the shells that the surface was seen through.
  return {from.position + from.geometricNormal * (side * scene_.radius * 1e-5f), direction, 0,
          side > 0 ? from.shells : 0};
}

bool Integrator::occluded(const Ray& ray, float distance, Sampler& sampler) const {
  Surface blocker;
  return intersect(ray, nullptr, sampler, blocker) && blocker.distance < distance;
}

glm::vec3 Integrator::estimateDirect(const Surface& surface, const LightSample& light, float shadow,
                                     Sampler& sampler) const {
  const glm::vec3 unoccluded = bsdfCosine(surface, light.direction, false) * light.irradiance;
  const float taken = transport_.occlusion ? 1.0f : shadow;
  if (unoccluded == glm::vec3(0) || taken == 0) return unoccluded;
  return occluded(spawnRay(surface, light.direction), light.distance, sampler) ? unoccluded * (1 - taken) : unoccluded;
}

glm::vec3 Integrator::sampleLights(const Surface& surface, Sampler& sampler) const {
  glm::vec3 sum(0);
  for (const PunctualLight& light : scene_.lights.punctual) {
    if (const auto sample = light.sampleLi(surface.position)) {
      sum += estimateDirect(surface, *sample, light.shadow, sampler);
    }
  }
  for (const AreaLight& light : scene_.lights.areas) {
    const auto sample = light.sampleLi(surface.position, sampler.random.uniform2());
    if (sample) sum += estimateDirect(surface, *sample, 0, sampler);
  }
  const glm::vec3 dome = scene_.lights.irradiance(surface.info.n);
  glm::vec3 behind = shading_.addBehind ? scene_.lights.irradiance(-surface.info.n) : glm::vec3(0);
  if (dome != glm::vec3(0) || behind != glm::vec3(0)) {
    brdf_f::Reflected lit = shading_.addDome(brdf_f::nothingReflected(), surface.info, dome);
    // Vertices know each side, a map of occlusion takes from the light of both.
    const bool sides = surface.hasVisibility && !transport_.occlusion;
    if (sides) lit = brdf_f::visibleLight(lit, surface.info), behind *= surface.info.visibilityBehind;
    if (shading_.addBehind) lit = shading_.addBehind(lit, surface.info, behind);
    if (!transport_.occlusion) lit = withOcclusionMap(lit, surface);
    sum += shading_.composedRadiance(surface.info, lit.diffuse * (1 - surface.glass.weight), brdf_f::nothingReflected(),
                                     lit, glm::vec3(0));
  }
  return sum;
}

Integrator::SampleCounts Integrator::sampleCounts(const Path& path, float lobeProbability) const {
  // At the first surface of a path, finding it costs more than one more sample: it takes several, stratified.
  const bool first = path.bounces == 0 && path.transmissions == 0;
  if (!first) return {1, 1, lobeProbability};
  if (!transport_.occlusion) return {2, 2, lobeProbability};
  return {2, transport_.bounces == 0 ? 3 : 1, lobeProbability};
}

glm::vec3 Integrator::sampleLd(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                               Sampler& sampler) const {
  const glm::vec3 lights = sampleLights(surface, sampler);
  return lights + sampleEnvironment(surface, lobes, counts, sampler);
}

glm::vec3 Integrator::reflectedEnvironment(const Surface& surface, const glm::vec3& l, Sampler& sampler) const {
  const glm::vec3 f = bsdfCosine(surface, l, true);
  if (f == glm::vec3(0)) return f;
  if (transport_.occlusion && occluded(spawnRay(surface, l), FAR, sampler)) return glm::vec3(0);
  return f * scene_.environment->radiance(l);
}

glm::vec3 Integrator::sampleEnvironment(const Surface& surface, const brdf_f::LobeMixture& lobes,
                                        const SampleCounts& counts, Sampler& sampler) const {
  glm::vec3 sum(0);
  if (!scene_.environment) return sum;
  const EnvironmentLight& environment = *scene_.environment;
  const auto strata = static_cast<float>(counts.strata);
  for (int i = 0; i < counts.strata * counts.strata; ++i) {
    const glm::vec2 cell(i % counts.strata, i / counts.strata);
    const auto [l, pdf] = environment.sample((cell + sampler.random.uniform2()) / strata);
    if (!(pdf > 0)) continue;
    const glm::vec3 light = reflectedEnvironment(surface, l, sampler);
    if (light == glm::vec3(0)) continue;
    const float misWeight =
        brdf_f::powerHeuristic(counts.environment() * pdf, counts.lobe() * brdf_f::pdfMixture(lobes, l));
    sum += light * (misWeight / pdf);
  }
  return sum / counts.environment();
}

glm::vec3 Integrator::sampleLobes(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                                  Sampler& sampler) const {
  glm::vec3 sum(0);
  if (!scene_.environment) return sum;
  const EnvironmentLight& environment = *scene_.environment;
  for (int i = 0; i < counts.lobes; ++i) {
    const glm::vec3 l = brdf_f::sampleMixture(lobes, sampler.random.uniform2());
    const float pdf = brdf_f::pdfMixture(lobes, l);
    if (!(pdf > 0)) continue;
    const glm::vec3 light = reflectedEnvironment(surface, l, sampler);
    if (light == glm::vec3(0)) continue;
    const float misWeight = brdf_f::powerHeuristic(counts.lobe() * pdf, counts.environment() * environment.pdf(l));
    sum += light * (misWeight / pdf);
  }
  return sum / counts.lobe();
}

bool Integrator::intersectBehind(const Surface& surface, const TransmissionSample& sample, Sampler& sampler,
                                 Surface& next) const {
  const float length = glm::length(sample.path);
  if (length == 0) return intersect(spawnRay(surface, sample.direction), nullptr, sampler, next, !transport_.occlusion);
  const glm::vec3 exit = surface.position + sample.path;
  if (!transport_.occlusion) {
    // As in the raster: what the viewer would see at the point where the light leaves. Only the first layer of glass
    // counts.
    return intersect({exit - sample.direction * (surface.distance + length), sample.direction}, nullptr, sampler, next,
                     true);
  }
  if (intersect(spawnRay(surface, sample.path / length), nullptr, sampler, next) && next.distance < length) return true;
  return intersect({exit, sample.direction}, nullptr, sampler, next);
}

bool Integrator::transmit(Path& path, Sampler& sampler) const {
  if (++path.transmissions > MAX_TRANSMISSIONS) return false;
  const TransmissionSample sample = sampleTransmission(path.surface, sampler.random);
  const brdf_f::Reflected none = brdf_f::nothingReflected();
  path.throughput *= shading_.composedRadiance(path.surface.info, sample.share, none, none, glm::vec3(0));
  Surface next;
  if (intersectBehind(path.surface, sample, sampler, next)) {
    path.surface = next;
    return true;
  }
  if (!path.straight) {
    if (scene_.environment) path.radiance += path.throughput * scene_.environment->radiance(sample.direction);
  } else if (scene_.background.shown()) {
    path.radiance += path.throughput * scene_.background.radiance(sample.direction, sampler.random);
  } else if (scene_.background.color()) {
    path.radiance += path.throughput * *scene_.background.color();
  } else {
    path.coverage = 1 - (path.throughput.r + path.throughput.g + path.throughput.b) / 3;
  }
  return false;
}

bool Integrator::reflect(Path& path, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                         Sampler& sampler) const {
  if (path.bounces == transport_.bounces) {
    path.radiance += path.throughput * sampleLobes(path.surface, lobes, counts, sampler);
    return false;
  }
  const glm::vec3 l = brdf_f::sampleMixture(lobes, sampler.random.uniform2());
  const float pdf = brdf_f::pdfMixture(lobes, l);
  if (!(pdf > 0)) return false;
  path.throughput *= bsdfCosine(path.surface, l, true) / (counts.lobe() * pdf);
  if (path.throughput == glm::vec3(0)) return false;
  path.straight = false;
  Surface next;
  if (!intersect(spawnRay(path.surface, l), nullptr, sampler, next)) {
    if (!scene_.environment) return false;
    const float misWeight =
        brdf_f::powerHeuristic(counts.lobe() * pdf, counts.environment() * scene_.environment->pdf(l));
    path.radiance += path.throughput * scene_.environment->radiance(l) * misWeight;
    return false;
  }
  // Russian roulette: a long path ends at random, and those that survive make up for it.
  if (++path.bounces > 2) {
    const float survival = glm::min(brdf_f::max3(path.throughput), 0.95f);
    if (sampler.random.uniform() >= survival) return false;
    path.throughput /= survival;
  }
  path.surface = next;
  return true;
}

glm::vec4 Integrator::follow(Path& path, Sampler& sampler) const {
  for (;;) {
    const Surface& surface = path.surface;
    path.radiance += path.throughput * surface.emitted;
    if (surface.unlit) break;
    const brdf_f::LobeMixture lobes = brdf_f::lobeMixture(surface.info);
    // Transmission takes the place of the diffuse lobe alone, so some paths must still be reflected.
    const float transmitProbability = surface.glass.weight * 0.75f;
    const SampleCounts counts = sampleCounts(path, 1 - transmitProbability);
    path.radiance += path.throughput * sampleLd(surface, lobes, counts, sampler);
    if (transmitProbability > 0 && sampler.random.uniform() < transmitProbability) {
      path.throughput *= surface.glass.weight / transmitProbability;
      if (!transmit(path, sampler)) break;
    } else if (!reflect(path, lobes, counts, sampler)) {
      break;
    }
  }
  return {path.radiance, path.coverage};
}

glm::vec4 Integrator::Li(const Ray& ray, const Footprint& footprint, Sampler& sampler) const {
  Path path;
  float distance = FAR;
  glm::vec4 light(0);
  if (intersect(ray, &footprint, sampler, path.surface)) {
    distance = path.surface.distance;
    light = follow(path, sampler);
  } else if (scene_.background.shown()) {
    light = glm::vec4(scene_.background.radiance(ray.direction, sampler.random), 1);
  }
  const auto ground = scene_.ground ? scene_.ground->distance(ray) : std::nullopt;
  if (!ground || *ground >= distance) return light;
  const float dark = scene_.ground->opacity(
      ray, *ground, sampler.random, [&](const Ray& towards, float far) { return occluded(towards, far, sampler); });
  return {glm::vec3(light) * (1 - dark), 1 - (1 - light.a) * (1 - dark)};
}

}  // namespace telar::reference
