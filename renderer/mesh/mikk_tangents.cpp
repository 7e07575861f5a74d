#include "mesh/mikk_tangents.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "mesh/mikk_groups.h"
#include "mesh/reindex.h"

namespace telar {
namespace {

using mikk::NONE;

// A fan of more triangles than this skips the search for opposed pairs, which costs the square of its size.
constexpr std::size_t OPPOSED_SEARCH_MAX = 256;

/// v, or its unit vector where it has a length.
glm::vec3 normalized(const glm::vec3& v) {
  const float length = std::sqrt(glm::dot(v, v));
  return length > FLT_MIN ? (1.0f / length) * v : v;
}

glm::vec3 projected(const glm::vec3& v, const glm::vec3& normal) {
  return normalized(v - normal * glm::dot(normal, v));
}

/// Any unit vector at right angles to a unit normal; +X when there is no normal.
/// src: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1)
glm::vec3 anyTangent(const glm::vec3& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  return normalized(glm::vec3(1.0f + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x));
}

/// Unit within rounding stays as it is, so that slivers fall as they do for the baker.
glm::vec3 unitNormal(const glm::vec3& n) { return std::abs(glm::dot(n, n) - 1.0f) < 1e-5f ? n : normalized(n); }

/// What one triangle of a group adds at the group's vertex.
struct Spoke {
  glm::vec3 tangent, bitangent;  ///< in the vertex's tangent plane, unit
  float angle = 0;               ///< of the triangle at the vertex, seen in that plane, radians
  bool flexible = false;
};

/// Opposed spokes share no tangent space although their orientation is the same. src: the reference at 180 degrees
bool opposed(const Spoke& a, const Spoke& b) {
  if (a.flexible || b.flexible) return false;
  return glm::dot(a.tangent, b.tangent) <= -1.0f || glm::dot(a.bitangent, b.bitangent) <= -1.0f;
}

/// One run over one primitive; every array is as long as its corners or its vertices.
class Computation {
 public:
  Computation(const Primitive& source, int texCoord) : source_(source), uvs_(source.uvs[texCoord]) {
    corners_ = source.indices;
    if (corners_.empty()) {
      corners_.resize(source.positions.size());
      std::iota(corners_.begin(), corners_.end(), 0u);
    }
    corners_.resize(corners_.size() / 3 * 3);
    normals_.reserve(source.normals.size());
    for (const glm::vec3& n : source.normals) normals_.push_back(unitNormal(n));
    tangents_.assign(corners_.size(), glm::vec4(0, 0, 0, 1));
  }

  /// Tangent of each corner.
  std::vector<glm::vec4> run() {
    const mikk::VertexStreams vertices{source_.positions, normals_, uvs_};
    const std::vector<std::uint32_t> welded = mikk::weld(vertices);
    keepRealTriangles(welded);
    triangles_ = mikk::describeTriangles(vertices, realCorners_);
    const mikk::Groups groups = mikk::buildGroups(triangles_, realCorners_, mikk::neighbours(realCorners_));
    for (const mikk::Group& group : groups.groups) {
      average(group, std::span(groups.corners).subspan(group.begin, group.end - group.begin));
    }
    copyToCollapsed(welded);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const glm::vec3 tangent(tangents_[i]);
      if (!(glm::dot(tangent, tangent) > 0.5f)) {  // 0, or NaN where coordinates are too large to subtract
        tangents_[i] = glm::vec4(anyTangent(normals_[corners_[i]]), tangents_[i].w);
      }
    }
    return std::move(tangents_);
  }

 private:
  /// Triangles whose three positions differ, by welded vertex.
  void keepRealTriangles(const std::vector<std::uint32_t>& welded) {
    for (std::uint32_t corner = 0; corner < corners_.size(); corner += 3) {
      const glm::vec3 &a = position(corner), &b = position(corner + 1), &c = position(corner + 2);
      if (a == b || a == c || b == c) continue;
      for (std::uint32_t i = 0; i < 3; ++i) realCorners_.push_back(welded[corners_[corner + i]]);
      realTriangles_.push_back(corner / 3);
    }
  }

  const glm::vec3& position(std::uint32_t corner) const { return source_.positions[corners_[corner]]; }
  std::uint32_t originalCorner(std::uint32_t corner) const { return realTriangles_[corner / 3] * 3 + corner % 3; }

  Spoke spoke(std::uint32_t corner) const {
    const std::uint32_t first = corner / 3 * 3, next = first + (corner + 1) % 3, previous = first + (corner + 2) % 3;
    const mikk::Triangle& triangle = triangles_[corner / 3];
    const glm::vec3& n = normals_[realCorners_[corner]];
    const glm::vec3& at = source_.positions[realCorners_[corner]];
    const glm::vec3 toPrevious = projected(source_.positions[realCorners_[previous]] - at, n);
    const glm::vec3 toNext = projected(source_.positions[realCorners_[next]] - at, n);
    return {projected(triangle.tangent, n), projected(triangle.bitangent, n),
            std::acos(std::clamp(glm::dot(toPrevious, toNext), -1.0f, 1.0f)), triangle.flexible};
  }

  void average(const mikk::Group& group, std::span<const std::uint32_t> corners) {
    spokes_.clear();
    for (const std::uint32_t corner : corners) spokes_.push_back(spoke(corner));
    const bool split = hasOpposed();
    glm::vec3 tangent(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (split || i == 0) tangent = sum(spokes_[i], split);
      // MikkTSpace counts v upwards; glTF's v grows downwards in the image, so the sign turns.
      tangents_[originalCorner(corners[i])] = glm::vec4(tangent, group.preserves ? -1.0f : 1.0f);
    }
  }

  bool hasOpposed() const {
    if (spokes_.size() > OPPOSED_SEARCH_MAX) return false;
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (opposed(spokes_[i], spokes_[j])) return true;
      }
    }
    return false;
  }

  glm::vec3 sum(const Spoke& self, bool split) const {
    glm::vec3 total(0);
    for (const Spoke& other : spokes_) {
      if (other.flexible || (split && &other != &self && opposed(self, other))) continue;
      total += other.angle * other.tangent;
    }
    const float length = std::sqrt(glm::dot(total, total));
    return length > FLT_MIN ? (1.0f / length) * total : glm::vec3(0);
  }

  /// A collapsed triangle takes over what another one has at the same vertex.
  void copyToCollapsed(const std::vector<std::uint32_t>& welded) {
    std::vector<std::uint32_t> donor(welded.size(), NONE);
    for (std::uint32_t corner = 0; corner < realCorners_.size(); ++corner) {
      if (donor[realCorners_[corner]] == NONE) donor[realCorners_[corner]] = originalCorner(corner);
    }
    std::size_t real = 0;
    for (std::uint32_t triangle = 0; triangle < corners_.size() / 3; ++triangle) {
      if (real < realTriangles_.size() && realTriangles_[real] == triangle) {
        ++real;
        continue;
      }
      for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const std::uint32_t from = donor[welded[corners_[corner]]];
        if (from != NONE) tangents_[corner] = tangents_[from];
      }
    }
  }

  const Primitive& source_;
  const std::vector<glm::vec2>& uvs_;
  std::vector<glm::vec3> normals_;            ///< unit, by vertex
  std::vector<std::uint32_t> corners_;        ///< vertex of each corner
  std::vector<std::uint32_t> realTriangles_;  ///< those with three different positions
  std::vector<std::uint32_t> realCorners_;    ///< welded vertex of each of their corners
  std::vector<mikk::Triangle> triangles_;
  std::vector<Spoke> spokes_;        ///< of the group at hand
  std::vector<glm::vec4> tangents_;  ///< by corner
};

}  // namespace

Primitive withMikkTangents(const Primitive& source, int texCoord) {
  const std::size_t count = source.positions.size();
  if (source.topology != Topology::kTriangles || count == 0 || source.normals.size() != count ||
      source.uvs[texCoord].size() != count) {
    return source;
  }
  return withCornerTangents(source, Computation(source, texCoord).run());
}

}  // namespace telar
