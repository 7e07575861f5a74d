#pragma once
#include <glm/glm.hpp>
#include <span>

#include "telar/scene.h"

namespace telar::asset {

/// What deforms the primitives of one node at one moment.
struct Deformation {
  std::span<const float> weights;      ///< of the morph targets; missing ones are 0
  std::span<const glm::dmat4> joints;  ///< world matrix * inverse bind matrix by joint; empty = no skin
  glm::dmat4 worldToNode{1.0};         ///< inverse of the node's world matrix
};

/// Whether the deformation changes anything of the primitive.
bool deforms(const Deformation& deformation, const Primitive& primitive);

/// The primitive with its vertices morphed, then skinned, as three.js's vertex stage does, in its floats and in its
/// order, so that Mesa has the same bits: a target adds to position, normal and colour; normals and tangents turn with
/// the skin's own matrix, not with its inverse transpose. Elements that come out not finite are dropped.
/// @param dropped  how many were is added to it
Primitive deformed(const Primitive& source, const Deformation& deformation, std::size_t& dropped);

}  // namespace telar::asset
