#include "reference/integrator.h"

#include <algorithm>
#include <limits>
#include <new>
#include <type_traits>

namespace telar::reference {
namespace {

constexpr int MAX_LAYERS = 256;  ///< transparent surfaces that one ray passes
constexpr float FAR = std::numeric_limits<float>::infinity();

}  // namespace

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

std::optional<Hit> Integrator::nearest(const Ray& ray, Sampler& sampler) const {
  ++sampler.rays;
  Hit hit;
  return scene_.geometry.intersect(ray, hit) ? std::optional(hit) : std::nullopt;
}

std::optional<Integrator::Seen> Integrator::firstSeen(const Ray& ray, Sampler& sampler, bool opaque) const {
  return firstSeen(ray, nearest(ray, sampler), sampler, opaque);
}

std::optional<Integrator::Seen> Integrator::firstSeen(Ray ray, std::optional<Hit> hit, Sampler& sampler,
                                                      bool opaque) const {
  int shells = 0;
  float lastShell = -FAR;
  const float close = scene_.radius * SHELL;
  for (int layer = 1; hit; ++layer, hit = nearest(ray, sampler)) {
    const PlacedMesh& mesh = scene_.meshes[hit->mesh];
    const Meeting met = meetingAt(scene_.textures, mesh, *hit, ray.direction);
    const bool oneSided = !mesh.material->doubleSided;
    const bool solid = met.shown && !(opaque && transmissionAt(scene_.textures, mesh, *hit) > 0);
    if (solid && (met.alpha >= 1 || sampler.random.uniform() < met.alpha)) {
      if (!oneSided || ray.passes == 0 || hit->distance > close)
        return Seen{*hit, hit->distance - lastShell > close ? 0 : shells};
      --ray.passes;
    } else if (oneSided && !met.front) {
      shells = hit->distance - lastShell <= close ? shells + 1 : 1;
      lastShell = hit->distance;
    }
    if (layer == MAX_LAYERS) break;
    ray.from = hit->distance + scene_.radius * 1e-5f;
  }
  return std::nullopt;
}

void Integrator::read(const Seen& seen, const Ray& ray, const PixelPoint* from, Surface& surface) const {
  const auto footprint = from ? std::optional(from->footprint()) : std::nullopt;
  // In place: to copy a surface takes as long as to read some of its textures.
  static_assert(std::is_trivially_destructible_v<Surface>);
  new (&surface)
      Surface(surfaceAt(scene_.textures, scene_.meshes[seen.hit.mesh], seen.hit, ray, footprint ? &*footprint : nullptr,
                        three_, terms_ ? &*terms_ : nullptr, !transport_.occlusion));
  surface.shells = seen.shells;
  if (surface.unlit) return;
  surface.shading = &brdf_f::shadingVariant(model_, surface.info);
  surface.shading->prepare(surface.info);
}

bool Integrator::intersect(const Ray& ray, Sampler& sampler, Surface& surface, bool opaque) const {
  const auto seen = firstSeen(ray, sampler, opaque);
  if (seen) read(*seen, ray, nullptr, surface);
  return seen.has_value();
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

bool Integrator::hidden(const Surface& surface, const glm::vec3& l, Sampler& sampler) const {
  return transport_.occlusion && occluded(spawnRay(surface, l), FAR, sampler);
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

}  // namespace telar::reference
