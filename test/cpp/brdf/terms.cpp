#include "brdf/terms.h"

#include "brdf/area_terms.h"
#include "brdf/cloth_terms.h"
#include "brdf/importance_terms.h"
#include "brdf/release_terms.h"
#include "brdf/term_rows.h"
#include "brdf/transmission_terms.h"

namespace telar::test {
namespace {

std::vector<Term> algebraTerms() {
  return {
      TERM("pow2", ({SIGNED_COSINE}), PRODUCT, true, vec3(pow2(p[0]))),
      TERM("pow4", ({SIGNED_COSINE}), PRODUCT, true, vec3(pow4(p[0]))),
      TERM("max3", ({DIRECTION, DIRECTION, DIRECTION}), PRODUCT, false, vec3(max3(vec3(p[0], p[1], p[2])))),
      TERM("min3", ({DIRECTION, DIRECTION, DIRECTION}), PRODUCT, false, vec3(min3(vec3(p[0], p[1], p[2])))),
      TERM("saturate", ({DERIVATIVE}), PRODUCT, true, vec3(saturate(p[0]))),
      TERM("saturate vec3", ({DERIVATIVE, RADIANCE, UNIT}), PRODUCT, true, saturate(vec3(p[0], p[1], p[2]))),
      TERM("safeNormalize", ({DIRECTION, DIRECTION, DIRECTION, UNIT, UNIT, UNIT}), OF_ONE, false,
           safeNormalize(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5]))),
      TERM("geometricRoughness", ({DERIVATIVE, DERIVATIVE, DERIVATIVE, DERIVATIVE, DERIVATIVE, DERIVATIVE}), PRODUCT,
           true, vec3(geometricRoughness(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5])))),
      TERM("shadedRoughness", ({ROUGHNESS, UNIT}), PRODUCT, true, vec3(shadedRoughness(p[0], p[1]))),
      TERM("roughnessWithSlopes", ({ROUGHNESS, UNIT}), PRODUCT, true, vec3(roughnessWithSlopes(p[0], p[1]))),
      TERM("widthWithSlopes", ({ALPHA, UNIT}), PRODUCT, true, vec3(widthWithSlopes(p[0], p[1]))),
      TERM("alphaFromRoughness", ({ROUGHNESS}), PRODUCT, true, vec3(alphaFromRoughness(p[0]))),
  };
}

std::vector<Term> surfaceTerms() {
  return {
      TERM("D_GGX", ({ALPHA, COSINE}), PRODUCT, true, vec3(D_GGX(p[0], p[1]))),
      TERM("D_GGX of roughness", ({ROUGHNESS, COSINE}), PRODUCT, true, vec3(D_GGX(alphaFromRoughness(p[0]), p[1]))),
      TERM("V_SmithGGXCorrelated", ({ALPHA, COSINE, COSINE}), PRODUCT, true,
           vec3(V_SmithGGXCorrelated(p[0], p[1], p[2]))),
      TERM("F_SchlickWeight", ({COSINE}), PRODUCT, true, vec3(F_SchlickWeight(p[0]))),
      TERM("F_Schlick", ({UNIT, UNIT, UNIT, UNIT, COSINE}), OF_ONE, true,
           F_Schlick(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("diffuseAlbedo", ({UNIT, UNIT, UNIT, UNIT}), PRODUCT, true, diffuseAlbedo(vec3(p[0], p[1], p[2]), p[3])),
      TERM("Fr_GGX", ({UNIT, UNIT, UNIT, GRAZING, ALPHA, COSINE, COSINE, COSINE, COSINE}), PRODUCT, true,
           Fr_GGX(vec3(p[0], p[1], p[2]), p[3], p[4], p[5], p[6], p[7], p[8])),
      TERM("Fd_Lambert", ({UNIT, UNIT, UNIT}), PRODUCT, true, Fd_Lambert(vec3(p[0], p[1], p[2]))),
      TERM("F_SchlickAverage", ({UNIT, UNIT, UNIT}), PRODUCT, true, F_SchlickAverage(vec3(p[0], p[1], p[2]))),
      TERM("multipleScattering single", ({UNIT, UNIT, UNIT, UNIT, DFG_A, DFG_B}), PRODUCT, true,
           multipleScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5])).single),
      TERM("multipleScattering multiple", ({UNIT, UNIT, UNIT, UNIT, DFG_A, DFG_B}), OF_ONE, true,
           multipleScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5])).multiple),
      TERM("mixScattering", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), PRODUCT, true,
           mixScattering(Scattering(vec3(p[0], p[1], p[2]), vec3(p[0])), Scattering(vec3(p[3], p[4], p[5]), vec3(p[1])),
                         p[6])
               .single),
      TERM("mixScattering multiple", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), PRODUCT, true,
           mixScattering(Scattering(vec3(p[0]), vec3(p[0], p[1], p[2])), Scattering(vec3(p[1]), vec3(p[3], p[4], p[5])),
                         p[6])
               .multiple),
      TERM("diffuseShare", ({DIELECTRIC, DIELECTRIC, DIELECTRIC, UNIT, DFG_A, DFG_B}), OF_ONE, true,
           diffuseShare(multipleScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5])))),
      TERM("directCompensation", ({UNIT, UNIT, UNIT, DFG_A, DFG_B}), PRODUCT, true,
           directCompensation(vec3(p[0], p[1], p[2]), vec2(p[3], p[4]))),
  };
}

std::vector<Term> layerTerms() {
  return {
      TERM("fonNormalisation", ({UNIT}), PRODUCT, true, vec3(fonNormalisation(p[0]))),
      TERM("fonAlbedo", ({UNIT, COSINE}), PRODUCT, true, vec3(fonAlbedo(p[0], p[1]))),
      TERM("fonAverageAlbedo", ({UNIT}), PRODUCT, true, vec3(fonAverageAlbedo(p[0]))),
      TERM("eonMultipleAlbedo", ({UNIT, UNIT, UNIT, GRAZING}), OF_ONE, true,
           eonMultipleAlbedo(vec3(p[0], p[1], p[2]), p[3])),
      TERM("Fd_EON", ({UNIT, UNIT, UNIT, UNIT, COSINE, COSINE, SIGNED_COSINE}), OF_ONE, false,
           Fd_EON(vec3(p[0], p[1], p[2]), p[3], p[4], p[5], p[6])),
      TERM("eonAlbedo", ({UNIT, UNIT, UNIT, UNIT, COSINE}), OF_ONE, true,
           eonAlbedo(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("D_Charlie", ({SHEEN_ALPHA, COSINE}), OF_CHARLIE, true, vec3(D_Charlie(p[0], p[1]))),
      TERM("V_Neubelt", ({COSINE, COSINE}), PRODUCT, true, vec3(V_Neubelt(p[0], p[1]))),
      TERM("Fr_Sheen", ({UNIT, UNIT, UNIT, SHEEN_ROUGHNESS, COSINE, COSINE, COSINE}), OF_CHARLIE, true,
           Fr_Sheen(vec3(p[0], p[1], p[2]), p[3], p[4], p[5], p[6])),
      TERM("sheenAlbedo", ({ROUGHNESS, COSINE}), PRODUCT, true, vec3(sheenAlbedo(p[0], p[1]))),
      TERM("D_GGXAnisotropic", ({ALPHA, ALPHA, OFF_GRAZING, SLANT, SLANT}), PRODUCT, false,
           vec3(D_GGXAnisotropic(p[0], p[1], p[2], p[3], p[4]))),
      TERM("smithSumAnisotropic", ({ALPHA, ALPHA, COSINE, COSINE, SLANT, SLANT, SLANT, SLANT}), PRODUCT, true,
           vec3(smithSumAnisotropic(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]))),
      TERM("V_SmithGGXCorrelatedAnisotropic", ({ALPHA, ALPHA, COSINE, COSINE, SLANT, SLANT, SLANT, SLANT}), PRODUCT,
           true, vec3(V_SmithGGXCorrelatedAnisotropic(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]))),
      TERM("alphaAlongTangent", ({ROUGHNESS, UNIT}), PRODUCT, true, vec3(alphaAlongTangent(p[0], p[1]))),
      TERM("bentNormal", ({ROUGHNESS, UNIT, SLANT, UPWARD, UPWARD, SLANT}), OF_ONE, false,
           bentNormal(p[0], p[1], normalize(vec3(p[2], p[5], p[3])), vec3(1.0, 0.0, 0.0),
                      normalize(vec3(p[5], p[2], p[4])))),
      TERM("iorFromF0", ({BASE_F0, BASE_F0, BASE_F0}), PRODUCT, true, iorFromF0(vec3(p[0], p[1], p[2]))),
      TERM("f0FromIor", ({FILM_IOR, FILM_IOR, FILM_IOR, FILM_IOR}), OF_ONE, true,
           f0FromIor(vec3(p[0], p[1], p[2]), p[3])),
      TERM("filmSensitivity", ({THICKNESS, PHASE, PHASE, PHASE}), OF_ONE, false,
           filmSensitivity(p[0], vec3(p[1], p[2], p[3]))),
      TERM("F_Iridescence", ({FILM_IOR, THICKNESS, OFF_GRAZING, BASE_F0, BASE_F0, BASE_F0}), OF_ONE, true,
           F_Iridescence(p[0], p[1], p[2], vec3(p[3], p[4], p[5]))),
      TERM("f0FromSchlick", ({UNIT, UNIT, UNIT, OFF_GRAZING}), OF_ONE, false,
           f0FromSchlick(vec3(p[0], p[1], p[2]), p[3])),
  };
}

std::vector<Term> lightTerms() {
  return {
      TERM("halfVector", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}),
           OF_ONE, false,
           halfVector(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5])),
                      normalize(vec3(p[6], p[7], p[8])))),
      TERM("halfVector opposite", ({DIRECTION, DIRECTION, DIRECTION, DIRECTION, DIRECTION, DIRECTION}), OF_ONE, false,
           halfVector(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5])),
                      -normalize(vec3(p[3], p[4], p[5])))),
      TERM("distanceAttenuation", ({DISTANCE, RANGE}), PRODUCT, true, vec3(distanceAttenuation(p[0], p[1]))),
      TERM("spotAttenuation", ({OUTER_CONE, INNER_CONE, SIGNED_COSINE}), OF_ONE, true,
           vec3(spotAttenuation(p[0], p[1], p[2]))),
      TERM("spotAttenuation hard", ({OUTER_CONE, SIGNED_COSINE}), OF_ONE, true,
           vec3(spotAttenuation(p[0], p[0], p[1]))),
      TERM("hemisphereIrradiance", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, SIGNED_COSINE}), OF_ONE, true,
           hemisphereIrradiance(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5]), p[6])),
      TERM("diffuseOcclusion", ({UNIT, UNIT}), OF_ONE, true, vec3(diffuseOcclusion(p[0], p[1]))),
      TERM("specularOcclusion", ({ROUGHNESS, UNIT, COSINE}), OF_ONE, true, vec3(specularOcclusion(p[0], p[1], p[2]))),
      TERM("multiBounceVisibility", ({UNIT, UNIT, UNIT, UNIT}), OF_ONE, true,
           multiBounceVisibility(p[0], vec3(p[1], p[2], p[3]))),
      TERM("visibilityBesideMap", ({UNIT, UNIT}), OF_ONE, true, vec3(visibilityBesideMap(p[0], p[1]))),
      TERM("arcCosine", ({SIGNED_COSINE}), OF_ONE, true, vec3(arcCosine(p[0]))),
      TERM("conesIntersection", ({UNIT, UNIT, SIGNED_COSINE}), OF_ONE, true, vec3(conesIntersection(p[0], p[1], p[2]))),
      // The cosines of narrow cones are near 1, and a tenth is left of a lobe half below the horizon: fp32 has no more
      // digits.
      TERM("specularVisibility", ({UNIT, ROUGHNESS, COSINE, COSINE}), 20 * OF_ONE, true,
           vec3(specularVisibility(p[0], p[1], p[2], p[3]))),
      TERM("lodFromRoughness", ({ROUGHNESS, MAX_LOD}), PRODUCT, true, vec3(lodFromRoughness(p[0], p[1]))),
      TERM("dominantReflection", ({ROUGHNESS, DIRECTION, DIRECTION, DIRECTION, DIRECTION, DIRECTION, DIRECTION}),
           OF_ONE, false,
           dominantReflection(p[0], normalize(vec3(p[1], p[2], p[3])), normalize(vec3(p[4], p[5], p[6])))),
      TERM("environmentSpecular", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), PRODUCT, true,
           environmentSpecular(Scattering(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5])), vec3(p[6]), vec3(p[7]))),
  };
}

std::vector<Term> displayTerms() {
  return {
      TERM("exposedColor", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), PRODUCT, true,
           exposedColor(vec3(p[0], p[1], p[2]), p[3])),
      TERM("toneMapLinear", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), PRODUCT, true,
           toneMapLinear(vec3(p[0], p[1], p[2]), p[3])),
      TERM("toneMapReinhard", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), PRODUCT, true,
           toneMapReinhard(vec3(p[0], p[1], p[2]), p[3])),
      TERM("toneMapCineon", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), OF_ONE, true,
           toneMapCineon(vec3(p[0], p[1], p[2]), p[3])),
      TERM("acesCurve", ({DISPLAY, DISPLAY, DISPLAY}), OF_ONE, false, acesCurve(vec3(p[0], p[1], p[2]))),
      TERM("toneMapAces", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), OF_ONE, true,
           toneMapAces(vec3(p[0], p[1], p[2]), p[3])),
      TERM("agxCurve", ({DISPLAY, DISPLAY, DISPLAY}), CANCELLING, false, agxCurve(vec3(p[0], p[1], p[2]))),
      TERM("agxEncode", ({RADIANCE, RADIANCE, RADIANCE}), OF_ONE, true, agxEncode(vec3(p[0], p[1], p[2]))),
      TERM("agxDecode", ({DISPLAY, DISPLAY, DISPLAY}), OF_ONE, true, agxDecode(vec3(p[0], p[1], p[2]))),
      TERM("toneMapAgx", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), CANCELLING, true,
           toneMapAgx(vec3(p[0], p[1], p[2]), p[3])),
      TERM("toneMapNeutral", ({RADIANCE, RADIANCE, RADIANCE, EXPOSURE}), OF_ONE, true,
           toneMapNeutral(vec3(p[0], p[1], p[2]), p[3])),
      TERM("srgbFromLinear", ({DISPLAY, DISPLAY, DISPLAY}), PRODUCT, true, srgbFromLinear(vec3(p[0], p[1], p[2]))),
      TERM("srgbFromLinear scalar", ({DISPLAY}), PRODUCT, true, vec3(srgbFromLinear(p[0]))),
      TERM("linearFromSrgb", ({DISPLAY, DISPLAY, DISPLAY}), PRODUCT, true, linearFromSrgb(vec3(p[0], p[1], p[2]))),
      TERM("linearFromSrgb scalar", ({DISPLAY}), PRODUCT, true, vec3(linearFromSrgb(p[0]))),
  };
}

}  // namespace

const std::vector<Term>& terms() {
  static const std::vector<Term> all = [] {
    std::vector<Term> list = algebraTerms();
    for (auto part : {surfaceTerms(), layerTerms(), transmissionTerms(), lightTerms(), areaTerms(), importanceTerms(),
                      displayTerms(), thesisTerms(), clothTerms(), releaseTerms()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace telar::test
