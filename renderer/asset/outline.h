#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "telar/scene.h"

namespace telar::asset {

/// The drawn vertices that lie farthest in each of 98 fixed directions, world space, without repeats: what a camera
/// needs to frame the model itself and not its box. Empty for a scene that draws nothing. The directions are those of
/// js/shot/outline.mjs, which does the same for a model in the browser.
std::vector<glm::dvec3> outlineOf(const Scene& scene);

}  // namespace telar::asset
