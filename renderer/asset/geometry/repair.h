#pragma once
#include <vector>

#include "telar/scene.h"

namespace telar::asset {

/// Largest coordinate that is drawn, metres: squares and products of two stay finite in fp32.
constexpr float COORDINATE_MAX = 1e18f;

bool isFinite(const glm::vec3& v);

bool isDrawable(const glm::vec3& position);

/// Vertices whose position is not drawable; their positions are set to 0. Empty where all are good.
std::vector<bool> findBadVertices(std::vector<glm::vec3>& positions);

/// What follows makes values usable in shaders and returns how many changed.

/// Normals that are not finite or of zero length become the mean normal of the triangles around the vertex (+Z where
/// there is none); those whose length fp32 cannot square are normalized. All others stay as they are.
std::size_t repairNormals(Primitive& primitive);
/// Tangents that are not finite become 0, which is none: the frame of their triangles is that of the texture's
/// coordinates (shaders/material/normal.glsl). w becomes +-1.
std::size_t repairTangents(Primitive& primitive);
/// Coordinates that are not finite, or beyond COORDINATE_MAX, become 0.
std::size_t repairUvs(std::vector<glm::vec2>& uvs);
/// Components that are not finite become 1; the others are clamped to [0, 65504], the largest half.
std::size_t repairColors(std::vector<glm::vec4>& colors);
std::size_t repairColors(std::vector<glm::vec3>& colors);
/// Directions that are not finite or too long for one become 0, which is the normal. An open part is clamped to [0, 1],
/// and is 1 where it is not finite.
std::size_t repairVisibility(std::vector<glm::vec4>& visibility);

}  // namespace telar::asset
