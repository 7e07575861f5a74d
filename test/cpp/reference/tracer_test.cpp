#include "reference/tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "ibl/dfg_lookup.h"

namespace telar::reference {
namespace {

constexpr double PI = 3.14159265358979;

/// A square of 2 m in z = 0 that faces +Z, and a camera that sees nothing else.
Scene plane(const Material& material) {
  Primitive square;
  square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  square.indices = {0, 1, 2, 0, 2, 3};
  square.material = 0;
  Scene scene;
  scene.meshes.push_back({"plane", {square}});
  scene.materials.push_back(material);
  Node node;
  node.mesh = 0;
  scene.nodes.push_back(node);
  scene.bounds = {{-1, -1, 0}, {1, 1, 0}};
  return scene;
}

Shot shotOf(int size, double elevation = 90) {
  Shot shot;
  shot.width = shot.height = size;
  shot.toneMapping = "none";
  shot.camera.perspective = false;
  shot.camera.height = 0.1;
  shot.camera.near = 0.1;
  shot.camera.far = 20;
  const double angle = glm::radians(elevation);
  shot.camera.position = {5 * std::cos(angle), 0, 5 * std::sin(angle)};
  shot.camera.target = {0, 0, 0};
  shot.output.format = OutputOptions::Format::kRaw;
  shot.output.bitDepth = 32;
  return shot;
}

Material cloth(float roughness, float metallic = 0) {
  Material m;
  m.baseColorFactor = {0.8f, 0.4f, 0.2f, 1};
  m.roughnessFactor = roughness;
  m.metallicFactor = metallic;
  return m;
}

/// Brighter upwards and to one side.
ImageF sky() {
  ImageF map{32, 16, std::vector<float>(32 * 16 * 4, 1.0f)};
  for (std::size_t y = 0; y < 16; ++y) {
    for (std::size_t x = 0; x < 32; ++x) {
      float* p = &map.pixels[(y * 32 + x) * 4];
      p[0] = 0.2f + 0.05f * static_cast<float>(16 - y);
      p[1] = x > 20 && x < 24 && y == 5 ? 20.0f : 0.3f;
      p[2] = 0.1f * static_cast<float>(x % 8);
    }
  }
  return map;
}

glm::dvec3 meanOf(const std::vector<glm::vec4>& pixels) {
  glm::dvec3 sum(0);
  for (const glm::vec4& p : pixels) sum += glm::dvec3(p);
  return sum / static_cast<double>(pixels.size());
}

double spreadOf(const std::vector<glm::vec4>& pixels) {
  const double mean = meanOf(pixels).y;
  double squares = 0;
  for (const glm::vec4& p : pixels) squares += (p.y - mean) * (p.y - mean);
  return std::sqrt(squares / static_cast<double>(pixels.size()));
}

std::vector<glm::vec4> traced(const Scene& scene, const Shot& shot, const ImageF* map, const TraceOptions& options) {
  return traceRadiance(scene, shot, map, options, Limits(), CancelToken(), {});
}

/// Light that a surface facing +Z sends to the viewer, by quadrature over the whole sphere of directions.
glm::dvec3 quadrature(const EnvironmentLight& light, const Surface& surface) {
  using namespace brdf_f;
  constexpr int ROWS = 500, COLUMNS = 1000;
  glm::dvec3 sum(0);
  for (int i = 0; i < ROWS; ++i) {
    for (int j = 0; j < COLUMNS; ++j) {
      const double z = (i + 0.5) / ROWS, phi = 2 * PI * (j + 0.5) / COLUMNS, r = std::sqrt(1 - z * z);
      const glm::vec3 l(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
      const Reflected lit =
          three::addPunctual(nothingReflected(), three::preparedSurface(surface.info), l, light.radiance(l));
      sum += glm::dvec3(three::composedRadiance(surface.info, lit.diffuse, lit, nothingReflected(), glm::vec3(0)));
    }
  }
  return sum * (2 * PI / (ROWS * COLUMNS));
}

TEST(Tracer, EnvironmentOnAPlaneIsUnbiasedAgainstQuadrature) {
  const ImageF map = sky();
  Material coated = cloth(0.6f);
  coated.physical = true;
  coated.layers.clearcoatFactor = 0.7f;
  coated.layers.clearcoatRoughnessFactor = 0.4f;
  coated.layers.sheen = true;
  coated.layers.sheenColorFactor = {0.3f, 0.4f, 0.5f};
  coated.layers.sheenRoughnessFactor = 0.5f;
  coated.layers.anisotropyStrength = 0.5f;
  for (const Material& material : {cloth(1), cloth(0.5f), cloth(0.3f, 1), coated}) {
    for (const double elevation : {85.0, 30.0}) {
      const Scene scene = plane(material);
      const Shot shot = shotOf(24, elevation);
      const auto pixels = traced(scene, shot, &map, {.samples = 256});
      const double error = spreadOf(pixels) / std::sqrt(static_cast<double>(pixels.size()));
      const auto meshes = placeMeshes(scene, -1, glm::dvec3(0));
      const glm::vec3 v(glm::normalize(shot.camera.position));
      Hit hit;
      const Ray ray{v * 5.0f + glm::vec3(0.01f, 0.02f, 0), -v};
      ASSERT_TRUE(Geometry(meshes).intersect(ray, hit));
      const EnvironmentLight light(map, 0, 1);
      const Surface surface = surfaceAt(scene, meshes[0], hit, ray, nullptr, ibl::dfgLookup);
      const glm::dvec3 expected = quadrature(light, surface), mean = meanOf(pixels);
      EXPECT_NEAR(mean.y, expected.y, 3 * error + 2e-3 * expected.y) << material.roughnessFactor << " " << elevation;
    }
  }
}

TEST(Tracer, StandardErrorFallsWithTheRootOfTheSamples) {
  const ImageF map = sky();
  const Scene scene = plane(cloth(0.5f));
  const double few = spreadOf(traced(scene, shotOf(48), &map, {.samples = 4}));
  const double many = spreadOf(traced(scene, shotOf(48), &map, {.samples = 64}));
  EXPECT_NEAR(few / many, 4, 0.4);
}

TEST(Tracer, TheSeedGivesTheBytesWithAnyNumberOfThreads) {
  const ImageF map = sky();
  const Scene scene = plane(cloth(0.5f));
  Shot shot = shotOf(24);
  shot.output = {};
  const auto frame = [&](std::uint64_t seed, int threads) {
    return trace(scene, shot, &map, {.samples = 8, .seed = seed, .threads = threads}, Limits(), CancelToken(), {})
        .pixels;
  };
  const auto first = frame(7, 1);
  EXPECT_EQ(first, frame(7, 2));
  EXPECT_EQ(first, frame(7, 5));
  EXPECT_NE(first, frame(8, 1));
}

TEST(Tracer, PointedLightsAreExact) {
  Shot shot = shotOf(4);
  Shot::Light sun{Shot::Light::Type::kDirectional};
  sun.position = {0, 1, 1};
  sun.intensity = PI;
  shot.lights.push_back(sun);
  Material white = cloth(1);
  white.baseColorFactor = glm::vec4(1);
  const auto pixels = traced(plane(white), shot, nullptr, {.samples = 1});
  // cos 45 degrees of a Lambert white less its Fresnel share, and a little of the rough specular lobe.
  EXPECT_NEAR(pixels[0].x, std::cos(PI / 4), 0.02);
  EXPECT_EQ(pixels[0], pixels[15]);
}

TEST(Tracer, OcclusionDarkensAndBouncesBrighten) {
  // Two squares that meet at a right angle, under an even sky.
  Material white = cloth(1);
  white.baseColorFactor = glm::vec4(0.9f, 0.9f, 0.9f, 1);
  white.doubleSided = true;
  Scene scene = plane(white);
  Node wall = scene.nodes[0];
  wall.world =
      glm::translate(glm::dmat4(1), glm::dvec3(0.1, 0, 1)) * glm::rotate(glm::dmat4(1), PI / 2, glm::dvec3(0, 1, 0));
  scene.nodes.push_back(wall);
  const ImageF even{4, 2, std::vector<float>(32, 1.0f)};
  const Shot shot = shotOf(8);
  const double open = meanOf(traced(scene, shot, &even, {.samples = 64})).x;
  const double hidden = meanOf(traced(scene, shot, &even, {.samples = 64, .transport = {true, 0}})).x;
  const double lit = meanOf(traced(scene, shot, &even, {.samples = 64, .transport = {true, 4}})).x;
  EXPECT_LT(hidden, open * 0.75);
  EXPECT_GT(lit, hidden * 1.1);
  EXPECT_LT(lit, open);
}

TEST(Tracer, ACancelledTraceThrowsAndItsThreadsEnd) {
  CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(traceRadiance(plane(cloth(1)), shotOf(16), nullptr, {.samples = 4, .threads = 3}, Limits(), cancel, {}),
               Error);
}

TEST(Tracer, WhatNothingCoversStaysTransparent) {
  Shot shot = shotOf(8);
  shot.camera.height = 8;
  const auto pixels = traced(plane(cloth(1)), shot, nullptr, {.samples = 4});
  EXPECT_EQ(pixels[0], glm::vec4(0));
  EXPECT_EQ(pixels[8 * 4 + 4].a, 1);
}

}  // namespace
}  // namespace telar::reference
