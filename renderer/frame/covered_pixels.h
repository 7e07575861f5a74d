#pragma once
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::frame {

/// Pixels of a picture that a scene covers, about: the areas of the triangles that turn one way, which count twice
/// where they hide each other, and no more than the picture has. It looks at each triangle once; of instances at the
/// first 1000.
double coveredPixels(const Scene& scene, const Shot& shot);

}  // namespace telar::frame
