#pragma once
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// Finds the draws of cut-out cloth that no texel has as a whole at the sampler's level: from far a net is there in part
/// almost everywhere (material/coverage.glsl), and is drawn once, blended. Meshes that morph or have bones are not looked at.
/// @throws Error{X_CANCELLED}
void findPartial(FramePlan& plan, const Scene& scene, const Shot& shot, const GpuScene& gpu, const CancelToken& cancel);

}  // namespace telar::pass
