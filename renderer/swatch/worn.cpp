#include "swatch/worn.h"

#include <algorithm>
#include <map>

#include "core/uv_metres.h"

namespace telar::swatch {
namespace {

constexpr std::size_t FACES_PER_CANCEL_CHECK = 1 << 14;

/// Adds a triangle of edges p and q in space.
void addCoordinates(Worn::Coordinates& sum, const std::vector<glm::vec2>& uvs, const Corners& corners,
                    const glm::dvec3& p, const glm::dvec3& q) {
  if (uvs.empty()) return;
  const glm::dvec2 origin(uvs[corners[0]]);
  const glm::dvec2 a = glm::dvec2(uvs[corners[1]]) - origin, b = glm::dvec2(uvs[corners[2]]) - origin;
  const double determinant = a.x * b.y - a.y * b.x;
  const glm::dvec2 metres = uvMetres(p, q, a, b);
  const double area = glm::length(glm::cross(p, q)) / 2;
  // A triangle without area in the texture says nothing of its size.
  if (!std::isfinite(metres.x + metres.y) || area == 0) return;
  sum.area += area;
  sum.metres += area * metres;
  // v runs down the picture: what is not mirrored runs clockwise.
  sum.turned -= std::copysign(area, determinant);
}

}  // namespace

const Primitive& primitiveOf(const Scene& scene, const surface::Source& source) {
  const Node& node = scene.nodes[static_cast<std::size_t>(source.node)];
  return scene.meshes[static_cast<std::size_t>(node.mesh)].primitives[static_cast<std::size_t>(source.primitive)];
}

Corners cornersOf(const Primitive& primitive, const surface::Face& face) {
  Corners corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = std::size_t{3} * face.triangle + k;
    corners[k] = primitive.indices.empty() ? static_cast<std::uint32_t>(at) : primitive.indices[at];
  }
  return corners;
}

Worn mostWorn(const Scene& scene, const surface::Surface& surface, const CancelToken& cancel) {
  std::map<int, Worn> worn;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (f % FACES_PER_CANCEL_CHECK == 0) cancel.check();
    const surface::Face& face = surface.faces[f];
    const surface::Source& source = surface.sources[face.source];
    const Primitive& primitive = primitiveOf(scene, source);
    const Corners corners = cornersOf(primitive, face);
    const glm::dvec3 &a = surface.corner(face, 0), &b = surface.corner(face, 1), &c = surface.corner(face, 2);
    const glm::dvec3 p = b - a, q = c - a;
    const double area = glm::length(glm::cross(p, q)) / 2;
    Worn& sum = worn[source.material];
    sum.material = source.material;
    sum.area += area;
    for (std::size_t set = 0; set < 2; ++set) addCoordinates(sum.coordinates[set], primitive.uvs[set], corners, p, q);
    glm::dvec4 color(1);
    if (!primitive.colors.empty()) {
      color = glm::dvec4(primitive.colors[corners[0]]) + glm::dvec4(primitive.colors[corners[1]]) +
              glm::dvec4(primitive.colors[corners[2]]);
      color /= 3.0;
    }
    sum.color += area * color;
  }
  return std::max_element(worn.begin(), worn.end(),
                          [](const auto& p, const auto& q) { return p.second.area < q.second.area; })
      ->second;
}

}  // namespace telar::swatch
