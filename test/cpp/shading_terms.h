#pragma once
#include "telar/shading.h"

namespace telar {

/// The terms of a principled shading of which none is swapped; of other shadings they say nothing.
inline ShadingTerms termsOf(ShadingModel shading) {
  const int column = shading == ShadingModel::kDisney2012 ? 1 : 0;
  ShadingTerms terms;
#define TELAR_SHADING_MEMBER(define, member, ...) terms.member = column;
  TELAR_SHADING_SLOTS(TELAR_SHADING_MEMBER)
#undef TELAR_SHADING_MEMBER
  return terms;
}

}  // namespace telar
