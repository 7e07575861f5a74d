#pragma once
#include <cstddef>
#include <vector>

#include "frame/camera.h"
#include "telar/limits.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::pass {

/// Which lights a frame has: `maxLights` of the quality, the strongest ones. And which of them light surfaces of the
/// scene: they are neither black nor of intensity 0, and the scene is within their range.
struct LightChoice {
  std::vector<bool> ofShot;                 ///< by light of the shot
  std::vector<bool> ofNodes;                ///< by node of the scene: it has a light
  std::vector<bool> litByShot, litByNodes;  ///< of these: the light lights surfaces

  /// All of them, or those that give the middle of the scene's bounds the most light. Ambient and hemisphere lights,
  /// and lights that shine on nothing and cast a shadow on the ground, are there always and do not count. Of lights of
  /// one strength the first ones are taken, the shot's before the model's.
  /// @throws Error{L_LIGHTS}
  LightChoice(const Scene& scene, const Shot& shot, const frame::Camera& camera, const Limits& limits);
  /// How many lights there are.
  std::size_t count() const;
};

}  // namespace telar::pass
