#include "brdf/transmission_terms.h"

#include "brdf/term_rows.h"

namespace telar::test {
namespace {

const Column IOR{1, 2.5, {1, 1.25, 1.5, 2.4, 1000}};
const Column DISPERSION{0, 5, {0, 0.36, 1, 40}};
const Column PATH{0, 5, {0, 1e-3, 0.1, 1, 1e31}};
const Column ATTENUATION_DISTANCE{0.1, 10, {0.1, 1, 1e12}};
const Column PICTURE_LOD{0, 13, {0, 8, 9, 13}};

// Scale of an offset in texels: parts of size 1 that cancel.
constexpr double OF_TEXEL = 1;

}  // namespace

std::vector<Term> transmissionTerms() {
  return {
      TERM("refractedDirection", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD, IOR}), OF_ONE, false,
           refractedDirection(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5])), p[6])),
      TERM("dispersedIor", ({IOR, DISPERSION}), OF_ONE, true, dispersedIor(p[0], p[1])),
      TERM("volumeTransmittance", ({PATH, UNIT, UNIT, UNIT, ATTENUATION_DISTANCE}), OF_ONE, true,
           volumeTransmittance(p[0], vec3(p[1], p[2], p[3]), p[4])),
      TERM("transmissionLod", ({ROUGHNESS, IOR, PICTURE_LOD}), PRODUCT, true, vec3(transmissionLod(p[0], p[1], p[2]))),
      TERM("transmittedAlpha", ({UNIT, UNIT, UNIT, UNIT}), OF_ONE, true,
           vec3(transmittedAlpha(vec3(p[0], p[1], p[2]), p[3]))),
      TERM("bicubicTaps low", ({UNIT}), OF_TEXEL, false,
           vec3(bicubicTaps(p[0]).lowWeight, bicubicTaps(p[0]).lowOffset, 0.0)),
      TERM("bicubicTaps high", ({UNIT}), OF_ONE, true,
           vec3(bicubicTaps(p[0]).highWeight, bicubicTaps(p[0]).highOffset, 0.0)),
  };
}

}  // namespace telar::test
