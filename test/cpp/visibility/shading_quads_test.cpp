#include "visibility/shading_quads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "visibility/meshes.h"

namespace telar::visibility {
namespace {

using test::gridOf;
using test::placed;
using test::Placed;
using test::rectangle;
using test::Triangles;

constexpr int SIZE = 32;

/// A sheet of small triangles over the window, whose depth is a function of x.
template <class Depth>
Triangles sheet(int cells, const Depth& depth) {
  Triangles out;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const glm::vec2 p = glm::vec2(x, y) * (1.8f / static_cast<float>(cells)) - 0.9f;
      out.positions.emplace_back(p, depth(p.x));
    }
  }
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (cells + 1) + x); };
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      for (const auto i : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)})
        out.indices.push_back(i);
    }
  }
  return out;
}

std::vector<std::vector<ShadingQuad>> quadsOf(const std::vector<PlacedMesh>& meshes, SampleOwners& owners) {
  EXPECT_TRUE(owners.look(gridOf(SIZE), meshes, {}));
  ShadingQuads quads;
  quads.find(owners, {});
  return quads.all();
}

TEST(ShadingQuads, EverySampleIsShownByItsOwnerOnce) {
  const Triangles wave = sheet(24, [](float x) { return 0.3f * std::sin(9 * x); });
  const Triangles front = rectangle({-0.3f, -0.4f}, {0.5f, 0.3f}, -0.9f);
  SampleOwners owners;
  const Placed a = placed(wave), b = placed(front);
  const auto all = quadsOf({a.mesh, b.mesh}, owners);
  std::vector<int> seen(SIZE * SIZE * SAMPLES);
  for (std::size_t mesh = 0; mesh < all.size(); ++mesh) {
    for (const ShadingQuad& quad : all[mesh]) {
      for (unsigned pixel = 0; pixel < 4; ++pixel) {
        const int x = quad.x + static_cast<int>(pixel & 1), y = quad.y + static_cast<int>(pixel >> 1);
        const unsigned samples = (quad.samples >> (4 * pixel)) & 15u;
        for (unsigned i = 0; i < SAMPLES; ++i) {
          if ((samples >> i & 1u) == 0) continue;
          ++seen[static_cast<std::size_t>((y * SIZE + x) * SAMPLES) + i];
          const Owner owner = owners.of(x, y)[i];
          ASSERT_NE(owner, NO_OWNER);
          EXPECT_EQ(owners.triangle(owner).mesh, mesh);
          EXPECT_EQ(owners.triangle(owner).number, quad.triangle);
          EXPECT_EQ((owner & COUNTER_CLOCKWISE) != 0, quad.counterClockwise);
        }
      }
    }
  }
  for (int y = 0; y < SIZE; ++y) {
    for (int x = 0; x < SIZE; ++x) {
      const Pixels& covered = owners.covered();
      const bool in = x >= covered.fromX && x <= covered.toX && y >= covered.fromY && y <= covered.toY;
      for (int i = 0; i < SAMPLES; ++i)
        EXPECT_EQ(seen[static_cast<std::size_t>((y * SIZE + x) * SAMPLES + i)], in && owners.of(x, y)[i] != NO_OWNER);
    }
  }
}

TEST(ShadingQuads, OfOneTriangleAreTogether) {
  const Triangles wave = sheet(9, [](float x) { return 0.3f * std::sin(9 * x); });
  const Placed a = placed(wave);
  SampleOwners owners;
  const auto all = quadsOf({a.mesh}, owners);
  EXPECT_TRUE(std::is_sorted(all[0].begin(), all[0].end(),
                             [](const ShadingQuad& u, const ShadingQuad& v) { return u.triangle < v.triangle; }));
}

TEST(ShadingQuads, CountTheTrianglesThatAreShown) {
  const Triangles flat = sheet(10, [](float) { return 0.0f; });
  const Triangles front = rectangle({-1, -1}, {1, 1}, -0.5f);
  SampleOwners owners;
  const Placed a = placed(flat), b = placed(front);
  const std::vector<PlacedMesh> meshes{a.mesh, b.mesh};
  ASSERT_TRUE(owners.look(gridOf(SIZE), meshes, {}));
  ShadingQuads quads;
  quads.find(owners, {});
  EXPECT_EQ(quads.shown(), 2u);
}

}  // namespace
}  // namespace telar::visibility
