#pragma once
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// Has the plan draw no more detail than the shot's quality asks for: textures of at most `textureSize` texels, and
/// meshes of fewer triangles where `geometryError` allows it. Those that morph or have bones, and points and lines, are
/// drawn as they are. Nets that are there in part everywhere are drawn once (partial_coverage.h).
/// @throws Error{X_LIBRARY_MISSING, X_CANCELLED}
void limitDetail(FramePlan& plan, const Scene& scene, const Shot& shot, GpuScene& gpu, const CancelToken& cancel);

}  // namespace telar::pass
