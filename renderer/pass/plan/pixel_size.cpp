#include "pass/plan/pixel_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace telar::pass {
namespace {

/// By which a matrix makes something longer, at most: of axes that are square the longest (Gershgorin 1931).
double longestAxis(const glm::dmat4& m) {
  const glm::dmat3 axes(m);
  const glm::dmat3 products = glm::transpose(axes) * axes;
  double most = 0;
  for (int i = 0; i < 3; ++i)
    most = std::max(most, std::abs(products[i].x) + std::abs(products[i].y) + std::abs(products[i].z));
  return std::sqrt(most);
}

}  // namespace

double pixelSize(const FramePlan& plan, const Bounds& bounds, const Shot& shot) {
  const double atOne = 2 / (plan.camera.projection[1][1] * shot.height);
  if (plan.camera.orthographic) return atOne;
  double depth = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : bounds.corners())
    depth = std::min(depth, -(plan.camera.view * glm::dvec4(corner, 1)).z);
  return atOne * std::max(depth, shot.camera.near);
}

double scaleOf(const DrawItem& item) {
  const double own = longestAxis(item.node->world);
  if (!item.instances()) return own;
  double most = 0;
  for (const auto& matrix : item.instances()->matrices) most = std::max(most, longestAxis(glm::dmat4(matrix)));
  return own * most;
}

}  // namespace telar::pass
