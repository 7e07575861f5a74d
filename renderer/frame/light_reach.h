#pragma once
#include <glm/glm.hpp>

#include "frame/camera.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::frame {

/// Whether a point or spot light may reach anything of a picture. One that does not adds exactly 0 to every fragment:
/// its falloff is 0 from its range on (distanceAttenuation() of shaders/brdf/light.glsl). Shaders find distances in
/// single precision, whose rounding is allowed for; and at rims they shade places beside the model, which lie anywhere
/// on the line of sight of a pixel: where they do, no such line may meet what the light reaches.
/// @param position  world, metres    @param range  metres; 0 = without end
bool reaches(const Scene& scene, const Shot& shot, const Camera& camera, const glm::dvec3& position, double range);

}  // namespace telar::frame
