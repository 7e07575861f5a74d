#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/part_query.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

/// What a part measures as one JSON object, for resolveShot: {found, bounds: {min, max} | null, outline: [[x, y, z],
/// ...]}, metres in world space as describeScene() has them. Where the part draws nothing bounds is null, and `names`
/// lists what there is in its place, at most PART_NAMES_MAX of them in the file's order.
/// @param ghost  of the shot: what it leaves out does not count
/// @throws Error{E_FRAME (the model draws no such ghost), X_CANCELLED}
std::string describePart(const Scene& scene, const PartQuery& query, const std::vector<Shot::Ghost>& ghost,
                         const CancelToken& cancel);

/// What a shot with ghosts shows, as one JSON object: {bounds: {min, max} | null, outline}, as describeScene() has them
/// of all that the model draws.
/// @param variant  KHR_materials_variants name; empty = none
/// @throws Error{E_FRAME (the model draws no such ghost), X_CANCELLED}
std::string describeShown(const Scene& scene, const std::string& variant, const std::vector<Shot::Ghost>& ghost,
                          const CancelToken& cancel);

/// From where to where a shot with ghosts shows something along each axis, of all drawn vertices: [[low, high], ...] as JSON, metres;
/// null where nothing is drawn. The outline of describeShown() is exact along its own directions alone.
/// @param axes  of unit length
/// @param variant  KHR_materials_variants name; empty = none
/// @throws Error{E_FRAME (the model draws no such ghost), X_CANCELLED}
std::string describeRanges(const Scene& scene, const std::array<glm::dvec3, 3>& axes, const std::string& variant,
                           const std::vector<Shot::Ghost>& ghost, const CancelToken& cancel);

constexpr std::size_t PART_NAMES_MAX = 256;

}  // namespace telar
