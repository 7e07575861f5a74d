#include "brdf/release_terms.h"

#include "brdf/term_rows.h"

namespace telar::test {

std::vector<Term> releaseTerms() {
  return {
      TERM("dominantReflectionByAlpha", ({ROUGHNESS, DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}),
           OF_ONE, false,
           dominantReflectionByAlpha(p[0], normalize(vec3(p[1], p[2], p[3])), normalize(vec3(p[4], p[5], p[6])))),
      TERM("addedScattering", ({UNIT, UNIT, UNIT, UNIT, DFG_A, DFG_B, DFG_A, DFG_B, UNIT, UNIT, UNIT}), OF_ONE, false,
           addedScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5]), vec2(p[6], p[7]), vec3(p[8], p[9], p[10]))),
      TERM("diffuseShareOfLargest", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), OF_ONE, false,
           diffuseShareOfLargest(Scattering(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5])))),
      TERM("sheenAlbedoInRanges", ({SHEEN_ROUGHNESS, COSINE}), OF_ONE, true, vec3(sheenAlbedoInRanges(p[0], p[1]))),
      TERM("underSheenOfColor", ({UNIT, UNIT, UNIT}), OF_ONE, true, vec3(underSheenOfColor(vec3(p[0], p[1], p[2])))),
      TERM("ltcAlbedoToWhite", ({UNIT, UNIT, UNIT, UNIT, UNIT}), OF_ONE, true,
           ltcAlbedoToWhite(vec3(p[0], p[1], p[2]), vec2(p[3], p[4]))),
      TERM("glassOpacityWithTenth", ({UNIT, UNIT}), OF_ONE, true, vec3(glassOpacityWithTenth(p[0], p[1]))),
      TERM("toneMapNeutralWhite", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), OF_ONE, true,
           toneMapNeutralWhite(vec3(p[0], p[1], p[2]), p[3])),
  };
}

}  // namespace telar::test
