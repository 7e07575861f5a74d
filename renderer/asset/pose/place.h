#pragma once
#include "asset/check/warnings.h"
#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar::asset {

/// Makes everything that follows from the nodes' transforms and weights: matrices, which nodes draw, deformed meshes,
/// bounds and sums. A draw that leaves the range of fp32 is not drawn. What was made before is replaced.
/// @throws Error{X_CANCELLED}
void place(Scene& scene, Warnings& warnings, const CancelToken& cancel);

/// @throws Error{E_NO_GEOMETRY} where a placed scene draws no more than a point
void needGeometry(const Scene& scene);

}  // namespace telar::asset
