#pragma once
#include <nlohmann/json.hpp>

#include "ibl/environment_cache.h"
#include "pass/plan/draw_list.h"
#include "pass/stage_timer.h"
#include "pass/visible/visibility_buffer.h"
#include "pass/visible/visible_draws.h"

namespace telar::pass {

/// What draws, for doctor.
nlohmann::ordered_json describeContext(const gl::Context& context);

/// What a plan compiles and runs, for info and `telar inspect`.
nlohmann::ordered_json describePlan(const FramePlan& plan, const Shot& shot);

/// What a picture has, and leaves out.
struct FrameCounts {
  const VisibilityBuffer::Count& buffered;  ///< no triangles where it was drawn triangle by triangle
  const TriangleCount& drawn;
  const TexelCount texels;  ///< GpuScene
};

/// The same with what was drawn by what, for info.
nlohmann::ordered_json describeFrame(const FramePlan& plan, const Shot& shot, const ibl::Environment* environment,
                                     const gl::Context& context, const FrameCounts& counts, const StageTimer& timer);

/// The shot with a directional light for each sun.
Shot withSuns(Shot shot, const ibl::Suns& suns);

/// three.js clamps an environment to half floats, and so does the shading "three".
/// @param share  of the map's light that is lost
nlohmann::ordered_json rangeWarning(double share);

}  // namespace telar::pass
