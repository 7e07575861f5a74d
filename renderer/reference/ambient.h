#pragma once
#include "core/random.h"
#include "reference/placed_scene.h"
#include "reference/plugin.h"

namespace telar::reference {

/// Ambient occlusion: part of the hemisphere above a point that is open to infinity, weighted by the cosine.
/// @param from    its directions are not read
/// @param normal  unit
/// @param sample  first one to draw: those of one seed and pixel fill the hemisphere evenly
float openPart(const Geometry& geometry, Rays from, const glm::vec3& normal, const Random& sample, int count);

/// Finds job.open.
void findAmbient(AmbientJob& job);

}  // namespace telar::reference
