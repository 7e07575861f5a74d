#pragma once
#include <compare>
#include <cstdint>

#include "telar/shading_terms.inc"

namespace telar {

/// How light and cloth meet: the key `shading` of a shot.
enum class ShadingModel : std::uint8_t {
  kThree,       ///< what three.js 0.187 shows
  kThreeR115,   ///< what three.js r115 showed, as the thesis lists it
  kDisney2012,  ///< Burley 2012, "Physically-Based Shading at Disney"
  kFabric,      ///< telar's model of cloth
};

/// One term for every slot of the principled shadings: numbers within the lists of js/shot/shading_terms.mjs. As it
/// stands it is three-r115.
struct ShadingTerms {
#define TELAR_SHADING_NUMBER(define, number) define = number,
  enum Number { TELAR_SHADING_TERMS(TELAR_SHADING_NUMBER) };
#undef TELAR_SHADING_NUMBER

#define TELAR_SHADING_MEMBER(define, member, ...) int member = 0;
  TELAR_SHADING_SLOTS(TELAR_SHADING_MEMBER)
#undef TELAR_SHADING_MEMBER

  auto operator<=>(const ShadingTerms&) const = default;
};

/// Whether a shading is made of terms.
inline bool isPrincipled(ShadingModel shading) {
  return shading == ShadingModel::kThreeR115 || shading == ShadingModel::kDisney2012;
}

}  // namespace telar
