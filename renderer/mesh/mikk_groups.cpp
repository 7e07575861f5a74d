#include "mesh/mikk_groups.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace telar::mikk {
namespace {

bool notZero(float x) { return std::fabs(x) > FLT_MIN; }

/// Walks the fan of one vertex; keeps the walk's state between groups.
class Collector {
 public:
  Collector(std::vector<Triangle>& triangles, std::span<const std::uint32_t> corners,
            std::span<const std::uint32_t> across)
      : triangles_(triangles), corners_(corners), across_(across), groupOf_(corners.size(), NONE) {}

  Groups run() {
    for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) {
      if (!triangles_[corner / 3].flexible && groupOf_[corner] == NONE) collect(corner);
    }
    return std::move(result_);
  }

 private:
  void collect(std::uint32_t start) {
    const auto id = static_cast<std::uint32_t>(result_.groups.size());
    const auto begin = static_cast<std::uint32_t>(result_.corners.size());
    const Group group{corners_[start], triangles_[start / 3].preserves, begin, 0};
    pending_.assign(1, start / 3);
    while (!pending_.empty()) {
      const std::uint32_t triangle = pending_.back();
      pending_.pop_back();
      const std::uint32_t corner = cornerOf(triangle, group.vertex);
      if (!joins(corner, group.preserves)) continue;
      groupOf_[corner] = id;
      result_.corners.push_back(corner);
      // The edge that leaves the corner is visited first, so it is pushed last.
      for (const std::uint32_t edge : {corner % 3 == 0 ? corner + 2 : corner - 1, corner}) {
        if (across_[edge] != NONE) pending_.push_back(across_[edge]);
      }
    }
    // In the order of the triangles, so that sums do not depend on the walk.
    std::sort(result_.corners.begin() + begin, result_.corners.end());
    result_.groups.push_back(
        {group.vertex, group.preserves, begin, static_cast<std::uint32_t>(result_.corners.size())});
  }

  std::uint32_t cornerOf(std::uint32_t triangle, std::uint32_t vertex) const {
    std::uint32_t corner = triangle * 3;
    while (corners_[corner] != vertex) ++corner;
    return corner;
  }

  bool joins(std::uint32_t corner, bool preserves) {
    if (groupOf_[corner] != NONE) return false;
    Triangle& triangle = triangles_[corner / 3];
    const std::uint32_t* of = &groupOf_[corner / 3 * 3];
    // The first group that reaches a flexible triangle settles its orientation.
    if (triangle.flexible && of[0] == NONE && of[1] == NONE && of[2] == NONE) triangle.preserves = preserves;
    return triangle.preserves == preserves;
  }

  std::vector<Triangle>& triangles_;
  std::span<const std::uint32_t> corners_, across_;
  std::vector<std::uint32_t> groupOf_, pending_;
  Groups result_;
};

}  // namespace

std::vector<Triangle> describeTriangles(const VertexStreams& vertices, std::span<const std::uint32_t> corners) {
  std::vector<Triangle> triangles(corners.size() / 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const std::uint32_t a = corners[3 * f], b = corners[3 * f + 1], c = corners[3 * f + 2];
    const glm::vec2 uv1 = vertices.uvs[b] - vertices.uvs[a], uv2 = vertices.uvs[c] - vertices.uvs[a];
    const glm::vec3 edge1 = vertices.positions[b] - vertices.positions[a],
                    edge2 = vertices.positions[c] - vertices.positions[a];
    // In fp32 and in this order, so that a sliver's orientation falls as it does for the baker.
    const float area = uv1.x * uv2.y - uv1.y * uv2.x;
    const glm::vec3 s = uv2.y * edge1 - uv1.y * edge2, t = -uv2.x * edge1 + uv1.x * edge2;
    Triangle& triangle = triangles[f];
    triangle.preserves = area > 0;
    if (!notZero(area)) continue;
    const float lengthS = std::sqrt(glm::dot(s, s)), lengthT = std::sqrt(glm::dot(t, t));
    const float sign = triangle.preserves ? 1.0f : -1.0f;
    if (notZero(lengthS)) triangle.tangent = (sign / lengthS) * s;
    if (notZero(lengthT)) triangle.bitangent = (sign / lengthT) * t;
    triangle.flexible = !(notZero(lengthS / std::fabs(area)) && notZero(lengthT / std::fabs(area)));
  }
  return triangles;
}

Groups buildGroups(std::vector<Triangle>& triangles, std::span<const std::uint32_t> corners,
                   std::span<const std::uint32_t> across) {
  return Collector(triangles, corners, across).run();
}

}  // namespace telar::mikk
