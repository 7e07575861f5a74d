#pragma once
#include <optional>
#include <span>
#include <string>

#include "telar/progress.h"
#include "telar/renderer.h"

namespace telar {

/// Draws one frame by following paths of light (shot.reference says how), on threads of its own and without GL. Loads
/// libtelar_reference.so, which alone links Embree.
/// @param environment  file bytes when shot.environment.source is kBytes
/// @throws Error{X_LIBRARY_MISSING, X_REFERENCE, X_MEMORY, X_CANCELLED, L_LIGHTS, E_ENVIRONMENT_*, ...}; never a
///         partial frame
Frame drawReference(const Scene& scene, const Shot& shot, std::span<const std::byte> environment,
                    const RendererOptions& options, const CancelToken& cancel, const Progress& progress,
                    FrameInfo& info);

/// Whether the path tracer shows all that the raster does: no points or lines, no glass, no texture in blocks that only a GPU
/// reads; and as the raster does: no ghosts, which cast no shadow there.
bool isTraceable(const Scene& scene, const Shot& shot);

/// A shot of quality "high" as one of the path tracer, where that costs less than the raster's passes and shows the
/// same: light that arrives directly, as many paths as there were samples at most, the same standard error to stop at.
/// It goes by counts and never by a clock, so that a shot is drawn the same way on each machine that has Embree;
/// renderFrame() lets the raster draw it elsewhere, with the warning W_LIBRARY_MISSING.
/// @return nothing where the raster is to draw it
std::optional<Shot> tracedInstead(const Scene& scene, const Shot& shot);

/// Whether such frames can be drawn here: {works, version} or {works: false, failure} as JSON. Never throws.
std::string probeReference();

}  // namespace telar
