#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "telar/cancel.h"
#include "telar/part.h"
#include "telar/scene.h"

namespace telar::surface {

constexpr std::uint32_t NONE = ~0u;

/// Where triangles come from: one primitive, drawn by one node (or one of its instances).
struct Source {
  int node = -1;       ///< index into Scene::nodes
  int primitive = -1;  ///< of the node's mesh
  int instance = -1;   ///< -1 = the node has none
  int material = -1;   ///< index into Scene::materials in the variant; -1 = glTF's default one
};

struct Face {
  std::array<std::uint32_t, 3> points{};  ///< three different ones
  std::array<std::uint32_t, 3> edges{};   ///< edges[k] joins points[k] and points[k + 1]
  std::uint32_t source = 0;               ///< index into Surface::sources
  std::uint32_t triangle = 0;             ///< of the primitive, in drawing order
};

struct Edge {
  std::uint32_t a = 0, b = 0;  ///< points, a < b
  std::uint32_t first = 0;     ///< of its faces in Surface::edgeFaces
  std::uint32_t count = 0;     ///< 1 = open, 2 = inner, more = not manifold
};

/// A face that is left out, as an earlier one has its three points.
struct Repeat {
  Face face;                ///< without edges
  std::uint32_t first = 0;  ///< index into Surface::faces: the one that stays
};

/// Polyline of a primitive that draws lines.
struct Line {
  std::vector<glm::dvec3> points;
  std::uint32_t source = 0;
};

/// The triangles that a scene draws, as one mesh in world space. Vertices at one place are one point: files split them
/// where UVs, normals or parts meet. Triangles that this leaves without three corners are left out, and so are those of three points that an
/// earlier one has, as of surfaces that are there twice, once for each side: cloth has one surface.
struct Surface {
  std::vector<glm::dvec3> points;  ///< metres, world space
  std::vector<Face> faces;
  std::vector<Repeat> repeats;
  std::vector<Edge> edges;
  std::vector<std::uint32_t> edgeFaces;
  std::vector<std::uint32_t> pointFirst,
      pointFaces;  ///< faces of point i: pointFaces[pointFirst[i] .. pointFirst[i + 1]]
  std::vector<Source> sources;
  std::vector<Line> lines;
  Bounds bounds;
  double tolerance = 0;  ///< metres: points that were nearer to one another are one

  std::span<const std::uint32_t> facesOf(const Edge& edge) const { return {&edgeFaces[edge.first], edge.count}; }
  std::span<const std::uint32_t> facesAt(std::uint32_t point) const {
    return {pointFaces.data() + pointFirst[point], pointFirst[point + 1] - pointFirst[point]};
  }
  /// Which corner of the face the point is, 0..2.
  static int cornerOf(const Face& face, std::uint32_t point) {
    return face.points[0] == point ? 0 : face.points[1] == point ? 1 : 2;
  }
  const glm::dvec3& corner(const Face& face, int k) const {
    return points[face.points[static_cast<std::size_t>(k % 3)]];
  }
};

struct SurfaceOptions {
  int variant = -1;                 ///< index into Scene::variants
  std::optional<PartQuery> part{};  ///< none = all that is drawn
  /// What is looked at; none = all. @param material  of the file: materialIndex(primitive, variant)
  std::function<bool(const Node&, int material)> isMeant{};
  double join = 0;  ///< metres: points nearer than this are one; 0 = of rounding alone
  std::uint64_t maxTriangles = std::uint64_t{1} << 22;  ///< of what is looked at
};

/// @throws Error{E_MEASURE (no such part), L_TRIANGLES, X_CANCELLED}
Surface buildSurface(const Scene& scene, const SurfaceOptions& options, const CancelToken& cancel);

/// Whether it is of the part: its node or one above it, or its material.
bool isOfPart(const Scene& scene, const Source& source, const PartQuery& part);

Error noSuchPart(const PartQuery& part);

/// Fills edges, edgeFaces, pointFirst and pointFaces from the faces' points.
void connect(Surface& surface, const CancelToken& cancel);

/// A number for each point: equal where a path over the surface joins two points.
std::vector<std::uint32_t> componentsOf(const Surface& surface);

}  // namespace telar::surface
