#pragma once
#include <compare>
#include <cstdint>

#include "telar/shading_terms.inc"
#include "telar/three_terms.inc"

namespace telar {

/// How light and cloth meet: the key `shading` of a shot.
enum class ShadingModel : std::uint8_t {
  kThree,       ///< what three.js shows: 0.187, or another release by its ThreeTerms
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

/// One term for every slot in which releases of three.js differ, for the shading kThree: numbers within the lists of
/// js/shot/three_terms.mjs. As it stands it is three.js 0.187.
struct ThreeTerms {
#define TELAR_THREE_NUMBER(define, number) define = number,
  enum Number { TELAR_THREE_TERMS(TELAR_THREE_NUMBER) };
#undef TELAR_THREE_NUMBER

#define TELAR_THREE_MEMBER(define, member, ...) int member = 0;
  TELAR_THREE_SLOTS(TELAR_THREE_MEMBER)
#undef TELAR_THREE_MEMBER

  auto operator<=>(const ThreeTerms&) const = default;
};

/// Whether a shading is made of terms.
inline bool isPrincipled(ShadingModel shading) {
  return shading == ShadingModel::kThreeR115 || shading == ShadingModel::kDisney2012;
}

}  // namespace telar
