#pragma once
#include <vector>

#include "reference/tracer.h"

namespace telar::reference {

/// All layers of a shot but coverage and lines, in its order, by a ray through the centre of each pixel; ambient
/// occlusion by as many rays as the shot has samples. The camera is a pinhole.
/// @throws Error{X_CANCELLED, X_REFERENCE, X_MEMORY, L_LIGHTS, E_VARIANT}
std::vector<LayerImage> traceLayers(const Scene& scene, const Shot& shot, const TraceOptions& options,
                                    const Limits& limits, const CancelToken& cancel);

}  // namespace telar::reference
