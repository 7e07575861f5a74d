#include "brdf/area_terms.h"

#include "brdf/term_rows.h"

namespace telar::test {
namespace {

const Column FIT{0.3, 1.2, {0.3, 0.5, 1, 1.2}};
const Column SKEW{-0.2, 0.2, {-0.2, 0, 0.2}};
const Column OVERHEAD{0.6, 2, {0.6, 2}};  // no edge from horizon to horizon: its ends would be opposite
const Column HALF_EDGE{0.05, 1, {0.05, 0.5, 1}};

// Scale of a rectangle's share: four edges of up to 1/2, which cancel.
constexpr double OF_RECTANGLE = 1;

}  // namespace

std::vector<Term> areaTerms() {
  return {
      TERM("ltcCoordinates", ({ROUGHNESS, COSINE}), OF_ONE, true, vec3(ltcCoordinates(p[0], p[1]), 0.0)),
      TERM("ltcInverse", ({FIT, SLANT, SLANT, FIT, DIRECTION, DIRECTION, UPWARD}), OF_ONE, false,
           ltcInverse(vec4(p[0], p[1], p[2], p[3])) * vec3(p[4], p[5], p[6])),
      TERM("anyTangent", ({DIRECTION, DIRECTION, UPWARD}), OF_ONE, false,
           anyTangent(normalize(vec3(p[0], p[1], p[2])))),
      TERM("ltcFrame", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}),
           OF_ONE, false,
           ltcFrame(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5]))) * vec3(p[6], p[7], p[8])),
      TERM("ltcEdge", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}), OF_ONE, false,
           ltcEdge(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5])))),
      TERM("ltcAboveHorizon", ({DIRECTION, DIRECTION, DIRECTION}), OF_ONE, true,
           vec3(ltcAboveHorizon(vec3(p[0], p[1], p[2])))),
      TERM("ltcRectangle", ({FIT, SKEW, SKEW, FIT, SLANT, SLANT, DIRECTION, DIRECTION, OVERHEAD, HALF_EDGE, HALF_EDGE}),
           OF_RECTANGLE, true,
           vec3(ltcRectangle(ltcInverse(vec4(p[0], p[1], p[2], p[3])) *
                                 ltcFrame(vec3(0.0, 0.0, 1.0), normalize(vec3(p[4], p[5], 0.7))),
                             vec3(p[6] + p[9], p[7] - p[10], p[8]), vec3(p[6] - p[9], p[7] - p[10], p[8]),
                             vec3(p[6] - p[9], p[7] + p[10], p[8]), vec3(p[6] + p[9], p[7] + p[10], p[8])))),
      TERM("ltcDisk", ({FIT, SKEW, SKEW, FIT, SLANT, SLANT, DIRECTION, DIRECTION, OVERHEAD, HALF_EDGE}), OF_RECTANGLE,
           true,
           vec3(ltcDisk(ltcInverse(vec4(p[0], p[1], p[2], p[3])) *
                            ltcFrame(vec3(0.0, 0.0, 1.0), normalize(vec3(p[4], p[5], 0.7))),
                        vec3(p[6], p[7], p[8]), vec3(p[9], 0.0, 0.0), vec3(0.0, p[9], 0.0)))),
      TERM("ltcAlbedo", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), OF_ONE, false,
           ltcAlbedo(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5]))),
  };
}

}  // namespace telar::test
