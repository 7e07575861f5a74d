#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace telar::brdf {

/// Texels on a side of the table.
constexpr int DFG_SIZE = 16;

/// The table as halfs, (A, B) a texel; x (fastest) = perceptualRoughness, y = NoV.
const std::uint16_t* dfgHalfs();

/// (A, B) of the split sum as a shader reads the table: bilinear, clamped at the edges.
/// @param perceptualRoughness, NoV  [0, 1]
glm::vec2 dfgLookup(float perceptualRoughness, float NoV);

}  // namespace telar::brdf
