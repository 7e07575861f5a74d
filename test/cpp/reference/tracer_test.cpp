#include "reference/tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <thread>

#include "expect_error.h"
#include "shading_terms.h"

namespace telar::reference::tracer_test {
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
  shot.toneMapping = ToneMapping::kNone;
  shot.camera.projection = Projection::kOrthographic;
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

/// Light that a surface sends to the viewer, by quadrature over the whole sphere of directions.
glm::dvec3 quadrature(const EnvironmentLight& light, const brdf_f::SurfaceInfo& surface, ShadingModel shading) {
  using namespace brdf_f;
  constexpr int ROWS = 360, COLUMNS = 400;
  const ShadingFunctions functions = shadingFunctions(shading);
  const SurfaceInfo s = functions.preparedSurface(surface);
  glm::dvec3 sum(0);
  for (int i = 0; i < ROWS; ++i) {
    for (int j = 0; j < COLUMNS; ++j) {
      const double z = 2 * (i + 0.5) / ROWS - 1, phi = 2 * PI * (j + 0.5) / COLUMNS, r = std::sqrt(1 - z * z);
      const glm::vec3 l(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
      const Reflected lit = functions.addPunctual(nothingReflected(), s, l, light.radiance(l));
      sum += glm::dvec3(functions.composedRadiance(s, lit.diffuse, lit, nothingReflected(), glm::vec3(0)));
    }
  }
  return sum * (4 * PI / (ROWS * COLUMNS));
}

/// Every layer at once.
Material layered() {
  Material coated = cloth(0.6f);
  coated.physical = true;
  coated.layers.clearcoatFactor = 0.7f;
  coated.layers.clearcoatRoughnessFactor = 0.4f;
  coated.layers.sheenColorFactor = {0.3f, 0.4f, 0.5f};
  coated.layers.sheenRoughnessFactor = 0.5f;
  coated.layers.anisotropyStrength = 0.5f;
  return coated;
}

Material thin() {
  Material m = cloth(0.7f);
  m.fabric.diffuseTransmissionFactor = 0.6f;
  return m;
}

/// Silky yarns that lie square to each other.
Material woven() {
  Material m = cloth(0.6f);
  m.fabric.weave = true;
  m.fabric.warp = {0.6f, 0.35f, 0.5f, {1, 0.9f, 0.8f}};
  m.fabric.weft = {0.3f, 0.4f, 0.6f, {0.7f, 0.9f, 1}};
  return m;
}

class ShadingTracer : public testing::TestWithParam<ShadingModel> {};

TEST_P(ShadingTracer, EnvironmentOnAPlaneIsUnbiasedAgainstQuadrature) {
  const ImageF map = sky();
  const EnvironmentLight light(map, 0, 1);
  for (const Material& material : {cloth(1), cloth(0.5f), cloth(0.35f, 1), layered(), thin(), woven()}) {
    for (const double elevation : {85.0, 30.0}) {
      const Scene scene = plane(material);
      Shot shot = shotOf(16, elevation);
      shot.shading = GetParam();
      shot.terms = isPrincipled(shot.shading) ? termsOf(shot.shading) : ShadingTerms();
      const auto pixels = traced(scene, shot, &map, {.samples = 32});
      const double error = spreadOf(pixels) / std::sqrt(static_cast<double>(pixels.size()));
      const auto meshes = placeMeshes(scene, -1, glm::dvec3(0), {}, shot.shading);
      const glm::vec3 v(glm::normalize(shot.camera.position));
      Hit hit;
      const Ray ray{v * 5.0f + glm::vec3(0.01f, 0.02f, 0), -v};
      ASSERT_TRUE(Geometry(meshes).intersect(ray, hit));
      const ShadingTerms* terms = isPrincipled(shot.shading) ? &shot.terms : nullptr;
      const Surface surface = surfaceAt(Textures(scene), meshes[0], hit, ray, nullptr, ThreeTerms{}, terms);
      const glm::dvec3 expected = quadrature(light, surface.info, shot.shading), mean = meanOf(pixels);
      EXPECT_NEAR(mean.y, expected.y, 3 * error + 2e-3 * expected.y) << material.roughnessFactor << " " << elevation;
      EXPECT_LT(error, 0.03 * expected.y) << "too noisy to tell";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ShadingTracer,
                         testing::Values(ShadingModel::kThree, ShadingModel::kThreeR115, ShadingModel::kDisney2012,
                                         ShadingModel::kFabric));

TEST(Tracer, StandardErrorFallsAtLeastWithTheRootOfTheSamples) {
  const ImageF map = sky();
  const Scene scene = plane(cloth(0.5f));
  const double few = spreadOf(traced(scene, shotOf(48), &map, {.samples = 4}));
  const double many = spreadOf(traced(scene, shotOf(48), &map, {.samples = 64}));
  EXPECT_GT(few / many, 3.6);
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

TEST(Tracer, PixelsTakePathsUntilTheirStandardErrorIsTheShots) {
  const ImageF map = sky();
  const Scene scene = plane(cloth(0.5f));
  Shot shot = shotOf(24);
  shot.exposure = 0.5f;
  const auto draw = [&](double noise, std::uint64_t seed, int threads, TraceFacts& facts) {
    shot.noise = noise;
    return traceRadiance(scene, shot, &map, {.samples = 1024, .seed = seed, .threads = threads}, Limits(),
                         CancelToken(), {}, &facts);
  };
  TraceFacts all, strict, loose;
  const auto truth = draw(0, 1, 2, all), sure = draw(1, 2, 2, strict), rough = draw(8, 2, 2, loose);
  EXPECT_EQ(all.samples, 1024);
  EXPECT_LT(loose.samples, strict.samples);
  EXPECT_LT(strict.samples, 1024);
  EXPECT_LT(strict.rays, all.rays);
  // As shown the mean slope of sRGB is near 1 here, so that the standard error of radiance is about noise / 255.
  const auto errorOf = [&](const std::vector<glm::vec4>& pixels) {
    double squares = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) squares += std::pow(shot.exposure * (pixels[i].y - truth[i].y), 2);
    return 255 * std::sqrt(squares / static_cast<double>(pixels.size()));
  };
  EXPECT_LT(errorOf(sure), 1.25);
  EXPECT_GT(errorOf(rough), 1.25) << "the planted fault: it stops too soon";
  EXPECT_NEAR(meanOf(sure).y, meanOf(truth).y, 0.01 * meanOf(truth).y);
  EXPECT_EQ(draw(1, 2, 5, strict), sure) << "with any number of threads";
}

TEST(Tracer, ItIsDoneWhereAllPixelsSettleEarly) {
  const ImageF map = sky();
  Shot shot = shotOf(24);
  for (const double noise : {0.0, 8.0}) {
    shot.noise = noise;
    const Progress progress;
    TraceFacts facts;
    traceRadiance(plane(cloth(0.5f)), shot, &map, {.samples = 256, .threads = 2}, Limits(), CancelToken(), progress,
                  &facts);
    EXPECT_EQ(facts.samples<256, noise> 0) << "the case is one that ends early, and its contrary";
    EXPECT_EQ(progress.part(), 1) << noise;
  }
}

// Rounds for previews begin anywhere: each pixel of each round looks at the token.
TEST(Tracer, IsCancelledBetweenPreviews) {
  const ImageF map = sky();
  const CancelToken cancel;
  const Progress progress;
  progress.previews.ask();
  std::thread watcher([&] {
    while (!progress.previews.take()) std::this_thread::yield();
    cancel.cancel();
  });
  EXPECT_ERROR(
      traceRadiance(plane(cloth(0.5f)), shotOf(160), &map, {.samples = 15, .threads = 1}, Limits(), cancel, progress),
      "X_CANCELLED");
  watcher.join();
}

TEST(Tracer, PunctualLightsAreExact) {
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
  EXPECT_ERROR(traceRadiance(plane(cloth(1)), shotOf(16), nullptr, {.samples = 4, .threads = 3}, Limits(), cancel, {}),
               "X_CANCELLED");
}

TEST(Tracer, ALensBlursWhatIsOutOfFocus) {
  // The edge of a white square before nothing, 5 m away.
  Material white;
  white.unlit = true;
  Shot shot = shotOf(64);
  shot.camera.projection = Projection::kPerspective;
  shot.camera.fovY = 5;
  shot.camera.position = {1, 0, 5}, shot.camera.target = {1, 0, 0};
  const auto halfCovered = [&](std::optional<Shot::Lens> lens) {
    shot.lens = lens;
    int count = 0;
    for (const glm::vec4& p : traced(plane(white), shot, nullptr, {.samples = 64})) count += p.a > 0.02f && p.a < 0.98f;
    return count;
  };
  const int sharp = halfCovered(std::nullopt);
  EXPECT_LE(sharp, 64);
  EXPECT_LE(halfCovered(Shot::Lens{2, {}, {}, 5}), sharp + 64);
  EXPECT_GT(halfCovered(Shot::Lens{2, {}, {}, 2.5}), sharp + 64 * 8);
}

TEST(Tracer, DiskLightsShineAsTheirSolidAngle) {
  const AreaLight disk{true, {0, 0, 2}, {0.7f, 0, 0}, {0, 0.7f, 0}, {0, 0, -1}, glm::vec3(3)};
  Random random(3, 0, 0);
  constexpr int DRAWS = 20000;
  double sum = 0;
  for (int i = 0; i < DRAWS; ++i) {
    const auto arrival = disk.sampleLi(glm::vec3(0), random.uniform2());
    ASSERT_TRUE(arrival);
    sum += arrival->irradiance.x * arrival->direction.z;
  }
  EXPECT_NEAR(sum / DRAWS, PI * 3 * 0.49 / (0.49 + 4), 0.01);
  EXPECT_FALSE(disk.sampleLi(glm::vec3(0, 0, 3), {0.5f, 0.5f})) << "it shines to one side";
}

TEST(Tracer, GlassShowsWhatLiesBehindAndCoversTheRest) {
  Material glass;
  glass.baseColorFactor = {0.5f, 1, 1, 1};
  glass.roughnessFactor = 0;
  glass.metallicFactor = 0;
  glass.physical = true;
  glass.layers.ior = 1;
  glass.layers.transmissionFactor = 1;
  Scene scene = plane(glass);
  Material behind;
  behind.unlit = true;
  behind.baseColorFactor = {0.8f, 0.6f, 0.4f, 1};
  scene.materials.push_back(behind);
  Primitive square = scene.meshes[0].primitives[0];
  square.material = 1;
  scene.meshes.push_back({"behind", {square}});
  Node node = scene.nodes[0];
  node.mesh = 1;
  node.world = glm::translate(glm::dmat4(1), glm::dvec3(-1, 0, -1));  // its right edge in the middle of the picture
  scene.nodes.push_back(node);
  for (const bool occlusion : {false, true}) {
    const auto pixels = traced(scene, shotOf(8), nullptr, {.samples = 256, .transport = {occlusion, 0}});
    const glm::vec4 left = pixels[8 * 4 + 1], right = pixels[8 * 4 + 6];
    EXPECT_NEAR(left.r, 0.4, 0.03);
    EXPECT_NEAR(left.g, 0.6, 0.04);
    EXPECT_NEAR(left.a, 1, 1e-6);
    EXPECT_NEAR(right.a, 1 - (0.5 + 1 + 1) / 3, 0.04);
    EXPECT_NEAR(right.g, 0, 1e-6);
  }
}

TEST(Tracer, TheGroundIsAsDarkAsItsShadow) {
  Material card = cloth(1);
  card.doubleSided = true;
  Scene scene = plane(card);
  scene.nodes[0].world = glm::rotate(glm::dmat4(1), -PI / 2, glm::dvec3(1, 0, 0));  // level, seen from above
  scene.bounds = {{-1, 0, -1}, {1, 0, 1}};
  Shot shot = shotOf(40);
  shot.camera.position = {0, 5, 0}, shot.camera.up = {0, 0, -1}, shot.camera.height = 8;
  shot.ground = Shot::Ground{0.5, {0, -1, 0}, {6, 6}};
  Shot::Light lamp{Shot::Light::Type::kDirectional};
  lamp.position = {-2, 2, 0};  // 45 degrees: the shadow lies 1 m to the right
  lamp.castShadow = true;
  lamp.shadow = {1000, 0, 0.8, 0, 0, 0, 10, -3, 3, -3, 3};
  shot.lights.push_back(lamp);
  const auto pixels = traced(scene, shot, nullptr, {.samples = 8});
  const auto at = [&](double x, double z) {
    return pixels[static_cast<std::size_t>((z + 4) * 5) * 40 + static_cast<std::size_t>((x + 4) * 5)];
  };
  EXPECT_NEAR(at(1.5, 0.1).a, 0.4, 1e-5);
  EXPECT_EQ(glm::vec3(at(1.5, 0.1)), glm::vec3(0));
  EXPECT_EQ(at(-1.5, 0.1).a, 0);
  EXPECT_EQ(at(0.1, 0.1).a, 1) << "the model is before it";
  EXPECT_EQ(at(3.5, 0.1).a, 0) << "it ends";
}

TEST(Tracer, WhatNothingCoversStaysTransparent) {
  Shot shot = shotOf(8);
  shot.camera.height = 8;
  const auto pixels = traced(plane(cloth(1)), shot, nullptr, {.samples = 4});
  EXPECT_EQ(pixels[0], glm::vec4(0));
  EXPECT_EQ(pixels[8 * 4 + 4].a, 1);
}

}  // namespace
}  // namespace telar::reference::tracer_test
