#pragma once
#include <algorithm>
#include <limits>

#include "pass/draw_list.h"

namespace telar::pass {

/// Size of a pixel where a box is next to the camera, metres.   bounds  world space
inline double pixelSize(const FramePlan& plan, const Bounds& bounds, const Shot& shot) {
  const double atOne = 2 / (plan.camera.projection[1][1] * shot.height);
  if (plan.camera.orthographic) return atOne;
  double depth = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : bounds.corners())
    depth = std::min(depth, -(plan.camera.view * glm::dvec4(corner, 1)).z);
  return atOne * std::max(depth, shot.camera.near);
}

/// How many times larger than in its mesh an item is drawn, at most.
double scaleOf(const DrawItem& item);

}  // namespace telar::pass
