// Woven cloth of any yarns as the renderer draws it, under a sky of radiance 1.
#include <algorithm>

#include "albedo.h"
#include "checks.h"
#include "frames.h"
#include "shading_terms.h"
#include "weaves.h"
#include "worst.h"

namespace telar::numerics {
namespace {

constexpr int SIDE = 8;    ///< patches on a side
constexpr int PIXELS = 8;  ///< of a patch; the outer ones are not read

/// A square of the picture that shows a plane from the side that the weave is seen from. A parallel view along -z:
/// every pixel of it has the same directions.
Primitive patch(const Directions& seen, const glm::dvec2& centre) {
  const double sine = std::sqrt(1 - seen.NoV * seen.NoV);
  const glm::dvec3 v(sine * std::cos(seen.turn), sine * std::sin(seen.turn), seen.NoV);
  // Its rows are axes of the surface in the world: the viewer, +z, is v to it.
  const glm::dmat3 axes = glm::dmat3(brdf_d::basisAbout(v)), surface = glm::transpose(axes);
  const glm::dvec3 n = surface[2];
  Primitive p;
  for (const glm::dvec2& corner : {glm::dvec2(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const glm::dvec3 at(corner, -(n.x * corner.x + n.y * corner.y) / n.z);
    const glm::dvec3 local = glm::transpose(surface) * at;
    p.positions.push_back(glm::vec3(at + glm::dvec3(centre, 0)));
    p.normals.push_back(glm::vec3(n));
    p.uvs[0].push_back(glm::vec2(local.x, local.y));
    p.bounds.add(glm::dvec3(p.positions.back()));
  }
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

glm::dvec2 centreOf(std::uint64_t index) {
  const double x = static_cast<double>(index % SIDE), y = static_cast<double>(index / SIDE);
  return {x - SIDE / 2.0 + 0.5, SIDE / 2.0 - 0.5 - y};
}

std::shared_ptr<Scene> patches(std::uint64_t count) {
  auto scene = std::make_shared<Scene>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const SeenWeave weave = randomWeave(i);
    Primitive p = patch(weave.seen, centreOf(i));
    p.material = static_cast<int>(i);
    scene->bounds.add(p.bounds.min);
    scene->bounds.add(p.bounds.max);
    scene->materials.push_back(weave.material);
    scene->meshes.push_back({"patch", {std::move(p)}});
    Node node;
    node.mesh = static_cast<int>(i);
    scene->nodes.push_back(node);
  }
  return scene;
}

Shot shotOfPatches(ShadingModel shading) {
  constexpr double FAR = 100;  // a patch seen at a cosine of 0.02 reaches 35 m either way
  Shot shot = test::shotOf(SIDE * PIXELS);
  shot.camera.projection = Projection::kOrthographic;
  shot.camera.height = SIDE;
  shot.camera.position = {0, 0, FAR};
  shot.camera.near = FAR / 2;
  shot.camera.far = 2 * FAR;
  shot.shading = shading;
  shot.terms = termsOf(shading);
  shot.output.bitDepth = 32;
  shot.samples = 1;
  shot.environment.source = Shot::Environment::Source::kBytes;
  return shot;
}

/// Mean of the green channel over the inner pixels of a patch.
double meanOf(const Frame& frame, std::uint64_t index) {
  double sum = 0;
  for (int y = 1; y < PIXELS - 1; ++y) {
    for (int x = 1; x < PIXELS - 1; ++x) {
      const auto column = static_cast<std::uint32_t>(index % SIDE * PIXELS) + static_cast<std::uint32_t>(x);
      const auto row = static_cast<std::uint32_t>(index / SIDE * PIXELS) + static_cast<std::uint32_t>(y);
      sum += test::pixelF(frame, column, row)[1];
    }
  }
  return sum / ((PIXELS - 2) * (PIXELS - 2));
}

}  // namespace

std::vector<Figure> checkWeavesDrawn(const ShadingPromise& shading, Scale scale) {
  constexpr std::uint64_t FULL = 60;
  const std::uint64_t count = scale == Scale::kFull ? FULL : 16;
  const auto renderer = makeRenderer();
  const auto scene = patches(count);
  Shot shot = shotOfPatches(shading.model);
  const Frame prefiltered = drawn(*renderer, scene, shot, evenSky());
  shot.samples = scale == Scale::kFull ? 256 : 64;
  shot.environmentSamples = 32 * shot.samples;
  shot.resolve = Resolve::kLinear;
  const Frame sampled = drawn(*renderer, scene, shot, evenSky());

  Worst mostPrefiltered, mostSampled, apartPrefiltered, apartSampled;
  double least = 1e9;
  std::uint64_t leastAt = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const SeenWeave weave = randomWeave(i);
    const Shaded<double> exact(shading.model, inDouble(pointOn(shading.model, weave.material, weave.seen).info));
    const double even = meanOf(prefiltered, i), directions = meanOf(sampled, i);
    mostPrefiltered.see(even, i);
    mostSampled.see(directions, i);
    apartPrefiltered.see(std::abs(even - exact.environment().y), i);
    apartSampled.see(std::abs(directions - directAlbedo(exact, 1 << 14)), i);
    if (!(std::min(even, directions) / weave.coverage() >= least))
      least = std::min(even, directions) / weave.coverage(), leastAt = i;
  }
  std::vector<Figure> out;
  const auto add = [&](const char* what, double value, double high, double low, std::uint64_t at) {
    out.push_back({what, shading.name, value, high, low, count,
                   "weave " + std::to_string(at) + ": " + describe(randomWeave(at)), FULL});
  };
  add("weaves drawn with the prefiltered environment: most", mostPrefiltered.value, 1.005, -NO_BAR,
      mostPrefiltered.point);
  add("weaves drawn with directions: most", mostSampled.value, 1.005, -NO_BAR, mostSampled.point);
  add("weaves drawn: least, of what the yarns cover", least, NO_BAR, 0.90, leastAt);
  // A prefiltered map holds halves: a step of 1 / 2048.
  add("weaves drawn with the prefiltered environment: largest difference from double", apartPrefiltered.value, 1e-3,
      -NO_BAR, apartPrefiltered.point);
  // What is left of the noise of 36 pixels.
  add("weaves drawn with directions: largest difference from double", apartSampled.value, 0.01, -NO_BAR,
      apartSampled.point);
  return out;
}

}  // namespace telar::numerics
