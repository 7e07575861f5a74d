#pragma once
#include <memory>

#include "telar/cancel.h"
#include "telar/motion.h"
#include "telar/scene.h"

namespace telar {

/// The scene as it stands at a moment of one of its animations: as three.js 0.187 shows it with an AnimationMixer whose
/// one action plays once and clamps (LoopOnce, clampWhenFinished). Nodes, skinned and morphed vertices, bounds and sums
/// are those of the pose; images and meshes that do not deform are shared with `model`.
/// @param model as loaded, or a pose of it: the pose does not build upon another one
/// @throws Error{E_POSE, E_NO_GEOMETRY, X_CANCELLED, X_MEMORY}
std::shared_ptr<const Scene> poseScene(const std::shared_ptr<const Scene>& model, const Pose& pose,
                                       const CancelToken& cancel);

}  // namespace telar
