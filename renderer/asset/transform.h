#pragma once
#include <glm/glm.hpp>

#include "asset/tinygltf_model.h"

namespace telar::asset {

/// A node's local matrix in double; rotations are used as they are, as three.js does (Matrix4.compose).
glm::dmat4 localMatrix(const tinygltf::Node& node);

/// Whether the matrix squeezes every body to a line or a point, or is not finite.
bool isCollapsed(const glm::dmat4& world);

}  // namespace telar::asset
