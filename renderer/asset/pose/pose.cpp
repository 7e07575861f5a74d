#include "telar/pose.h"

#include <algorithm>
#include <new>

#include "asset/pose/place.h"
#include "asset/pose/sample.h"

namespace telar {
namespace {

const Animation& animationOf(const Scene& scene, const Pose& pose) {
  const std::size_t count = scene.motion ? scene.motion->animations.size() : 0;
  if (pose.animation >= 0 && static_cast<std::size_t>(pose.animation) < count) {
    return scene.motion->animations[static_cast<std::size_t>(pose.animation)];
  }
  throw Error("E_POSE", "shot.pose.animation: the model has no animation " + std::to_string(pose.animation) +
                            "; it has " + std::to_string(count));
}

void apply(const AnimationChannel& channel, double time, Node& node) {
  const std::vector<double> value = asset::sample(channel.sampler, channel.path, time);
  switch (channel.path) {
    case AnimationPath::kTranslation:
      node.transform.translation = {value[0], value[1], value[2]};
      break;
    case AnimationPath::kRotation:
      node.transform.rotation = {value[0], value[1], value[2], value[3]};
      break;
    case AnimationPath::kScale:
      node.transform.scale = {value[0], value[1], value[2]};
      break;
    case AnimationPath::kWeights:
      node.weights.assign(value.begin(), value.end());
      break;
  }
}

}  // namespace

std::shared_ptr<const Scene> poseScene(const std::shared_ptr<const Scene>& model, const Pose& pose,
                                       const CancelToken& cancel) {
  const std::shared_ptr<const Scene>& source = model->model ? model->model : model;
  const Animation& animation = animationOf(*source, pose);
  try {
    auto out = std::make_shared<Scene>(*source);
    out->model = source;
    const double time = std::clamp(pose.time, 0.0, animation.duration);
    for (const AnimationChannel& channel : animation.channels) {
      apply(channel, time, out->nodes[static_cast<std::size_t>(channel.node)]);
    }
    out->warnings.resize(out->fileWarnings);
    asset::Warnings warnings(std::move(out->warnings));
    asset::place(*out, warnings, cancel);
    out->warnings = warnings.take();
    asset::needGeometry(*out);
    return out;
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory to pose the model");
  }
}

}  // namespace telar
