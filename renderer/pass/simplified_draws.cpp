#include "pass/simplified_draws.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace telar::pass {
namespace {

/// Size of a pixel where the model is next to the camera, metres.
double pixelSize(const FramePlan& plan, const Bounds& bounds, const Shot& shot) {
  const double atOne = 2 / (plan.camera.projection[1][1] * shot.height);
  if (plan.camera.orthographic) return atOne;
  double depth = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : bounds.corners())
    depth = std::min(depth, -(plan.camera.view * glm::dvec4(corner, 1)).z);
  return atOne * std::max(depth, shot.camera.near);
}

double longestAxis(const glm::dmat4& m) {
  return std::max({glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))});
}

/// How many times larger than in its mesh an item is drawn, at most.
double scaleOf(const DrawItem& item) {
  const double own = longestAxis(item.node->world);
  if (!item.instances()) return own;
  double most = 0;
  for (const auto& matrix : item.instances()->matrices) most = std::max(most, longestAxis(glm::dmat4(matrix)));
  return own * most;
}

bool mayBeSimplified(const DrawItem& item) {
  return item.primitive->topology == Topology::kTriangles && !item.primitive->deformers;
}

std::array<std::vector<DrawItem>*, 5> listsOf(DrawList& draws) {
  return {&draws.behind, &draws.behindBackSides, &draws.opaque, &draws.transmissive, &draws.blended};
}

}  // namespace

void limitDetail(FramePlan& plan, const Scene& scene, const Shot& shot, GpuScene& gpu, const CancelToken& cancel) {
  gpu.limitTextures(shot.textureSize);
  if (shot.geometryError <= 0) return;
  const double error = shot.geometryError * pixelSize(plan, scene.bounds, shot);
  // One form of a mesh a frame, whatever draws it.
  std::map<const Primitive*, double> errors;
  for (const auto* list : listsOf(plan.draws)) {
    for (const DrawItem& item : *list) {
      if (!mayBeSimplified(item)) continue;
      const auto [found, isNew] = errors.try_emplace(item.primitive, error / scaleOf(item));
      if (!isNew) found->second = std::min(found->second, error / scaleOf(item));
    }
  }
  for (auto* list : listsOf(plan.draws)) {
    for (DrawItem& item : *list) {
      const auto found = errors.find(item.primitive);
      if (found != errors.end()) item.primitive = &gpu.simplified(*item.primitive, found->second, cancel);
    }
  }
}

}  // namespace telar::pass
