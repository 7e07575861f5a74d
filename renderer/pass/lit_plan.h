#pragma once
#include <optional>
#include <span>

#include "ibl/environment_cache.h"
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"
#include "pass/stage_timer.h"
#include "telar/renderer.h"

namespace telar::pass {

/// The draws of a picture and the environment that lights them.
struct LitPlan {
  Shot shot;  ///< with the suns of the environment as lights, where they are
  FramePlan plan;
  const ibl::Environment* environment = nullptr;  ///< that lights; null = none
  const ibl::Environment* background = nullptr;   ///< null = none
  std::optional<nlohmann::ordered_json> warning;  ///< of light that the environment has lost
};

/// @param environmentFile  of the shot
/// @param environments  keeps the last four that it was asked for, and a plan points to two at most: two plans may be held
/// @throws Error  of the plan, of the environment
LitPlan planLit(const Scene& scene, const Shot& asked, std::span<const std::byte> environmentFile,
                ibl::EnvironmentCache& environments, GpuScene& gpu, const RendererOptions& options,
                const CancelToken& cancel, StageTimer& timer);

}  // namespace telar::pass
