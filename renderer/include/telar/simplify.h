#pragma once
#include <optional>

#include "telar/scene.h"

namespace telar {

/// Triangles with fewer of them in their place: corners are moved onto others until one would lie further than `error`
/// off. Vertices are some of the given ones, with all their streams; seams of these stay. Borders move as surfaces do.
/// @param primitive  of triangles
/// @param error  mesh space, above 0
/// @return none where no fifth of the triangles goes
/// @throws Error{X_LIBRARY_MISSING}
std::optional<Primitive> simplified(const Primitive& primitive, double error);

}  // namespace telar
