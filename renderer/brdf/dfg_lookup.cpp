#include "brdf/dfg_lookup.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace telar::brdf {
namespace {

constexpr std::uint16_t DFG_TABLE[DFG_SIZE * DFG_SIZE * 2] = {
#include "brdf/dfg_table.inc"
};

glm::vec2 texel(int x, int y) {
  const int at = (std::clamp(y, 0, DFG_SIZE - 1) * DFG_SIZE + std::clamp(x, 0, DFG_SIZE - 1)) * 2;
  return {glm::unpackHalf1x16(DFG_TABLE[at]), glm::unpackHalf1x16(DFG_TABLE[at + 1])};
}

}  // namespace

const std::uint16_t* dfgHalfs() { return DFG_TABLE; }

glm::vec2 dfgLookup(float perceptualRoughness, float NoV) {
  const glm::vec2 at = glm::vec2(perceptualRoughness, NoV) * static_cast<float>(DFG_SIZE) - 0.5f;
  const glm::vec2 low = glm::floor(at), part = at - low;
  const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
}

}  // namespace telar::brdf
