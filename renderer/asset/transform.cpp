#include "asset/transform.h"

#include <cmath>

namespace telar::asset {
namespace {

/// Rotation matrix of a quaternion (x, y, z, w). A quaternion that is not of unit length shears and scales.
glm::dmat3 rotationMatrix(const std::vector<double>& q) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  return glm::dmat3(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),   // column 0
                    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),   // column 1
                    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));  // column 2
}

}  // namespace

glm::dmat4 localMatrix(const tinygltf::Node& node) {
  glm::dmat4 out(1);
  if (!node.matrix.empty()) {
    for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return out;
  }
  if (!node.rotation.empty()) out = glm::dmat4(rotationMatrix(node.rotation));
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!node.scale.empty()) out[i] *= node.scale[k];
    if (!node.translation.empty()) out[3][i] = node.translation[k];
  }
  return out;
}

bool isCollapsed(const glm::dmat4& world) {
  const glm::dvec3 x(world[0]), y(world[1]), z(world[2]);
  // Also false for NaN: every comparison with it fails.
  const bool spansPlane =
      glm::length(glm::cross(x, y)) > 0 || glm::length(glm::cross(y, z)) > 0 || glm::length(glm::cross(z, x)) > 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(world[column][row])) return true;
    }
  }
  return !spansPlane;
}

}  // namespace telar::asset
