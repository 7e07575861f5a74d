#pragma once
#include <functional>

#include "reference/integrator.h"
#include "telar/shot.h"

namespace telar::reference {

struct TraceOptions {
  int samples = 256;       ///< a pixel; the standard error falls as 1 / sqrt(samples)
  std::uint64_t seed = 1;  ///< the same seed gives the same bytes, with any number of threads
  int threads = 1;
  Transport transport;
};

/// The shot of a scene by following light, with the same shading text, lights, camera and output as the raster.
/// @param environment  null where the shot has none
/// @param progress     called with 0..1 from any of the threads, may be empty
/// @throws Error{X_CANCELLED, X_REFERENCE, X_MEMORY, L_LIGHTS, E_SHOT, E_VARIANT}
Frame trace(const Scene& scene, const Shot& shot, const ImageF* environment, const TraceOptions& options,
            const Limits& limits, const CancelToken& cancel, const std::function<void(double)>& progress);

/// Same, before exposure and tone mapping: row 0 on top, premultiplied with coverage, and coverage.
std::vector<glm::vec4> traceRadiance(const Scene& scene, const Shot& shot, const ImageF* environment,
                                     const TraceOptions& options, const Limits& limits, const CancelToken& cancel,
                                     const std::function<void(double)>& progress);

}  // namespace telar::reference
