#include "reference/integrator.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <type_traits>

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
      model_(shading),
      terms_(isPrincipled(shading) ? std::optional(terms) : std::nullopt),
      three_(three),
      blended_(std::ranges::any_of(
          scene.meshes, [](const PlacedMesh& mesh) { return mesh.material->alphaMode == AlphaMode::kBlend; })) {}

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
  const float diffuse = 1 - surface.glass.weight;
  const bool baked = ambient && !transport_.occlusion && (surface.hasVisibility || surface.occlusion < 1);
  if (!baked) return surface.shading->bsdfCosine(s, l, diffuse);
  brdf_f::Reflected direct = surface.shading->punctual(s, l);
  if (surface.hasVisibility && glm::dot(s.n, l) <= 0) {
    direct.diffuse *= s.visibilityBehind;
    direct = withOcclusionMap(direct, surface);
  } else {
    direct = withBakedOcclusion(direct, surface);
  }
  return surface.shading->composed(s, direct.diffuse * diffuse, direct);
}

std::optional<Integrator::Seen> Integrator::firstSeen(Ray ray, Sampler& sampler, bool opaque) const {
  Seen seen;
  const Hit& hit = seen.hit;
  float lastShell = -FAR;
  const float close = scene_.radius * SHELL;
  for (int layer = 0; layer < MAX_LAYERS; ++layer) {
    ++sampler.rays;
    if (!scene_.geometry.intersect(ray, seen.hit)) return std::nullopt;
    const PlacedMesh& mesh = scene_.meshes[hit.mesh];
    const Meeting met = meetingAt(scene_.textures, mesh, hit, ray.direction);
    const bool oneSided = !mesh.material->doubleSided;
    const bool solid = met.shown && !(opaque && transmissionAt(scene_.textures, mesh, hit) > 0);
    if (solid && (met.alpha >= 1 || sampler.random.uniform() < met.alpha)) {
      if (!oneSided || ray.passes == 0 || hit.distance > close) {
        if (hit.distance - lastShell > close) seen.shells = 0;
        return seen;
      }
      --ray.passes;
    } else if (oneSided && !met.front) {
      seen.shells = hit.distance - lastShell <= close ? seen.shells + 1 : 1;
      lastShell = hit.distance;
    }
    ray.from = hit.distance + scene_.radius * 1e-5f;
  }
  return std::nullopt;
}

bool Integrator::intersect(const Ray& ray, const PixelPoint* from, Sampler& sampler, Surface& surface,
                           bool opaque) const {
  const auto seen = firstSeen(ray, sampler, opaque);
  if (!seen) return false;
  const auto footprint = from ? std::optional(from->footprint()) : std::nullopt;
  // In place: to copy a surface takes as long as to read some of its textures.
  static_assert(std::is_trivially_destructible_v<Surface>);
  new (&surface)
      Surface(surfaceAt(scene_.textures, scene_.meshes[seen->hit.mesh], seen->hit, ray,
                        footprint ? &*footprint : nullptr, three_, terms_ ? &*terms_ : nullptr, !transport_.occlusion));
  surface.shells = seen->shells;
  if (!surface.unlit) {
    surface.shading = &brdf_f::shadingVariant(model_, surface.info);
    surface.shading->prepare(surface.info);
  }
  return true;
}

Ray Integrator::spawnRay(const Surface& from, const glm::vec3& direction) const {
  const float side = glm::dot(from.geometricNormal, direction) < 0 ? -1.0f : 1.0f;
  // A ray back to the viewer's side leaves through the shells that the surface was seen through.
  return {from.position + from.geometricNormal * (side * scene_.radius * 1e-5f), direction, 0,
          side > 0 ? from.shells : 0};
}

bool Integrator::occluded(const Ray& ray, float distance, Sampler& sampler) const {
  if (ray.passes == 0 && !blended_) {
    ++sampler.rays;
    return scene_.geometry.occluded(ray, distance);
  }
  const auto seen = firstSeen(ray, sampler, false);
  return seen && seen->hit.distance < distance;
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
  const brdf_f::ShadingVariant& shading = *surface.shading;
  glm::vec3 behind = shading.behind ? scene_.lights.irradiance(-surface.info.n) : glm::vec3(0);
  if (dome != glm::vec3(0) || behind != glm::vec3(0)) {
    brdf_f::Reflected lit = shading.dome(surface.info, dome);
    // Ambient visibility has a value for each side; an occlusion map has one, which darkens both.
    const bool sides = surface.hasVisibility && !transport_.occlusion;
    if (sides) lit = brdf_f::visibleLight(lit, surface.info), behind *= surface.info.visibilityBehind;
    if (shading.behind) lit = shading.behind(lit, surface.info, behind);
    if (!transport_.occlusion) lit = withOcclusionMap(lit, surface);
    sum += shading.composed(surface.info, lit.diffuse * (1 - surface.glass.weight), lit);
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

bool Integrator::hidden(const Surface& surface, const glm::vec3& l, Sampler& sampler) const {
  return transport_.occlusion && occluded(spawnRay(surface, l), FAR, sampler);
}

glm::vec3 Integrator::sampleEnvironment(const Surface& surface, const brdf_f::LobeMixture& lobes,
                                        const SampleCounts& counts, Sampler& sampler) const {
  glm::vec3 sum(0);
  if (!scene_.environment) return sum;
  const EnvironmentLight& environment = *scene_.environment;
  const auto strata = static_cast<float>(counts.strata);
  const auto side = static_cast<std::size_t>(counts.strata);
  const std::size_t count = side * side;
  std::array<glm::vec2, EnvironmentLight::MAX_SAMPLES> us;
  std::array<EnvironmentLight::Sample, EnvironmentLight::MAX_SAMPLES> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 cell(static_cast<int>(i) % counts.strata, static_cast<int>(i) / counts.strata);
    us[i] = (cell + sampler.random.uniform2()) / strata;
  }
  environment.sample(std::span(us).first(count), drawn.data());
  for (std::size_t i = 0; i < count; ++i) {
    const EnvironmentLight::Sample& light = drawn[i];
    if (!(light.pdf > 0)) continue;
    const glm::vec3 f = bsdfCosine(surface, light.direction, true);
    if (f == glm::vec3(0) || hidden(surface, light.direction, sampler)) continue;
    const float misWeight = brdf_f::powerHeuristic(counts.environment() * light.pdf,
                                                   counts.lobe() * surface.shading->pdfMixture(lobes, light.direction));
    sum += f * environment.radiance(light) * (misWeight / light.pdf);
  }
  return sum / counts.environment();
}

glm::vec3 Integrator::sampleLobes(const Surface& surface, const brdf_f::LobeMixture& lobes, const SampleCounts& counts,
                                  Sampler& sampler) const {
  glm::vec3 sum(0);
  if (!scene_.environment) return sum;
  const EnvironmentLight& environment = *scene_.environment;
  for (int i = 0; i < counts.lobes; ++i) {
    const glm::vec3 l = surface.shading->sampleMixture(lobes, sampler.random.uniform2());
    const float pdf = surface.shading->pdfMixture(lobes, l);
    if (!(pdf > 0)) continue;
    const glm::vec3 f = bsdfCosine(surface, l, true);
    if (f == glm::vec3(0)) continue;
    const EnvironmentLight::Place place = environment.find(l);
    if (hidden(surface, l, sampler)) continue;
    const float misWeight = brdf_f::powerHeuristic(counts.lobe() * pdf, counts.environment() * environment.pdf(place));
    sum += f * environment.radiance(place) * (misWeight / pdf);
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
  path.throughput *= path.surface.shading->composed(path.surface.info, sample.share, brdf_f::nothingReflected());
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
  const glm::vec3 l = path.surface.shading->sampleMixture(lobes, sampler.random.uniform2());
  const float pdf = path.surface.shading->pdfMixture(lobes, l);
  if (!(pdf > 0)) return false;
  path.throughput *= bsdfCosine(path.surface, l, true) / (counts.lobe() * pdf);
  if (path.throughput == glm::vec3(0)) return false;
  path.straight = false;
  const EnvironmentLight* environment = scene_.environment;
  const EnvironmentLight::Place place = environment ? environment->find(l) : EnvironmentLight::Place{};
  if (!intersect(spawnRay(path.surface, l), nullptr, sampler, path.surface)) {
    if (!environment) return false;
    const float misWeight = brdf_f::powerHeuristic(counts.lobe() * pdf, counts.environment() * environment->pdf(place));
    path.radiance += path.throughput * environment->radiance(place) * misWeight;
    return false;
  }
  // Russian roulette: a long path ends at random, and those that survive make up for it.
  if (++path.bounces > 2) {
    const float survival = glm::min(brdf_f::max3(path.throughput), 0.95f);
    if (sampler.random.uniform() >= survival) return false;
    path.throughput /= survival;
  }
  return true;
}

glm::vec4 Integrator::follow(Path& path, Sampler& sampler) const {
  for (;;) {
    const Surface& surface = path.surface;
    path.radiance += path.throughput * surface.emitted;
    if (surface.unlit) break;
    brdf_f::LobeMixture lobes;
    surface.shading->lobeMixture(surface.info, lobes);
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

glm::vec4 Integrator::Li(const PixelPoint& from, Sampler& sampler) const {
  const Ray ray = from.ray();
  Path path;
  float distance = FAR;
  glm::vec4 light(0);
  if (intersect(ray, &from, sampler, path.surface)) {
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
