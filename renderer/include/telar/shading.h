#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <string_view>
#include <utility>

#include "telar/shading_names.inc"
#include "telar/shading_terms.inc"
#include "telar/three_terms.inc"

namespace telar {

/// How light and cloth meet: the key `shading` of a shot. kThree is what three.js shows, of 0.187 or of another release
/// by its ThreeTerms; kFabric telar's model of cloth. The others are principled and made of ShadingTerms:
/// js/docs/shading.md says where they are from.
enum class ShadingModel : std::uint8_t {
#define TELAR_SHADING_ENUMERATOR(enumerator, name) enumerator,
  TELAR_WHOLE_SHADINGS(TELAR_SHADING_ENUMERATOR) TELAR_PRINCIPLED_SHADINGS(TELAR_SHADING_ENUMERATOR)
#undef TELAR_SHADING_ENUMERATOR
};

#define TELAR_SHADING_NAME(enumerator, name) std::pair<std::string_view, ShadingModel>{name, ShadingModel::enumerator},
/// Names of the shadings that are whole.
constexpr auto WHOLE_SHADINGS = std::to_array({TELAR_WHOLE_SHADINGS(TELAR_SHADING_NAME)});
/// Names of the principled shadings.
constexpr auto PRINCIPLED_SHADINGS = std::to_array({TELAR_PRINCIPLED_SHADINGS(TELAR_SHADING_NAME)});
#undef TELAR_SHADING_NAME

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
  return std::ranges::any_of(PRINCIPLED_SHADINGS, [&](const auto& row) { return row.second == shading; });
}

}  // namespace telar
