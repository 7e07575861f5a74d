#include "brdf/importance_terms.h"

#include "brdf/term_rows.h"

namespace telar::test {
namespace {

const Column LOBE{0.05, 1, {0.05, 0.25, 1}};
const Column DRAW{0.05, 0.95, {0.05, 0.25, 0.5, 0.95}};  // off the poles, where a direction has no digits

}  // namespace

std::vector<Term> importanceTerms() {
  return {
      TERM("basisAbout", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}), OF_ONE, false,
           basisAbout(normalize(vec3(p[0], p[1], p[2]))) * vec3(p[3], p[4], p[5])),
      TERM("sampleCosine", ({DRAW, DRAW}), OF_ONE, false, sampleCosine(vec2(p[0], p[1]))),
      TERM("pdfCosine", ({SIGNED_COSINE}), OF_ONE, true, vec3(pdfCosine(p[0]))),
      TERM("sampleHemisphere", ({DRAW, DRAW}), OF_ONE, false, sampleHemisphere(vec2(p[0], p[1]))),
      TERM("sampleSheenLtc", ({DRAW, DRAW, LOBE, COSINE}), OF_ONE, false,
           sampleSheenLtc(sheenLtc(p[2], p[3]), vec2(p[0], p[1]))),
      TERM("pdfHemisphere", ({SIGNED_COSINE}), OF_ONE, true, vec3(pdfHemisphere(p[0]))),
      TERM("sampleVisibleNormal", ({SLANT, SLANT, LOBE, LOBE, DRAW, DRAW}), OF_ONE, false,
           sampleVisibleNormal(normalize(vec3(p[0], p[1], 0.7)), vec2(p[2], p[3]), vec2(p[4], p[5]))),
      TERM("sampleReflection", ({SLANT, SLANT, LOBE, LOBE, DRAW, DRAW}), OF_ONE, false,
           sampleReflection(normalize(vec3(p[0], p[1], 0.7)), vec2(p[2], p[3]), vec2(p[4], p[5]))),
      TERM("pdfReflection", ({SLANT, SLANT, SLANT, SLANT, LOBE, LOBE}), OF_ONE, true,
           vec3(pdfReflection(normalize(vec3(p[0], p[1], 0.7)), normalize(vec3(p[2], p[3], 0.6)), vec2(p[4], p[5])))),
      TERM("powerHeuristic", ({UNIT, UNIT}), OF_ONE, false, vec3(powerHeuristic(p[0], p[1]))),
  };
}

}  // namespace telar::test
