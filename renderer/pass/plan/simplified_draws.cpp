#include "pass/plan/simplified_draws.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pass/plan/partial_coverage.h"
#include "pass/plan/pixel_size.h"

namespace telar::pass {
namespace {

bool mayBeSimplified(const DrawItem& item) {
  return item.primitive->topology == Topology::kTriangles && !item.primitive->deformers;
}

std::array<std::vector<DrawItem>*, 5> listsOf(DrawList& draws) {
  return {&draws.behind, &draws.behindBackSides, &draws.opaque, &draws.transmissive, &draws.blended};
}

/// @param error  metres, next to the camera
void simplify(DrawList& draws, double error, GpuScene& gpu, const CancelToken& cancel) {
  // One form of a mesh a frame, whatever draws it.
  std::map<const Primitive*, double> errors;
  for (const auto* list : listsOf(draws)) {
    for (const DrawItem& item : *list) {
      if (!mayBeSimplified(item)) continue;
      const auto [found, isNew] = errors.try_emplace(item.primitive, error / scaleOf(item));
      if (!isNew) found->second = std::min(found->second, error / scaleOf(item));
    }
  }
  for (auto* list : listsOf(draws)) {
    for (DrawItem& item : *list) {
      const auto found = errors.find(item.primitive);
      if (found != errors.end()) item.primitive = &gpu.simplified(*item.primitive, found->second, cancel);
    }
  }
}

}  // namespace

void limitDetail(FramePlan& plan, const Scene& scene, const Shot& shot, GpuScene& gpu, const CancelToken& cancel) {
  gpu.limitTextures(shot.textureSize);
  if (shot.geometryError > 0)
    simplify(plan.draws, shot.geometryError * pixelSize(plan, scene.bounds, shot), gpu, cancel);
  findPartial(plan, scene, shot, gpu, cancel);
}

}  // namespace telar::pass
