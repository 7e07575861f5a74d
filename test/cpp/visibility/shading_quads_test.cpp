#include "visibility/shading_quads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "visibility/meshes.h"

namespace telar::visibility::shading_quads_test {
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

std::vector<std::vector<ShadingQuad>> quadsOf(const std::vector<PlacedMesh>& meshes, SampleOwners& owners,
                                              const ShadingQuads::Wanted& wanted = {},
                                              const SampleGrid& grid = gridOf(SIZE)) {
  EXPECT_TRUE(owners.look(grid, meshes, {}, {}));
  ShadingQuads quads;
  quads.find(owners, wanted, {});
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
          EXPECT_EQ(owners.triangle(owner).number, numberOf(quad.owners[pixel]));
          EXPECT_EQ(owner & COUNTER_CLOCKWISE, quad.owners[pixel] & COUNTER_CLOCKWISE);
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

TEST(ShadingQuads, EachIsVisitedOnceByRowsWithItsIndex) {
  const Triangles wave = sheet(9, [](float x) { return 0.3f * std::sin(9 * x); });
  const Triangles front = rectangle({-0.3f, -0.4f}, {0.5f, 0.3f}, -0.9f);
  const Placed a = placed(wave), b = placed(front);
  const std::vector<PlacedMesh> meshes{a.mesh, b.mesh};
  SampleOwners owners;
  ASSERT_TRUE(owners.look(gridOf(SIZE), meshes, {}, {}));
  ShadingQuads quads;
  quads.find(owners, {}, {});
  for (std::size_t mesh = 0; mesh < quads.all().size(); ++mesh) {
    const std::vector<ShadingQuad>& all = quads.all()[mesh];
    std::vector<int> visits(all.size());
    int y = 0;
    quads.forEach(mesh, [&](const ShadingQuad& quad, std::size_t index) {
      ASSERT_LT(index, all.size());
      ++visits[index];
      EXPECT_EQ(std::tie(quad.x, quad.y, quad.samples, quad.owners),
                std::tie(all[index].x, all[index].y, all[index].samples, all[index].owners));
      EXPECT_GE(quad.y, y);
      y = quad.y;
    });
    EXPECT_EQ(visits, std::vector<int>(all.size(), 1));
    EXPECT_GT(all.size(), 1u);
  }
}

TEST(ShadingQuads, OfOneTriangleAreTogether) {
  const Triangles wave = sheet(9, [](float x) { return 0.3f * std::sin(9 * x); });
  const Placed a = placed(wave);
  SampleOwners owners;
  const auto all = quadsOf({a.mesh}, owners);
  EXPECT_TRUE(std::is_sorted(all[0].begin(), all[0].end(),
                             [](const ShadingQuad& u, const ShadingQuad& v) { return u.owners[0] < v.owners[0]; }));
}

TEST(ShadingQuads, CountTheTrianglesThatAreShown) {
  const Triangles flat = sheet(10, [](float) { return 0.0f; });
  const Triangles front = rectangle({-1, -1}, {1, 1}, -0.5f);
  SampleOwners owners;
  const Placed a = placed(flat), b = placed(front);
  const std::vector<PlacedMesh> meshes{a.mesh, b.mesh};
  ASSERT_TRUE(owners.look(gridOf(SIZE), meshes, {}, {}));
  ShadingQuads quads;
  quads.find(owners, {}, {});
  EXPECT_EQ(quads.shown(), 2u);
}

TEST(ShadingQuads, OfOneSampleShowEachPixelOnce) {
  const Triangles wave = sheet(24, [](float x) { return 0.3f * std::sin(9 * x); });
  const Placed a = placed(wave);
  SampleOwners owners;
  const auto all = quadsOf({a.mesh}, owners, {}, SampleGrid::ofOneSample(SIZE, SIZE));
  std::vector<int> seen(SIZE * SIZE);
  for (const ShadingQuad& quad : all[0]) {
    for (unsigned pixel = 0; pixel < 4; ++pixel) {
      const int x = quad.x + static_cast<int>(pixel & 1), y = quad.y + static_cast<int>(pixel >> 1);
      const unsigned samples = (quad.samples >> (4 * pixel)) & 15u;
      ASSERT_TRUE(samples == 0 || samples == 15);
      if (samples == 0) continue;
      ++seen[static_cast<std::size_t>(y * SIZE + x)];
      EXPECT_EQ(numberOf(owners.of(x, y)[pixel]), numberOf(quad.owners[pixel]));
    }
  }
  // The sheet reaches over 0.9 of the window.
  for (int i = 0; i < SIZE * SIZE; ++i) {
    const auto in = [](int p) { return p >= 2 && p < SIZE - 2; };
    if (in(i % SIZE) && in(i / SIZE)) {
      EXPECT_EQ(seen[static_cast<std::size_t>(i)], 1) << i;
    }
  }
}

std::size_t countOf(const std::vector<PlacedMesh>& meshes, const ShadingQuads::Wanted& wanted) {
  SampleOwners owners;
  std::size_t count = 0;
  for (const auto& quads : quadsOf(meshes, owners, wanted)) count += quads.size();
  return count;
}

TEST(ShadingQuads, MergedOnASheetAreOneEach) {
  const Triangles flat = sheet(20, [](float) { return 0.0f; });
  const Placed a = placed(flat);
  const std::size_t wanted = (SIZE * 9 / 10 / 2 + 2) * (SIZE * 9 / 10 / 2 + 2);
  EXPECT_LE(countOf({a.mesh}, {true, {}}), wanted);
  EXPECT_GT(countOf({a.mesh}, {}), 3 * countOf({a.mesh}, {true, {}}));
}

TEST(ShadingQuads, MergedShowATriangleOfTheirPixel) {
  const Triangles wave = sheet(24, [](float x) { return 0.3f * std::sin(9 * x); });
  const Placed a = placed(wave);
  SampleOwners owners;
  const auto all = quadsOf({a.mesh}, owners, {true, {}});
  for (const ShadingQuad& quad : all[0]) {
    for (unsigned pixel = 0; pixel < 4; ++pixel) {
      if (((quad.samples >> (4 * pixel)) & 15u) == 0) continue;
      const Owner* samples = owners.of(quad.x + static_cast<int>(pixel & 1), quad.y + static_cast<int>(pixel >> 1));
      EXPECT_TRUE(std::any_of(samples, samples + SAMPLES, [&](Owner o) { return o == quad.owners[pixel]; }));
    }
  }
}

TEST(ShadingQuads, OfMeshesThatShareNoVertexAreNotMerged) {
  const Triangles left = rectangle({-0.9f, -0.9f}, {0.03f, 0.9f}, 0),
                  right = rectangle({0.03f, -0.9f}, {0.9f, 0.9f}, 0);
  const Placed a = placed(left), b = placed(right);
  const std::size_t apart = countOf({a.mesh, b.mesh}, {true, {}});
  Triangles both = left;
  both.positions.insert(both.positions.end(), right.positions.begin(), right.positions.end());
  for (const std::uint32_t i : right.indices) both.indices.push_back(i + 4);
  EXPECT_EQ(countOf({placed(both).mesh}, {true, {}}), apart);
  for (std::uint32_t& i : both.indices) i = i == 4 ? 1 : i == 7 ? 2 : i;
  EXPECT_LT(countOf({placed(both).mesh}, {true, {}}), apart);
}

TEST(ShadingQuads, OfSettledPixelsAreLeftOut) {
  const Triangles flat = sheet(4, [](float) { return 0.0f; });
  const Placed a = placed(flat);
  std::vector<std::uint8_t> settled(SIZE * SIZE, 255);
  EXPECT_EQ(countOf({a.mesh}, {false, settled}), 0u);
  settled[static_cast<std::size_t>(SIZE * 3 + 9)] = 0;  // the fourth row from above
  SampleOwners owners;
  const auto all = quadsOf({a.mesh}, owners, {false, settled});
  ASSERT_FALSE(all[0].empty());
  for (const ShadingQuad& quad : all[0]) {
    EXPECT_EQ(quad.x, 8);
    EXPECT_EQ(quad.y, SIZE - 4);
  }
}

}  // namespace
}  // namespace telar::visibility::shading_quads_test
