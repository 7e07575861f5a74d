#pragma once
#include "reference/integrator.h"
#include "reference/plugin.h"
#include "telar/shot.h"

namespace telar::reference {

struct TraceOptions {
  int samples = 256;       ///< a pixel; the standard error falls as 1 / sqrt(samples)
  std::uint64_t seed = 1;  ///< the same seed gives the same bytes, with any number of threads
  int threads = 1;         ///< at least 1
  Transport transport;
};

/// What shot.reference asks for.
TraceOptions optionsOf(const Shot& shot);

/// Draws a shot by path tracing, with the shading text, lights, camera and output of the raster.
/// @param environment  null where the shot has none
/// @param progress     told of each row
/// @param facts        filled where not null
/// @throws Error{X_CANCELLED, X_REFERENCE, X_MEMORY, L_LIGHTS, E_SHOT, E_VARIANT}
Frame trace(const Scene& scene, const Shot& shot, const ImageF* environment, const TraceOptions& options,
            const Limits& limits, const CancelToken& cancel, const Progress& progress, TraceFacts* facts = nullptr);

/// The same before exposure and tone mapping: row 0 on top, premultiplied with coverage, and coverage.
std::vector<glm::vec4> traceRadiance(const Scene& scene, const Shot& shot, const ImageF* environment,
                                     const TraceOptions& options, const Limits& limits, const CancelToken& cancel,
                                     const Progress& progress, TraceFacts* facts = nullptr);

}  // namespace telar::reference
