#pragma once
#include <vector>

#include "telar/scene.h"

namespace telar {

/// Gives a triangle primitive one tangent a corner. A vertex whose corners disagree, bit for bit, is repeated after the
/// last one of each stream; the first tangent met keeps the vertex.
/// @param tangents  by corner, in the order of source.indices (of the vertices when there are none); a vertex that no
///                  corner names gets (1, 0, 0, 1)
Primitive withCornerTangents(const Primitive& source, const std::vector<glm::vec4>& tangents);

}  // namespace telar
