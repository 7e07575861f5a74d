#include "frame/covered_pixels.h"

#include <algorithm>
#include <cmath>

#include "frame/camera.h"

namespace telar::frame {
namespace {

constexpr std::size_t MOST_INSTANCES = 1000;

/// Pixels of triangles by the way they turn. A closed model shows one kind, an open one that lies before the camera
/// too.
struct Sides {
  double left = 0, right = 0;

  void add(const Sides& other, double times = 1) { left += other.left * times, right += other.right * times; }
  double most() const { return std::max(left, right); }
};

/// Infinity where a triangle is not before the camera.
Sides sidesOf(const Primitive& primitive, const glm::mat4& toPixel) {
  const std::size_t corners = primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size();
  const auto at = [&](std::size_t i) {
    const glm::vec3& position = primitive.positions[primitive.indices.empty() ? i : primitive.indices[i]];
    const glm::vec4 clip = toPixel * glm::vec4(position, 1);
    return glm::vec3(glm::vec2(clip) / clip.w, clip.w);
  };
  Sides sides;
  for (std::size_t i = 0; i + 3 <= corners; i += 3) {
    const glm::vec3 a = at(i), b = at(i + 1), c = at(i + 2);
    if (!(std::min({a.z, b.z, c.z}) > 0)) return {INFINITY, INFINITY};
    const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    (twice > 0 ? sides.left : sides.right) += static_cast<double>(std::abs(twice)) / 2;
  }
  return sides;
}

}  // namespace

double coveredPixels(const Scene& scene, const Shot& shot) {
  const double all = static_cast<double>(shot.width) * shot.height;
  const glm::dmat4 toPixel = worldToPixel(cameraOf(shot), shot.width, shot.height);
  Sides sum;
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (primitive.topology != Topology::kTriangles) continue;
      const glm::dmat4 own = toPixel * node.world;
      if (!node.instances) {
        sum.add(sidesOf(primitive, glm::mat4(own)));
        continue;
      }
      const auto& matrices = node.instances->matrices;
      const std::size_t looked = std::min(matrices.size(), MOST_INSTANCES);
      const double times = static_cast<double>(matrices.size()) / static_cast<double>(std::max<std::size_t>(looked, 1));
      for (std::size_t i = 0; i < looked && sum.most() < all; ++i)
        sum.add(sidesOf(primitive, glm::mat4(own * glm::dmat4(matrices[i]))), times);
    }
  }
  return std::min(sum.most(), all);
}

}  // namespace telar::frame
