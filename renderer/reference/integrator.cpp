#include "reference/integrator.h"

#include <limits>

#include "reference/sampling.h"

namespace telar::reference {
namespace {

constexpr int MOST_LAYERS = 256;   ///< of transparent surfaces that one ray passes
constexpr int MOST_PASSAGES = 64;  ///< through transmissive surfaces, of one path
constexpr float FAR = std::numeric_limits<float>::infinity();

/// Within this part of the scene's radius two surfaces are shells of one cloth: 5 to 10 mm of a garment.
constexpr float CLOSE = 0.02f;

}  // namespace

struct Integrator::Path {
  Surface surface;
  glm::vec3 light{0}, throughput{1};
  float coverage = 1;    ///< of the picture by what the path met
  bool straight = true;  ///< nothing has reflected it yet: what it does not meet is the background
  int bounces = 0, passages = 0;
};

Integrator::Integrator(const Stage& stage, Transport transport, ShadingModel shading, const ShadingTerms& terms,
                       glm::vec2 (*dfg)(float, float))
    : stage_(stage),
      transport_{transport.occlusion, transport.occlusion ? transport.bounces : 0},
      shading_(brdf_f::shadingFunctions(shading)),
      terms_(isPrincipled(shading) ? std::optional(terms) : std::nullopt),
      dfg_(dfg) {}

brdf_f::Reflected Integrator::baked(brdf_f::Reflected light, const Surface& surface) const {
  if (transport_.occlusion || surface.occlusion >= 1) return light;
  light.diffuse *= surface.occlusion;
  light.coat *= surface.occlusion;
  light.sheen *= surface.occlusion;
  light.specular *= brdf_f::specularOcclusion(surface.info.perceptualRoughness, surface.occlusion, surface.info.NoV);
  return light;
}

glm::vec3 Integrator::reflected(const Surface& surface, const glm::vec3& l, bool around) const {
  // Half of the environment's light comes from behind most cloth: nothing to ask there.
  const brdf_f::SurfaceInfo& s = surface.info;
  const bool behind = glm::dot(s.n, l) <= 0 && glm::dot(s.coatNormal, l) <= 0;
  if (behind && s.diffuseTransmission == 0) return glm::vec3(0);
  brdf_f::Reflected direct = shading_.addPunctual(brdf_f::nothingReflected(), surface.info, l, glm::vec3(1));
  if (around) direct = baked(direct, surface);
  return shading_.composedRadiance(surface.info, direct.diffuse * (1 - surface.glass.weight), direct,
                                   brdf_f::nothingReflected(), glm::vec3(0));
}

bool Integrator::nextSurface(Ray ray, const Footprint* footprint, Walk& walk, Surface& surface, bool opaque) const {
  Hit hit;
  int shells = 0;
  float lastShell = -FAR;
  const float close = stage_.radius * CLOSE;
  for (int layer = 0; layer < MOST_LAYERS; ++layer) {
    ++walk.rays;
    if (!stage_.geometry.intersect(ray, hit)) return false;
    surface =
        surfaceAt(stage_.textures, stage_.meshes[hit.mesh], hit, ray, footprint, dfg_, terms_ ? &*terms_ : nullptr);
    const bool oneSided = !stage_.meshes[hit.mesh].material->doubleSided;
    const bool solid = surface.shown && !(opaque && surface.glass.weight > 0);
    if (solid && (surface.alpha >= 1 || walk.random.uniform() < surface.alpha)) {
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
    ray.from = hit.distance + stage_.radius * 1e-5f;
  }
  return false;
}

Ray Integrator::leave(const Surface& from, const glm::vec3& direction) const {
  const float side = glm::dot(from.geometricNormal, direction) < 0 ? -1.0f : 1.0f;
  // The way back to where it was seen from leads out of the shells that it was seen through.
  return {from.position + from.geometricNormal * (side * stage_.radius * 1e-5f), direction, 0,
          side > 0 ? from.shells : 0};
}

bool Integrator::hidden(const Ray& ray, float distance, Walk& walk) const {
  Surface blocker;
  return nextSurface(ray, nullptr, walk, blocker) && blocker.distance < distance;
}

glm::vec3 Integrator::arriving(const Surface& surface, const PointedLight::Arrival& arrival, float shadow,
                               Walk& walk) const {
  const glm::vec3 share = reflected(surface, arrival.direction, false) * arrival.irradiance;
  const float taken = transport_.occlusion ? 1.0f : shadow;
  if (share == glm::vec3(0) || taken == 0) return share;
  return hidden(leave(surface, arrival.direction), arrival.distance, walk) ? share * (1 - taken) : share;
}

glm::vec3 Integrator::directLight(const Surface& surface, Walk& walk) const {
  glm::vec3 sum(0);
  for (const PointedLight& light : stage_.lights.pointed) {
    if (const auto arrival = light.at(surface.position)) sum += arriving(surface, *arrival, light.shadow, walk);
  }
  for (const AreaLight& light : stage_.lights.areas) {
    const auto arrival = light.at(surface.position, walk.random.uniform2());
    if (arrival) sum += arriving(surface, *arrival, 0, walk);
  }
  const glm::vec3 dome = stage_.lights.irradiance(surface.info.n);
  const glm::vec3 behind = shading_.addBehind ? stage_.lights.irradiance(-surface.info.n) : glm::vec3(0);
  if (dome != glm::vec3(0) || behind != glm::vec3(0)) {
    brdf_f::Reflected lit = shading_.addDome(brdf_f::nothingReflected(), surface.info, dome);
    if (shading_.addBehind) lit = shading_.addBehind(lit, surface.info, behind);
    lit = baked(lit, surface);
    sum += shading_.composedRadiance(surface.info, lit.diffuse * (1 - surface.glass.weight), brdf_f::nothingReflected(),
                                     lit, glm::vec3(0));
  }
  return sum;
}

Integrator::Draws Integrator::drawsAt(const Path& path, float share) const {
  // Where the picture looks, reading the surface costs more than asking it again: several draws, spread evenly.
  const bool first = path.bounces == 0 && path.passages == 0;
  if (!first) return {1, 1, share};
  if (!transport_.occlusion) return {2, 2, share};
  return {2, transport_.bounces == 0 ? 3 : 1, share};
}

glm::vec3 Integrator::environmentLight(const Surface& surface, const LobeSampler& lobes, const Draws& draws,
                                       Walk& walk) const {
  glm::vec3 sum(0);
  if (!stage_.environment) return sum;
  const auto strata = static_cast<float>(draws.strata);
  for (int i = 0; i < draws.strata * draws.strata; ++i) {
    const glm::vec2 cell(i % draws.strata, i / draws.strata);
    const auto drawn = stage_.environment->sample((cell + walk.random.uniform2()) / strata);
    if (!(drawn.pdf > 0)) continue;
    const glm::vec3 light = reflected(surface, drawn.direction, true);
    if (light == glm::vec3(0)) continue;
    if (transport_.occlusion && hidden(leave(surface, drawn.direction), FAR, walk)) continue;
    const float weight = powerHeuristic(draws.environment() * drawn.pdf, draws.lobe() * lobes.pdf(drawn.direction));
    sum += light * stage_.environment->radiance(drawn.direction) * (weight / drawn.pdf);
  }
  return sum / draws.environment();
}

glm::vec3 Integrator::lobeLight(const Surface& surface, const LobeSampler& lobes, const Draws& draws,
                                Walk& walk) const {
  glm::vec3 sum(0);
  if (!stage_.environment) return sum;
  for (int i = 0; i < draws.lobes; ++i) {
    const auto drawn = lobes.sample(walk.random);
    if (!(drawn.pdf > 0)) continue;
    const glm::vec3 light = reflected(surface, drawn.direction, true);
    if (light == glm::vec3(0)) continue;
    if (transport_.occlusion && hidden(leave(surface, drawn.direction), FAR, walk)) continue;
    const float weight =
        powerHeuristic(draws.lobe() * drawn.pdf, draws.environment() * stage_.environment->pdf(drawn.direction));
    sum += light * stage_.environment->radiance(drawn.direction) * (weight / drawn.pdf);
  }
  return sum / draws.lobe();
}

bool Integrator::behind(const Surface& surface, const Passage& passage, Walk& walk, Surface& next) const {
  const float length = glm::length(passage.path);
  if (length == 0) return nextSurface(leave(surface, passage.direction), nullptr, walk, next, !transport_.occlusion);
  const glm::vec3 exit = surface.position + passage.path;
  if (!transport_.occlusion) {
    // As in the raster: what the viewer would see where the light leaves. Of several layers of glass the first alone
    // counts.
    return nextSurface({exit - passage.direction * (surface.distance + length), passage.direction}, nullptr, walk, next,
                       true);
  }
  if (nextSurface(leave(surface, passage.path / length), nullptr, walk, next) && next.distance < length) return true;
  return nextSurface({exit, passage.direction}, nullptr, walk, next);
}

bool Integrator::passThrough(Path& path, Walk& walk) const {
  if (++path.passages > MOST_PASSAGES) return false;
  const Passage passage = drawPassage(path.surface, walk.random);
  const brdf_f::Reflected none = brdf_f::nothingReflected();
  path.throughput *= shading_.composedRadiance(path.surface.info, passage.share, none, none, glm::vec3(0));
  Surface next;
  if (behind(path.surface, passage, walk, next)) {
    path.surface = next;
    return true;
  }
  if (!path.straight) {
    if (stage_.environment) path.light += path.throughput * stage_.environment->radiance(passage.direction);
  } else if (stage_.sky.shown()) {
    path.light += path.throughput * stage_.sky.radiance(passage.direction, walk.random);
  } else if (stage_.sky.color()) {
    path.light += path.throughput * *stage_.sky.color();
  } else {
    path.coverage = 1 - (path.throughput.r + path.throughput.g + path.throughput.b) / 3;
  }
  return false;
}

bool Integrator::reflect(Path& path, const LobeSampler& lobes, const Draws& draws, Walk& walk) const {
  if (path.bounces == transport_.bounces) {
    path.light += path.throughput * lobeLight(path.surface, lobes, draws, walk);
    return false;
  }
  const auto drawn = lobes.sample(walk.random);
  if (!(drawn.pdf > 0)) return false;
  path.throughput *= reflected(path.surface, drawn.direction, true) / (draws.lobe() * drawn.pdf);
  if (path.throughput == glm::vec3(0)) return false;
  path.straight = false;
  Surface next;
  if (!nextSurface(leave(path.surface, drawn.direction), nullptr, walk, next)) {
    if (!stage_.environment) return false;
    const float weight =
        powerHeuristic(draws.lobe() * drawn.pdf, draws.environment() * stage_.environment->pdf(drawn.direction));
    path.light += path.throughput * stage_.environment->radiance(drawn.direction) * weight;
    return false;
  }
  // Russian roulette: long paths end by chance and the others stand for them.
  if (++path.bounces > 2) {
    const float going = glm::min(brdf_f::max3(path.throughput), 0.95f);
    if (walk.random.uniform() >= going) return false;
    path.throughput /= going;
  }
  path.surface = next;
  return true;
}

glm::vec4 Integrator::pathLight(Path& path, Walk& walk) const {
  for (;;) {
    const Surface& surface = path.surface;
    path.light += path.throughput * surface.emitted;
    if (surface.unlit) break;
    const LobeSampler lobes(surface.info);
    // What comes through takes the place of the diffuse lobe alone: some paths are left for the others.
    const float through = surface.glass.weight * 0.75f;
    const Draws draws = drawsAt(path, 1 - through);
    path.light += path.throughput * (directLight(surface, walk) + environmentLight(surface, lobes, draws, walk));
    if (through > 0 && walk.random.uniform() < through) {
      path.throughput *= surface.glass.weight / through;
      if (!passThrough(path, walk)) break;
    } else if (!reflect(path, lobes, draws, walk)) {
      break;
    }
  }
  return {path.light, path.coverage};
}

glm::vec4 Integrator::radiance(const Ray& ray, const Footprint& footprint, Walk& walk) const {
  Path path;
  const bool found = nextSurface(ray, &footprint, walk, path.surface);
  const float distance = found ? path.surface.distance : FAR;
  glm::vec4 light(0);
  if (found) {
    light = pathLight(path, walk);
  } else if (stage_.sky.shown()) {
    light = glm::vec4(stage_.sky.radiance(ray.direction, walk.random), 1);
  }
  const auto ground = stage_.ground ? stage_.ground->distance(ray) : std::nullopt;
  if (!ground || *ground >= distance) return light;
  const float dark = stage_.ground->opacity(ray, *ground, walk.random,
                                            [&](const Ray& towards, float far) { return hidden(towards, far, walk); });
  return {glm::vec3(light) * (1 - dark), 1 - (1 - light.a) * (1 - dark)};
}

}  // namespace telar::reference
