#include "measure/loops.h"

#include <gtest/gtest.h>

#include "cpu_clock.h"
#include "expect_error.h"
#include "measure/shapes.h"
#include "surface/chain.h"

namespace telar::measure::loops_test {
namespace {

using surface::Surface;
constexpr double PI = std::numbers::pi;

Surface surfaceOf(const Scene& scene) { return surface::buildSurface(scene, {}, {}); }

/// A tube along y, of radius 1 at its ends and `waist` in the middle.
Surface tube(int around, double waist, double disorder) {
  return surfaceOf(test::sheet(around, 24, disorder, [waist](double u, double v) {
    const double r = waist + (1 - waist) * std::pow(2 * v - 1, 2), phi = 2 * PI * u;
    return glm::dvec3(r * std::cos(phi), 2 * v - 1, -r * std::sin(phi));
  }));
}

TEST(Section, OfATubeIsTheCircleOfItsSides) {
  const Surface straight = tube(48, 1, 0);
  const auto loops = sectionOf(straight, {1, 0.123, 0}, {0, 1, 0}, {});
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_TRUE(loops[0].closed);
  EXPECT_NEAR(loops[0].length(), 96 * std::sin(PI / 48), 1e-6);
}

TEST(Section, ThroughCornersLosesNothing) {
  const Surface straight = tube(48, 1, 0);
  const auto loops = sectionOf(straight, {1, 0, 0}, {0, 1, 0}, {});  // a row of corners lies in it
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_TRUE(loops[0].closed);
  EXPECT_NEAR(loops[0].length(), 96 * std::sin(PI / 48), 1e-6);
}

TEST(Section, InThePlaneOfItsEndsIsTheirCircle) {
  const Surface straight = tube(48, 1, 0);
  for (const double end : {-1.0, 1.0}) {
    for (const double normal : {-1.0, 1.0}) {
      // And as far off as the rounding of a coordinate of a file is.
      for (const double off : {0.0, 1e-8, -1e-8}) {
        const auto loops = sectionOf(straight, {1, end + off, 0}, {0, normal, 0}, {});
        ASSERT_EQ(loops.size(), 1u) << end << ", " << normal << ", " << off;
        EXPECT_TRUE(loops[0].closed);
        EXPECT_NEAR(loops[0].length(), 96 * std::sin(PI / 48), 1e-6) << end << ", " << normal << ", " << off;
      }
    }
    EXPECT_TRUE(sectionOf(straight, {1, 1.001 * end, 0}, {0, 1, 0}, {}).empty());
  }
}

TEST(Section, InThePlaneOfAHemThatRoundingBentIsItsCircle) {
  // Corners of the hem lie to both sides of the plane.
  const Surface bent = surfaceOf(test::sheet(48, 24, 0, [](double u, double v) {
    const double phi = 2 * PI * u;
    return glm::dvec3(std::cos(phi), 2 * v + (v == 0 ? 1e-7 * std::cos(5 * phi) : 0), -std::sin(phi));
  }));
  const auto loops = sectionOf(bent, {1, 0, 0}, {0, 1, 0}, {});
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_TRUE(loops[0].closed);
  EXPECT_NEAR(loops[0].length(), 96 * std::sin(PI / 48), 1e-6);
}

TEST(Section, OfAHemBesideASleeveThatReachesLowerHasBoth) {
  const auto tubeAt = [](double x, double bottom) {
    return test::sheet(48, 24, 0,
                       [&](double u, double v) {
                         const double phi = 2 * PI * u;
                         return glm::dvec3(x + std::cos(phi), glm::mix(bottom, 2.0, v), -std::sin(phi));
                       })
        .meshes[0]
        .primitives[0];
  };
  Scene both = test::sceneOf({}, {});
  both.meshes[0].primitives = {tubeAt(0, 0), tubeAt(5, -1)};
  const auto loops = sectionOf(surfaceOf(both), {1, 0, 0}, {0, 1, 0}, {});
  ASSERT_EQ(loops.size(), 2u);
  for (const Loop& loop : loops) {
    EXPECT_TRUE(loop.closed);
    EXPECT_NEAR(loop.length(), 96 * std::sin(PI / 48), 1e-6);
  }
}

TEST(Section, ThatTouchesACornerHasNoLoopThere) {
  // A corner of a cone that points down.
  const Surface cone = surfaceOf(test::sheet(
      24, 4, 0, [](double u, double v) { return glm::dvec3(v * std::cos(2 * PI * u), v, -v * std::sin(2 * PI * u)); }));
  EXPECT_TRUE(sectionOf(cone, {0, 0, 0}, {0, 1, 0}, {}).empty());
}

TEST(Section, OfAnOpenSheetIsOpen) {
  const Surface flat = surfaceOf(test::sheet(5, 5, 0.3, [](double u, double v) { return glm::dvec3(u, v, 0); }));
  const auto loops = sectionOf(flat, {0, 0.37, 0}, {0, 1, 0}, {});
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_FALSE(loops[0].closed);
  EXPECT_NEAR(loops[0].length(), 1, 1e-6);
}

/// Half a tube along y about the origin, in front (z > 0) or behind.
Primitive half(double radius, bool front, int material) {
  Primitive out = test::sheet(24, 8, 0,
                              [&](double u, double v) {
                                const double phi = PI * (front ? u : u + 1);
                                // At its ends all of them lie in one seam.
                                const double r = glm::mix(radius, 1.0, std::pow(std::cos(phi), 8));
                                return glm::dvec3(r * std::cos(phi), 2 * v - 1, r * std::sin(phi));
                              })
                      .meshes[0]
                      .primitives[0];
  out.material = material;
  return out;
}

/// Each primitive a node of its own.
Surface sewn(const std::vector<Primitive>& parts) {
  Scene scene;
  for (const Primitive& part : parts) {
    Node node;
    node.mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"part", {part}});
    scene.nodes.push_back(node);
    scene.materials.resize(std::max(scene.materials.size(), static_cast<std::size_t>(part.material + 1)));
  }
  return surface::buildSurface(scene, {.join = 1e-4}, {});
}

TEST(Section, OfALinedBodyIsShellAndLiningHoweverTheyAreListed) {
  const Primitive shellFront = half(1, true, 0), shellBack = half(1, false, 0);
  for (const double height : {0.1, 0.0}) {  // the latter through a row of corners
    const auto lengthsOf = [height](const Surface& surface) {
      std::vector<double> lengths;
      for (const Loop& loop : sectionOf(surface, {0, height, 1}, {0, 1, 0}, {})) {
        EXPECT_TRUE(loop.closed);
        lengths.push_back(loop.length());
      }
      std::sort(lengths.begin(), lengths.end());
      return lengths;
    };
    const auto shell = lengthsOf(sewn({shellFront, shellBack}));
    ASSERT_EQ(shell.size(), 1u);
    for (const int lined : {0, 1}) {  // one material, or the lining's own
      const Primitive liningFront = half(0.9, true, lined), liningBack = half(0.9, false, lined);
      const auto lining = lengthsOf(sewn({liningFront, liningBack}));
      for (const auto& parts : {std::vector{shellFront, liningFront, shellBack, liningBack},
                                std::vector{shellBack, liningBack, shellFront, liningFront},
                                std::vector{liningBack, shellFront, shellBack, liningFront}}) {
        const auto both = lengthsOf(sewn(parts));
        ASSERT_EQ(both.size(), 2u) << height << ", " << lined;
        EXPECT_NEAR(both[0], lining[0], 1e-9);
        EXPECT_NEAR(both[1], shell[0], 1e-9);
      }
    }
  }
}

TEST(Section, GoesOnUnderAPocketThatIsSewnOn) {
  const auto tubeOf = [](double from, double to, double radius, int columns) {
    return test::sheet(columns, 8, 0,
                       [=](double u, double v) {
                         const double phi = 2 * PI * glm::mix(from, to, u), out = 1 + (radius - 1) * std::sin(PI * u);
                         return glm::dvec3(out * std::cos(phi), 2 * v - 1, -out * std::sin(phi));
                       })
        .meshes[0]
        .primitives[0];
  };
  const Primitive body = tubeOf(0, 1, 1, 48), pocket = tubeOf(0.25, 0.5, 1.05, 12);
  for (const double height : {0.1, 0.0}) {
    const auto loops = sectionOf(sewn({pocket, body}), {1, height, 0}, {0, 1, 0}, {});
    ASSERT_EQ(loops.size(), 2u) << height;
    const Loop& around = loops[0].closed ? loops[0] : loops[1];
    EXPECT_TRUE(around.closed);
    EXPECT_NEAR(around.length(), 96 * std::sin(PI / 48), 1e-6) << height;
  }
}

TEST(Section, OfASurfaceThatIsThereTwiceIsTheOneLoop) {
  const Primitive once =
      test::sheet(48, 8, 0,
                  [](double u, double v) { return glm::dvec3(std::cos(2 * PI * u), v, std::sin(2 * PI * u)); })
          .meshes[0]
          .primitives[0];
  std::vector<std::uint32_t> behind = once.indices, mixed;  // the other sides after all, or each after its own
  for (std::size_t i = 0; i < once.indices.size(); i += 3) {
    const std::uint32_t a = once.indices[i], b = once.indices[i + 1], c = once.indices[i + 2];
    behind.insert(behind.end(), {a, c, b});
    mixed.insert(mixed.end(), {a, b, c, a, c, b});
  }
  for (const auto& indices : {behind, mixed}) {
    const Surface surface = surfaceOf(test::sceneOf(once.positions, indices));
    const auto loops = sectionOf(surface, {1, 0.4, 0}, {0, 1, 0}, {});
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_TRUE(loops[0].closed);
    EXPECT_NEAR(loops[0].length(), 96 * std::sin(PI / 48), 1e-6);
    EXPECT_EQ(borderOf(surface, {}).size(), 2u);
  }
}

TEST(Border, OfATubeIsItsTwoEnds) {
  const auto loops = borderOf(tube(48, 0.6, 0.4), {});
  ASSERT_EQ(loops.size(), 2u);
  for (const Loop& loop : loops) {
    EXPECT_TRUE(loop.closed);
    EXPECT_NEAR(loop.length(), 96 * std::sin(PI / 48), 1e-5);
  }
}

TEST(Border, HasAHoleAsALoopOfItsOwn) {
  // A square of nine quads without the middle one.
  std::vector<glm::vec3> positions;
  for (int i = 0; i < 16; ++i) positions.emplace_back(i % 4, i / 4, 0);
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t a : {0u, 1u, 2u, 4u, 6u, 8u, 9u, 10u}) {
    for (const std::uint32_t index : {a, a + 1, a + 5, a, a + 5, a + 4}) indices.push_back(index);
  }
  auto loops = borderOf(surfaceOf(test::sceneOf(positions, indices)), {});
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(loops[0].length() + loops[1].length(), 12 + 4, 1e-12);
  EXPECT_NEAR(std::min(loops[0].length(), loops[1].length()), 4, 1e-12);
}

/// Each walk goes on where the last one left off, however many links meet in a corner.
TEST(Chains, OfManyLinksAtOneCornerTakeAsLongAsThereAreLinks) {
  const auto star = [](std::uint32_t count) {
    std::vector<std::array<std::uint32_t, 2>> links;
    for (std::uint32_t i = 1; i <= count; ++i) {
      links.push_back({0, i});
      links.push_back({i, 0});
    }
    return links;
  };
  const auto timeOf = [&](std::uint32_t count) {
    const auto links = star(count);
    const auto start = test::CpuClock::now();
    const auto chains = surface::chainLinks(links, {});
    const auto took = test::CpuClock::now() - start;
    EXPECT_EQ(chains.size(), count);
    EXPECT_TRUE(chains.back().closed);
    return took;
  };
  EXPECT_LT(timeOf(160'000), 8 * timeOf(40'000)) << "its square is 16";
  const CancelToken cancelled;
  cancelled.cancel();
  EXPECT_ERROR(surface::chainLinks(star(1), cancelled), "X_CANCELLED");
}

TEST(Tightened, ALoopSlidesToTheWaist) {
  const CancelToken cancel;
  for (const double disorder : {0.0, 0.4}) {
    const Surface surface = tube(96, 0.6, disorder);
    const auto loops = sectionOf(surface, {0.7, 0.3, 0}, {0.1, 1, 0}, cancel);
    ASSERT_EQ(loops.size(), 1u);
    const Loop tight = tightened(surface, loops[0], cancel);
    const double waist = 2 * PI * 0.6;
    EXPECT_GT(loops[0].length(), 1.05 * waist);
    EXPECT_NEAR(tight.length(), waist, 0.005 * waist) << disorder;
  }
}

TEST(Tightened, ACoarseTubeHoldsTheLoopAsAFineOneDoes) {
  // Its edges are longer than the strip that most rounds keep to is wide. At the waist it is a polygon of twelve sides.
  const CancelToken cancel;
  const Surface surface = tube(12, 0.6, 0);
  const auto loops = sectionOf(surface, {0.7, 0.3, 0}, {0.1, 1, 0}, cancel);
  ASSERT_EQ(loops.size(), 1u);
  const double waist = 24 * std::sin(PI / 12) * 0.6;
  EXPECT_NEAR(tightened(surface, loops[0], cancel).length(), waist, 0.005 * waist);
}

TEST(Tightened, ALoopThatCanSlipOffIsRefused) {
  // Around a sphere it can be drawn to a point.
  const Surface sphere = surfaceOf(test::sphere(48, 24));
  const CancelToken cancel;
  const auto loops = sectionOf(sphere, {0.8, 0.6, 0}, {0, 1, 0}, cancel);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_ERROR(tightened(sphere, loops[0], cancel), "E_MEASURE");
}

}  // namespace
}  // namespace telar::measure::loops_test
