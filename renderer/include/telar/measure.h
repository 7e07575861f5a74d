#pragma once
#include <string>
#include <string_view>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

/// Lengths on what a scene draws, in metres of world space. The request, which js/api/measure.mjs writes:
/// {variant: string, part: {kind: "node" | "material", which: number | string} | null, join: metres, ask:
///   {kind: "points", along: "straight" | "surface", closed, points:
///     [{position} | {node, primitive, triangle, weights} | {node, primitive, vertex}, ...]} |
///   {kind: "girth", point, normal, tight} | {kind: "border"}}
/// @return JSON as Model.measure() documents it
/// @throws Error{E_MEASURE, L_MEASURE, L_TRIANGLES, X_CANCELLED, X_TIMEOUT}
std::string measureScene(const Scene& scene, std::string_view request, const CancelToken& cancel);

}  // namespace telar
