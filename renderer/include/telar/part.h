#pragma once
#include <string>

#include "telar/cancel.h"
#include "telar/part_query.h"
#include "telar/scene.h"

namespace telar {

/// What a part measures as one JSON object, for resolveShot: {found, bounds: {min, max} | null, outline: [[x, y, z],
/// ...]}, metres in world space as describeScene() has them. Where the part draws nothing bounds is null, and `names`
/// lists what there is in its place, at most PART_NAMES_MAX of them in the file's order.
/// @throws Error{X_CANCELLED}
std::string describePart(const Scene& scene, const PartQuery& query, const CancelToken& cancel);

constexpr std::size_t PART_NAMES_MAX = 256;

}  // namespace telar
