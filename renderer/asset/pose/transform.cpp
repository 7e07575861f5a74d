#include "asset/pose/transform.h"

#include <cmath>

namespace telar::asset {
namespace {

/// Rotation matrix of a quaternion (x, y, z, w). A quaternion that is not of unit length shears and scales.
glm::dmat3 rotationMatrix(const glm::dvec4& q) {
  const double x = q.x, y = q.y, z = q.z, w = q.w;
  return glm::dmat3(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),   // column 0
                    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),   // column 1
                    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));  // column 2
}

/// Quaternion of a rotation matrix, by the largest of its components.
/// src: Shepperd 1978, "Quaternion from Rotation Matrix", J. Guidance and Control 1(3)
glm::dvec4 quaternionOf(const glm::dmat3& m) {
  const double trace = m[0][0] + m[1][1] + m[2][2];
  if (trace > 0) {
    const double s = 2 * std::sqrt(trace + 1);
    return {(m[1][2] - m[2][1]) / s, (m[2][0] - m[0][2]) / s, (m[0][1] - m[1][0]) / s, s / 4};
  }
  const int i = m[0][0] > m[1][1] && m[0][0] > m[2][2] ? 0 : m[1][1] > m[2][2] ? 1 : 2;
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const double s = 2 * std::sqrt(1 + m[i][i] - m[j][j] - m[k][k]);
  glm::dvec4 q;
  q[i] = s / 4;
  q[j] = (m[i][j] + m[j][i]) / s;
  q[k] = (m[i][k] + m[k][i]) / s;
  q.w = (m[j][k] - m[k][j]) / s;
  return q;
}

Transform decomposed(const std::vector<double>& matrix) {
  const auto column = [&](std::size_t i) { return glm::dvec3(matrix[4 * i], matrix[4 * i + 1], matrix[4 * i + 2]); };
  glm::dmat3 linear(column(0), column(1), column(2));
  Transform out;
  out.translation = column(3);
  const double determinant = glm::determinant(linear);
  if (determinant == 0) return out;  // three.js leaves such a node unscaled and unturned
  for (int i = 0; i < 3; ++i) out.scale[i] = glm::length(linear[i]);
  if (determinant < 0) out.scale.x = -out.scale.x;
  for (int i = 0; i < 3; ++i) linear[i] /= out.scale[i];
  out.rotation = quaternionOf(linear);
  return out;
}

}  // namespace

Transform transformOf(const tinygltf::Node& node) {
  if (!node.matrix.empty()) return decomposed(node.matrix);
  Transform out;
  const auto& q = node.rotation;
  if (!q.empty()) out.rotation = {q[0], q[1], q[2], q[3]};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!node.scale.empty()) out.scale[i] = node.scale[k];
    if (!node.translation.empty()) out.translation[i] = node.translation[k];
  }
  return out;
}

glm::dmat4 matrixOf(const Transform& transform) {
  glm::dmat4 out(rotationMatrix(transform.rotation));
  for (int i = 0; i < 3; ++i) out[i] *= transform.scale[i];
  out[3] = glm::dvec4(transform.translation, 1);
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
