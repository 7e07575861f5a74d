#include "visibility/quad_varyings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Varyings that are mixed as llvmpipe mixes them; that the bytes of pictures are those of the GL is seen in
// renderer/visibility_buffer_test.cpp.

namespace telar::visibility::quad_varyings_test {
namespace {

constexpr glm::vec2 SIZE{64, 48};

/// A triangle in perspective whose varyings are linear in space: one more than four, so that there are two texels.
struct Mixed {
  std::vector<float> floats;
  std::vector<float> texels;
  static constexpr std::size_t VARYINGS = 5, WIDTH = 8, LAYERS = 2;

  static float valueOf(const glm::vec4& clip, std::size_t i) {
    return clip.x * 0.5f + clip.y * 2 - clip.w * 0.25f + static_cast<float>(i);
  }

  Mixed(const std::array<glm::vec4, 3>& corners, bool counterClockwise, float offset = 0)
      : texels(WIDTH * LAYERS * 4 * 4) {
    for (const glm::vec4& at : corners) {
      floats.insert(floats.end(), {at.x, at.y, at.z, at.w});
      for (std::size_t i = 0; i < VARYINGS; ++i) floats.push_back(valueOf(at, i));
    }
    floats.resize(floats.size() + 3);
    WindowVertices vertices;
    const VertexOutputs outputs{floats.data(), VARYINGS};
    vertices.place(floats.data(), outputs.stride(), 3, SIZE, {});
    const PlacedMesh mesh{outputs, 3, {}, Faces::kBoth};
    const Owner owner = counterClockwise ? COUNTER_CLOCKWISE : 0;
    VaryingMixer(mesh, vertices, offset)
        .mix({20, 30, 0, {owner, owner, owner, owner}}, {texels.data(), WIDTH, LAYERS}, {2, 0});
  }

  float at(unsigned pixel, std::size_t i) const {
    const FragmentTexels out{const_cast<float*>(texels.data()), WIDTH, LAYERS};
    return out.of({2 + (pixel & 1), pixel >> 1}, i / 4)[i % 4];
  }
};

/// Clip space of a plane w = a + b x + c y over the window of -1..1: where the ray of a pixel meets it.
constexpr float A = 3, B = 0.5f, C = -0.8f;
glm::vec4 onPlane(float x, float y) {
  const float w = A / (1 - B * x - C * y);
  return {x * w, y * w, 0, w};
}

TEST(VaryingMixer, MixesInPerspective) {
  const std::array<glm::vec4, 3> corners{onPlane(-0.9f, -0.7f), onPlane(0.8f, -0.5f), onPlane(0.1f, 0.95f)};
  const Mixed mixed(corners, true);
  const Mixed turned({corners[0], corners[2], corners[1]}, false);
  for (unsigned pixel = 0; pixel < 4; ++pixel) {
    const glm::vec2 centre = glm::vec2(20 + (pixel & 1), 30 + (pixel >> 1)) + 0.5f;
    const glm::vec4 expected = onPlane(centre.x / SIZE.x * 2 - 1, centre.y / SIZE.y * 2 - 1);
    for (std::size_t i = 0; i < Mixed::VARYINGS; ++i) {
      EXPECT_NEAR(mixed.at(pixel, i), Mixed::valueOf(expected, i), 2e-5) << pixel << ", " << i;
      EXPECT_NEAR(turned.at(pixel, i), Mixed::valueOf(expected, i), 2e-5) << pixel << ", " << i;
    }
  }
  // Without perspective it would be far off: at the corners w differs by half.
  const glm::vec4 other = onPlane(0.1f, 0.1f);
  EXPECT_GT(std::abs(mixed.at(0, 0) - Mixed::valueOf(other, 0)), 0.1);
}

// Each float has a place of its own, and a block of 4 x 4 fragments has one run of them.
TEST(FragmentTexels, LieBlockByBlock) {
  constexpr std::size_t WIDTH = 8, LAYERS = 3, BLOCK = 16 * LAYERS;
  float texels[4 * WIDTH * LAYERS * 4];
  const FragmentTexels out{texels, WIDTH, LAYERS};
  std::vector<std::ptrdiff_t> places;
  for (unsigned y = 0; y < 4; ++y) {
    for (unsigned x = 0; x < WIDTH; ++x) {
      for (std::size_t layer = 0; layer < LAYERS; ++layer) {
        places.push_back((out.of({x, y}, layer) - texels) / 4);
        EXPECT_EQ(static_cast<std::size_t>(places.back()) / BLOCK, x / 4) << x << ", " << y;
      }
    }
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) ASSERT_EQ(places[i], static_cast<std::ptrdiff_t>(i));
}

TEST(VaryingSteps, AreThoseBetweenNeighbours) {
  const std::array<glm::vec4, 3> corners{onPlane(-0.9f, -0.7f), onPlane(0.8f, -0.5f), onPlane(0.1f, 0.95f)};
  const Mixed mixed(corners, true);
  WindowVertices vertices;
  const VertexOutputs outputs{mixed.floats.data(), Mixed::VARYINGS};
  vertices.place(mixed.floats.data(), outputs.stride(), 3, SIZE, {});
  const PlacedMesh mesh{outputs, 3, {}, Faces::kBoth};
  constexpr Owner OWNER = COUNTER_CLOCKWISE;
  // The last two lie in two texels.
  for (const std::size_t component : {0u, 1u, 2u, 3u}) {
    const glm::vec2 steps = VaryingSteps(mesh, vertices, 0, component).of({20, 30, 0, {OWNER, OWNER, OWNER, OWNER}});
    for (std::size_t i = 0; i < 2; ++i) {
      const auto apart = [&](unsigned a, unsigned b) {
        return std::abs(mixed.at(a, component + i) - mixed.at(b, component + i));
      };
      const float across = std::min(apart(0, 1), apart(2, 3)), up = std::min(apart(0, 2), apart(1, 3));
      EXPECT_EQ(steps[static_cast<int>(i)], std::max(across, up)) << component;
      EXPECT_GT(steps[static_cast<int>(i)], 1e-3f);
    }
  }
}

TEST(WindowVertices, StandWhereTheGLPutsThem) {
  const float clip[] = {0.5f, -0.25f, 0.5f, 2, -4, 0, 0, 2, 0, 0, -3, 2};
  WindowVertices vertices;
  vertices.place(clip, 4, 3, SIZE, {});
  EXPECT_FLOAT_EQ(vertices.vertices[0].x, 40);
  EXPECT_FLOAT_EQ(vertices.vertices[0].y, 21);
  EXPECT_FLOAT_EQ(vertices.vertices[0].z, 0.625f);
  EXPECT_EQ(vertices.vertices[0].outside, 0u);
  EXPECT_FLOAT_EQ(vertices.overW[0], 0.5f);
  EXPECT_EQ(vertices.vertices[1].outside, LEFT);
  EXPECT_EQ(vertices.vertices[2].outside, UNPROJECTED);
}

}  // namespace
}  // namespace telar::visibility::quad_varyings_test
