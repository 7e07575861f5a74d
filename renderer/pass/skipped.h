#pragma once
#include <nlohmann/json.hpp>

#include "pass/describe.h"

namespace telar::pass {

/// What a picture leaves out, for the scene does not need it, against all forced on: [{what, count, of, ...saving}].
/// Counts, bytes and texels are exact. `estimatedPart` is by how much longer its fragments would have taken to draw, in
/// parts of the time that they took: by what was measured of others, of triangles by the pixels that they cover.
/// @param described  of describePlan(): the features and passes that the picture has
nlohmann::ordered_json describeSkipped(const FramePlan& plan, const FrameCounts& counts,
                                       const nlohmann::ordered_json& described);

}  // namespace telar::pass
