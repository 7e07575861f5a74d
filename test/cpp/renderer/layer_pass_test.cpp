#include "pass/layer/layer_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scenes.h"

namespace telar::layer_pass_test {
namespace {

using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;
using test::stackedSquares;

constexpr int SIZE = 33;  // odd, so that a pixel's centre is the picture's

/// One layer of floats, whose pixels are seen along known rays.
struct Drawn {
  std::vector<float> pixels;
  std::size_t channels;

  const float* at(int x, int y) const { return &pixels[channels * static_cast<std::size_t>(y * SIZE + x)]; }
};

Drawn drawn(const std::shared_ptr<Scene>& scene, Layer layer) {
  Shot shot = shotOf(SIZE);
  shot.samples = 1;
  shot.output.bitDepth = 32;
  shot.layers = {layer};
  FrameInfo info;
  const Frame frame = Renderer::create({})->draw(scene, shot, {}, CancelToken(), info);
  EXPECT_EQ(frame.layers.size(), 1u);
  const std::vector<float>& pixels = frame.layers.at(0).pixels;
  return {pixels, pixels.size() / (SIZE * SIZE)};
}

/// From shotOf()'s camera, 5 m before the middle, through the centre of a pixel; one metre nearer to the model along
/// the view for each metre of it.
glm::dvec3 rayOf(int x, int y) {
  const double slope = std::tan(glm::radians(15.0));
  return {(2 * (x + 0.5) / SIZE - 1) * slope, (1 - 2 * (y + 0.5) / SIZE) * slope, -1};
}
constexpr glm::dvec3 CAMERA{0, 0, 5};

/// Square of 6 m, which fills the picture, turned about the vertical, moved along the view.
std::shared_ptr<Scene> squareAt(double degrees, double z) {
  auto scene = sceneOf(stackedSquares(1));
  glm::dmat4 world = glm::translate(glm::dmat4(1), {0, 0, z});
  world = glm::rotate(world, glm::radians(degrees), {0, 1, 0});
  scene->nodes[0].world = glm::scale(world, glm::dvec3(1.5));
  return scene;
}

/// Greatest difference of the depths from those of a plane through (0, 0, z), metres.
double worstDepth(const Drawn& depth, double degrees, double z) {
  const glm::dvec3 normal(std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees)));
  double worst = 0;
  for (int y = 0; y < SIZE; ++y) {
    for (int x = 0; x < SIZE; ++x) {
      const double along = glm::dot(normal, glm::dvec3(0, 0, z) - CAMERA) / glm::dot(normal, rayOf(x, y));
      worst = std::max(worst, std::abs(depth.at(x, y)[0] - along));
    }
  }
  return worst;
}

TEST(LayerPass, TheDepthOfAPlaneIsThatAlongTheView) {
  // A float of 5 m is rounded by 2.4e-7 m; the depth goes through a product with a matrix and an interpolation, of some
  // roundings each.
  constexpr double ROUNDING = 4e-6;
  const Drawn facing = drawn(squareAt(0, 0.25), Layer::kDepth);
  EXPECT_LT(worstDepth(facing, 0, 0.25), ROUNDING);
  EXPECT_GT(worstDepth(facing, 0, 0.2501), ROUNDING) << "planted: a plane a tenth of a millimetre nearer";
  // Corners of triangles snap to 1/256 of a pixel: on a plane that is turned by 40 degrees, where a pixel is 0.08 m
  // across, that is 0.08 / 256 * tan(40) m along the view at the most.
  constexpr double SNAP = 0.08 / 256 * 0.84;
  const Drawn turned = drawn(squareAt(40, 0), Layer::kDepth);
  EXPECT_LT(worstDepth(turned, 40, 0), SNAP);
  EXPECT_GT(worstDepth(turned, 41, 0), SNAP) << "planted: a plane that is turned by a degree more";
  EXPECT_GT(worstDepth(turned, -40, 0), 0.5) << "planted: turned the other way";
}

/// Greatest component by which normals differ from those of a sphere about a place, where it is seen from before it.
double worstNormal(const Drawn& normals, const glm::dvec3& centre, double radius) {
  double worst = 0;
  int seen = 0;
  for (int y = 0; y < SIZE; ++y) {
    for (int x = 0; x < SIZE; ++x) {
      const glm::dvec3 ray = glm::normalize(rayOf(x, y)), from = CAMERA - centre;
      const double b = glm::dot(ray, from), d = b * b - glm::dot(from, from) + radius * radius;
      if (d <= 0) continue;
      const glm::dvec3 normal = (from + ray * (-b - std::sqrt(d))) / radius;
      if (glm::dot(normal, -ray) < 0.5) continue;
      ++seen;
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(normals.at(x, y)[c] - normal[c]));
    }
  }
  EXPECT_GT(seen, 100);
  return worst;
}

TEST(LayerPass, TheNormalOfASphereIsThatOfTheSphere) {
  // A mesh of 256 rings lies 1 - cos(pi / 512) = 2e-5 of its radius within the sphere: a ray that meets it at 60
  // degrees goes on for tan(60) times that across the sphere. Corners of triangles snap to 1/256 of a pixel of 0.08 m,
  // which is as much across a sphere of 1 m, at 60 degrees twice that.
  constexpr double MESH = 2e-5 * 1.74, SNAP = 2 * 0.08 / 256;
  const Drawn normals = drawn(sceneOf(spherePrimitive(1, 256)), Layer::kNormal);
  EXPECT_LT(worstNormal(normals, {0, 0, 0}, 1), MESH + SNAP);
  EXPECT_GT(worstNormal(normals, {0.005, 0, 0}, 1), MESH + SNAP) << "planted: a sphere half a centimetre aside";
  EXPECT_GT(worstNormal(normals, {0, 0, 0}, 1.01), MESH + SNAP) << "planted: a larger one";
  EXPECT_EQ(normals.at(0, 0)[2], 0.0f) << "nothing is seen in the corner";
}

/// Two squares beside each other over a third behind both; the left one is drawn by a node without a material.
std::shared_ptr<Scene> threeParts(bool swapped) {
  auto scene = sceneOf(stackedSquares(1));
  scene->materials.resize(2);
  scene->fileMaterials = 2;
  for (const int material : {-1, 1}) {
    Primitive square = stackedSquares(1);
    square.material = material;
    scene->meshes.push_back({"square", {std::move(square)}});
  }
  scene->nodes.resize(4);
  scene->nodes[1].mesh = -1;  // draws nothing, and has no number
  const auto place = [&](std::size_t node, int mesh, double x, double z) {
    scene->nodes[node].mesh = mesh;
    scene->nodes[node].world = glm::translate(glm::dmat4(1), {x, 0, z});
  };
  place(0, 0, 0, -1);
  place(2, 1, swapped ? 2.5 : -2.5, 0);
  place(3, 2, swapped ? -2.5 : 2.5, 0);
  for (std::size_t i = 0; i < scene->nodes.size(); ++i) scene->nodes[i].file.node = static_cast<int>(i);
  return scene;
}

TEST(LayerPass, PartsAndMaterialsHaveTheirNumbersExactly) {
  // The squares before end 0.5 m from the middle, where 5 m away a pixel is 0.0812 m across: after 6.2 pixels of 16.5.
  const auto rows = [](const Drawn& ids) {
    std::vector<float> row;
    for (int x = 0; x < SIZE; ++x) {
      row.push_back(ids.at(x, SIZE / 2)[0]);
      for (int y = 0; y < SIZE; ++y) EXPECT_EQ(ids.at(x, y)[0], row.back()) << x << " " << y;
    }
    return row;
  };
  const auto expected = [](float left, float middle, float right) {
    std::vector<float> row(SIZE, middle);
    std::fill(row.begin(), row.begin() + 10, left);
    std::fill(row.end() - 10, row.end(), right);
    return row;
  };
  const auto parts = rows(drawn(threeParts(false), Layer::kPartId));
  EXPECT_EQ(parts, expected(2, 1, 3));
  EXPECT_NE(rows(drawn(threeParts(true), Layer::kPartId)), parts) << "planted: two parts change places";
  const auto materials = rows(drawn(threeParts(false), Layer::kMaterialId));
  EXPECT_EQ(materials, expected(materials.front(), 1, 2));
  EXPECT_NE(materials.front(), 1.0f) << "glTF's default one has a number of its own";
  EXPECT_NE(materials.front(), 2.0f);
  EXPECT_NE(materials.front(), 0.0f);
  EXPECT_NE(rows(drawn(threeParts(true), Layer::kMaterialId)), materials) << "planted";
}

}  // namespace
}  // namespace telar::layer_pass_test
