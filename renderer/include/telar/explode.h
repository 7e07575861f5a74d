#pragma once
#include <memory>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

/// The scene with its parts apart: each node's mesh moves along its mean normal, or away from the model's middle where
/// its normals cancel out, as those of a tube do. Meshes and images are shared with `model`.
/// @param distance  metres
/// @throws Error{X_CANCELLED, X_MEMORY}
std::shared_ptr<const Scene> explodeScene(const std::shared_ptr<const Scene>& model, double distance,
                                          const CancelToken& cancel);

}  // namespace telar
