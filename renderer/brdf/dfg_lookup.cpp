#include "brdf/dfg_lookup.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "brdf/brdf.h"

namespace telar::brdf {
namespace {

constexpr int SIZE_16 = 16, SIZE_32 = 32;

constexpr std::uint16_t TABLE_16[SIZE_16 * SIZE_16 * 2] = {
#include "brdf/dfg_table.inc"
};

constexpr std::uint16_t TABLE_32[SIZE_32 * SIZE_32 * 2] = {
#include "brdf/dfg_table_32.inc"
};

glm::vec2 texel(const DfgTable& table, int x, int y) {
  const int last = table.size - 1;
  const std::uint16_t* at = table.halfs + (std::clamp(y, 0, last) * table.size + std::clamp(x, 0, last)) * 2;
  return {glm::unpackHalf1x16(at[0]), glm::unpackHalf1x16(at[1])};
}

glm::vec2 bilinear(const DfgTable& table, float perceptualRoughness, float NoV) {
  const glm::vec2 at = glm::vec2(perceptualRoughness, NoV) * static_cast<float>(table.size) - 0.5f;
  const glm::vec2 low = glm::floor(at), part = at - low;
  const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
  return glm::mix(glm::mix(texel(table, x, y), texel(table, x + 1, y), part.x),
                  glm::mix(texel(table, x, y + 1), texel(table, x + 1, y + 1), part.x), part.y);
}

glm::vec2 dfgLookup32(float perceptualRoughness, float NoV) {
  return bilinear({SIZE_32, TABLE_32}, perceptualRoughness, NoV);
}

}  // namespace

DfgTable dfgTableOf(const ThreeTerms& three) {
  return three.dfg == ThreeTerms::THREE_DFG_TABLE_32 ? DfgTable{SIZE_32, TABLE_32} : DfgTable{SIZE_16, TABLE_16};
}

glm::vec2 dfgLookup(float perceptualRoughness, float NoV) {
  return bilinear({SIZE_16, TABLE_16}, perceptualRoughness, NoV);
}

DfgLookup dfgOf(const ThreeTerms& three) {
  if (three.dfg == ThreeTerms::THREE_DFG_KARIS) return brdf_f::dfgKaris;
  return three.dfg == ThreeTerms::THREE_DFG_TABLE_32 ? dfgLookup32 : dfgLookup;
}

}  // namespace telar::brdf
