#pragma once
#include <vector>

#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::pass {

/// Which lights of a frame shade: `maxLights` of the quality, the strongest ones.
struct LightChoice {
  std::vector<bool> ofShot;   ///< by light of the shot
  std::vector<bool> ofNodes;  ///< by node of the scene: it has a light that shades

  /// All of them, or those that give the middle of the scene's bounds the most light. Ambient and hemisphere lights,
  /// and lights that shine on nothing and cast a shadow on the ground, are there always and do not count. Of lights of
  /// one strength the first ones are taken, the shot's before the model's.
  LightChoice(const Scene& scene, const Shot& shot);
  /// How many lights there are.
  std::size_t count() const;
};

}  // namespace telar::pass
