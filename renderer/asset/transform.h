#pragma once
#include <glm/glm.hpp>
#include <string>

#include "asset/tinygltf_model.h"

namespace telar::asset {

/// A node's local matrix in double; rotations are used as they are, as three.js does (Matrix4.compose).
/// @throws Error{E_SCHEMA} where matrix and translation, rotation or scale are both given, or the rotation is zero
glm::dmat4 localMatrix(const tinygltf::Node& node, const std::string& where);

/// Whether the matrix squeezes every body to a line or a point, or is not finite.
bool isCollapsed(const glm::dmat4& world);

}  // namespace telar::asset
