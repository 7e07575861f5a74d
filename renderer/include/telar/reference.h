#pragma once
#include <span>
#include <string>

#include "telar/progress.h"
#include "telar/renderer.h"

namespace telar {

/// Draws one frame by following paths of light (shot.reference says how), on threads of its own and without GL. Loads
/// libtelar_reference.so, which alone links Embree.
/// @param environment  file bytes when shot.environment.source is kBytes
/// @throws Error{X_LIBRARY_MISSING, X_REFERENCE, X_MEMORY, X_CANCELLED, L_LIGHTS, E_ENVIRONMENT_*, ...}; never a
/// partial
///         frame
Frame drawReference(const Scene& scene, const Shot& shot, std::span<const std::byte> environment,
                    const RendererOptions& options, const CancelToken& cancel, const Progress& progress,
                    FrameInfo& info);

/// Whether such frames can be drawn here: {works, version} or {works: false, failure} as JSON. Never throws.
std::string probeReference();

}  // namespace telar
