#include "mesh/mikk_topology.h"

#include <gtest/gtest.h>

namespace telar::mikk {
namespace {

using Ids = std::vector<std::uint32_t>;

TEST(Weld, JoinsOnlyVerticesThatAreEqualInEverything) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {0, 0, 0}, {-0.0f, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const std::vector<glm::vec3> normals{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  const std::vector<glm::vec2> uvs{{0, 0}, {0, 0}, {0, -0.0f}, {0, 1e-30f}, {0, 0}};
  EXPECT_EQ(weld({positions, normals, uvs}), (Ids{0, 1, 0, 3, 4}));
}

TEST(Neighbours, MeetAcrossAnEdgeInOppositeDirections) {
  // 0-1-2 and 2-1-3 share the edge 1-2.
  EXPECT_EQ(neighbours(Ids{0, 1, 2, 2, 1, 3}), (Ids{NONE, 1, NONE, 0, NONE, NONE}));
}

TEST(Neighbours, DoNotMeetWhereBothRunTheSameWay) {
  EXPECT_EQ(neighbours(Ids{0, 1, 2, 1, 2, 3}), (Ids{NONE, NONE, NONE, NONE, NONE, NONE}));
}

TEST(Neighbours, PairUpInOrderOnAnEdgeOfFour) {
  // Edge 0-1: triangles 0 and 1 run forward, 2 and 3 backward.
  EXPECT_EQ(neighbours(Ids{0, 1, 2, 0, 1, 3, 1, 0, 4, 1, 0, 5}),
            (Ids{2, NONE, NONE, 3, NONE, NONE, 0, NONE, NONE, 1, NONE, NONE}));
}

}  // namespace
}  // namespace telar::mikk
