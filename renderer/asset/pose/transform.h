#pragma once
#include <glm/glm.hpp>

#include "asset/document/tinygltf_model.h"
#include "telar/motion.h"

namespace telar::asset {

/// A node's translation, rotation and scale; a matrix is taken apart as three.js does it (Matrix4.decompose), which
/// loses shear.
Transform transformOf(const tinygltf::Node& node);

/// Matrix in double; rotations are used as they are, as three.js does (Matrix4.compose).
glm::dmat4 matrixOf(const Transform& transform);

/// Whether the matrix squeezes every body to a line or a point, or is not finite.
bool isCollapsed(const glm::dmat4& world);

}  // namespace telar::asset
