#include "brdf/cloth_terms.h"

#include "brdf/term_rows.h"

namespace telar::test {
namespace {

const Column GLOSS{0, 1, {0, 0.5, 1}};
// Between 0.5 and 1 both sides of its fraction vanish; the coat takes 0.001 to 0.1.
const Column DISNEY_ALPHA{0.01, 0.5, {0.01, 0.1, 0.5}};
// Hues apart: near grey a tint has no direction.
const Column HUE{0, 0.5, {0, 0.2, 0.5}};
const Column OTHER_HUE{0.7, 1, {0.7, 1}};
const Column DIFFUSE_CONSTANT{-1, -0.5, {-1, -0.5}};
const Column DIFFUSE_SLOPE{0, 2, {0, 1, 2}};
const Column LTC_ROUGHNESS{0.05, 1, {0.05, 0.1, 0.3, 0.5, 1}};
// Closer to grazing Lambda is exp(20): an ulp of the exponent is then more than the tolerance.
const Column OFF_CLIFF{0.1, 1, {0.1, 0.3, 0.5, 1}};
const Column SHADED_ROUGHNESS{0.045, 1, {0.045, 0.089, 0.2, 0.5, 0.8, 1}};
const Column RELIEF_LEFT{0.01, 0.5, {0.01, 0.05, 0.2, 0.5}};
const Column WIDE{0.25, 1, {0.25, 0.64, 1}};
const Column NARROW{0.002025, 0.25, {0.002025, 0.04, 0.25}};
const Column LEANING{-0.5, 0.5, {-0.5, 0, 0.01, 0.5}};
const Column MISSING{0, 0.55, {0, 0.1, 0.55}};
const Column NXH2{1e-6, 1, {1e-6, 1e-3, 0.5, 1}};

}  // namespace

std::vector<Term> thesisTerms() {
  return {
      TERM("roughnessR115", ({ROUGHNESS}), PRODUCT, true, vec3(roughnessR115(p[0]))),
      TERM("specularF0R115", ({UNIT, UNIT, UNIT, UNIT, UNIT}), PRODUCT, true,
           specularF0R115(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("clearcoatDHR", ({ROUGHNESS, COSINE}), PRODUCT, true, vec3(clearcoatDHR(p[0], p[1]))),
      TERM("Fr_SheenR115", ({UNIT, UNIT, UNIT, SHEEN_ALPHA, COSINE, COSINE, COSINE}), OF_CHARLIE, true,
           Fr_SheenR115(vec3(p[0], p[1], p[2]), p[3], p[4], p[5], p[6])),
      TERM("F_SchlickWeight5", ({COSINE}), PRODUCT, true, vec3(F_SchlickWeight5(p[0]))),
      TERM("luminanceDisney", ({UNIT, UNIT, UNIT}), PRODUCT, true, vec3(luminanceDisney(vec3(p[0], p[1], p[2])))),
      TERM("tintDisney", ({UNIT, UNIT, UNIT}), PRODUCT, true, tintDisney(vec3(p[0], p[1], p[2]))),
      TERM("specularF0Disney", ({UNIT, UNIT, UNIT, UNIT, UNIT, UNIT}), PRODUCT, true,
           specularF0Disney(vec3(p[0], p[1], p[2]), p[3], p[4], p[5])),
      TERM("diffuseFresnel", ({UNIT, COSINE, COSINE}), OF_ONE, true, vec3(diffuseFresnel(p[0], p[1], p[2]))),
      TERM("Fd_Burley", ({ROUGHNESS, COSINE, COSINE, COSINE}), PRODUCT, true, vec3(Fd_Burley(p[0], p[1], p[2], p[3]))),
      TERM("Fd_BurleyRenormalised", ({ROUGHNESS, COSINE, COSINE, COSINE}), OF_ONE, true,
           vec3(Fd_BurleyRenormalised(p[0], p[1], p[2], p[3]))),
      // 1 / (NoL + NoV) magnifies a difference near grazing, where NoL then takes it back.
      TERM("Fd_HanrahanKrueger", ({ROUGHNESS, COSINE, OFF_GRAZING, COSINE}), CANCELLING, true,
           vec3(Fd_HanrahanKrueger(p[0], p[1], p[2], p[3]))),
      TERM("alphasDisney", ({ROUGHNESS, UNIT}), PRODUCT, true, vec3(alphasDisney(p[0], p[1]), 0.0)),
      TERM("G1_SmithAnisotropic", ({ALPHA, ALPHA, COSINE, SLANT, SLANT}), PRODUCT, true,
           vec3(G1_SmithAnisotropic(p[0], p[1], p[2], p[3], p[4]))),
      TERM("D_GTR1", ({DISNEY_ALPHA, COSINE}), PRODUCT, true, vec3(D_GTR1(p[0], p[1]))),
      TERM("Fr_ClearcoatDisney", ({UNIT, GLOSS, COSINE, COSINE, COSINE, COSINE}), OF_ONE, true,
           vec3(Fr_ClearcoatDisney(p[0], p[1], p[2], p[3], p[4], p[5]))),
      TERM("Fr_SheenDisney", ({UNIT, UNIT, UNIT, UNIT, UNIT, COSINE}), PRODUCT, true,
           Fr_SheenDisney(vec3(p[0], p[1], p[2]), p[3], p[4], p[5])),
      TERM("Fd_DisneyThin", ({ROUGHNESS, UNIT, UNIT, COSINE, COSINE, COSINE}), CANCELLING, true,
           vec3(Fd_DisneyThin(p[0], p[1], p[2], p[3], p[4], p[5]), 0.0)),
      TERM("F_SchlickRoughness", ({UNIT, UNIT, UNIT, ROUGHNESS, COSINE}), PRODUCT, true,
           F_SchlickRoughness(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("multipleScatteringR115", ({UNIT, ROUGHNESS, COSINE, DFG_A, DFG_B}), OF_ONE, true,
           multipleScatteringR115(vec3(p[0]), p[1], p[2], vec2(p[3], p[4])).multiple),
      TERM("tintAmountDisney", ({HUE, HUE, HUE, HUE, OTHER_HUE, HUE}), OF_ONE, true,
           vec3(tintAmountDisney(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5])))),
      TERM("specularF0FromGltf", ({HUE, OTHER_HUE, HUE, UNIT, BASE_F0, BASE_F0, HUE}), OF_ONE, true,
           specularF0FromGltf(vec3(p[0], p[1], p[2]), p[3], vec3(p[4], p[5], p[6]))),
      TERM("sheenFromGltf", ({HUE, OTHER_HUE, HUE, UNIT, UNIT, UNIT}), OF_ONE, true,
           sheenFromGltf(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5]))),
      TERM("anisotropicFromGltf", ({ROUGHNESS, UNIT}), OF_ONE, true, vec3(anisotropicFromGltf(p[0], p[1]))),
      TERM("glossFromGltf", ({ROUGHNESS}), OF_ONE, true, vec3(glossFromGltf(p[0]))),
      TERM("diffuseFresnelAlbedo", ({DIFFUSE_CONSTANT, DIFFUSE_SLOPE, COSINE}), OF_ONE, true,
           vec3(diffuseFresnelAlbedo(p[0], p[1], p[2]))),
      TERM("burleyAlbedo", ({ROUGHNESS, COSINE}), OF_ONE, true, vec3(burleyAlbedo(p[0], p[1]))),
      TERM("burleyRenormalisedAlbedo", ({ROUGHNESS, COSINE}), OF_ONE, true, vec3(burleyRenormalisedAlbedo(p[0], p[1]))),
      TERM("hanrahanKruegerAlbedo", ({ROUGHNESS, COSINE}), CANCELLING, true, vec3(hanrahanKruegerAlbedo(p[0], p[1]))),
      TERM("sheenAlbedoDisney", ({COSINE}), OF_ONE, true, vec3(sheenAlbedoDisney(p[0]))),
      TERM("sheenAlbedoR115", ({SHEEN_ALPHA, COSINE}), OF_ONE, true, vec3(sheenAlbedoR115(p[0], p[1]))),
      TERM("sheenAlbedoEstevezKulla", ({SHEEN_ROUGHNESS, COSINE}), OF_ONE, true,
           vec3(sheenAlbedoEstevezKulla(p[0], p[1]))),
      TERM("sheenAlbedoVelvet", ({SHEEN_ROUGHNESS, COSINE}), OF_ONE, true, vec3(sheenAlbedoVelvet(p[0], p[1]))),
      TERM("clearcoatAlbedoDisney", ({GLOSS, COSINE}), CANCELLING, true, vec3(clearcoatAlbedoDisney(p[0], p[1]))),
      TERM("separableShare", ({ROUGHNESS, COSINE}), OF_ONE, true, vec3(separableShare(p[0], p[1]), 0.0)),
      TERM("dfgKaris", ({ROUGHNESS, COSINE}), OF_ONE, false, vec3(dfgKaris(p[0], p[1]), 0.0)),
      TERM("dfgLazarov", ({ROUGHNESS, COSINE}), OF_ONE, false, vec3(dfgLazarov(p[0], p[1]), 0.0)),
  };
}

std::vector<Term> clothTerms() {
  return {
      TERM("D_GGXRobust", ({ALPHA, COSINE, NXH2}), PRODUCT, true, vec3(D_GGXRobust(p[0], p[1], p[2]))),
      TERM("V_SmithGGXCosine", ({ALPHA, COSINE, COSINE}), PRODUCT, true, vec3(V_SmithGGXCosine(p[0], p[1], p[2]))),
      TERM("V_SmithGGXAnisotropicCosine", ({ALPHA, ALPHA, COSINE, COSINE, SLANT, SLANT, SLANT, SLANT}), PRODUCT, true,
           vec3(V_SmithGGXAnisotropicCosine(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]))),
      TERM("grazingCurve", ({SHADED_ROUGHNESS}), CANCELLING, true, vec3(grazingCurve(p[0]))),
      TERM("glossCurve", ({SHADED_ROUGHNESS}), CANCELLING, true,
           vec3(glossCurve(p[0]).missing.x, glossCurve(p[0]).missingSlope, glossCurve(p[0]).grazing.y)),
      TERM("glossMissing", ({SHADED_ROUGHNESS, COSINE}), OF_ONE, true, vec3(glossMissing(glossCurve(p[0]), p[1]))),
      TERM("glossGrazing", ({SHADED_ROUGHNESS, COSINE}), OF_ONE, true, vec3(glossGrazing(grazingCurve(p[0]), p[1]))),
      TERM("glossAverage", ({SHADED_ROUGHNESS}), OF_ONE, true, vec3(glossAverage(glossCurve(p[0])), 0.0)),
      TERM("stretchedCurve", ({WIDE, NARROW}), CANCELLING, true,
           vec3(stretchedCurve(p[0], p[1]).average, stretchedCurve(p[0], p[1]).lift)),
      TERM("stretchedAlbedo", ({WIDE, NARROW, OFF_GRAZING, SLANT, SLANT}), OF_ONE, true,
           vec3(stretchedAlbedo(stretchedCurve(p[0], p[1]), p[2], p[3], p[4]), 0.0)),
      TERM("grazingRatio", ({SHADED_ROUGHNESS, COSINE}), OF_ONE, true, vec3(grazingRatio(p[0], p[1]))),
      TERM("sheetAlbedo", ({COSINE}), OF_ONE, true, vec3(sheetAlbedo(p[0]))),
      TERM("sheetMultiple", ({UNIT, UNIT, UNIT}), PRODUCT, true, sheetMultiple(vec3(p[0], p[1], p[2]))),
      TERM("Fd_SheetCosine", ({UNIT, UNIT, UNIT, COSINE, COSINE}), OF_ONE, true,
           Fd_SheetCosine(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("sheetReflectance", ({UNIT, UNIT, UNIT, COSINE}), OF_ONE, true,
           sheetReflectance(vec3(p[0], p[1], p[2]), p[3])),
      TERM("normalFacing", ({DIRECTION, DIRECTION, UPWARD, DIRECTION, DIRECTION, UPWARD}), OF_ONE, false,
           normalFacing(normalize(vec3(p[0], p[1], p[2])), normalize(vec3(p[3], p[4], p[5])))),
      TERM("bumpAlpha2", ({DIRECTION, DIRECTION, UPWARD}), OF_ONE, true,
           vec3(bumpAlpha2(vec3(0.0, 0.0, 1.0), normalize(vec3(p[0], p[1], p[2]))))),
      TERM("facetShare", ({UNIT}), OF_ONE, true, vec3(facetShare(p[0]))),
      TERM("facetCellDistribution", ({NARROW, LEANING, LEANING, LEANING, LEANING, LEANING, LEANING}), CANCELLING, true,
           vec3(facetCellDistribution(p[0], vec2(p[1], p[2]), vec2(p[3], p[4]), vec2(p[5], p[6])))),
      TERM("edgeShare", ({UNIT, UNIT}), CANCELLING, true, vec3(edgeShare(p[0], p[1]))),
      TERM("reliefDiffuseTowards", ({UNIT, RELIEF_LEFT, COSINE}), OF_ONE, true,
           vec3(reliefDiffuseTowards(p[0], p[1], p[2]))),
      TERM("reliefBehind", ({RELIEF_LEFT, SLANT}), CANCELLING, true, vec3(reliefBehind(p[0], p[1]))),
      TERM("reliefBent", ({RELIEF_LEFT, DIRECTION, DIRECTION, UPWARD, OFF_GRAZING}), OF_ONE, false,
           reliefBent(p[0], normalize(vec3(p[1], p[2], p[3])), vec3(0.0, 0.0, 1.0),
                      vec3(sqrt(1.0 - p[4] * p[4]), 0.0, p[4]), p[4])),
      TERM("reliefTurned", ({UNIT, COSINE}), OF_ONE, true, vec3(reliefTurned(p[0], p[1]))),
      TERM("reliefGrazing", ({RELIEF_LEFT, SHADED_ROUGHNESS, COSINE}), CANCELLING, true,
           vec3(reliefGrazing(p[0], grazingCurve(p[1]), p[2]))),
      TERM("prefilteredRoughness", ({SHADED_ROUGHNESS, UNIT, COSINE}), OF_ONE, true,
           vec3(prefilteredRoughness(p[0], p[1], p[2]))),
      TERM("reliefGloss", ({UNIT, SHADED_ROUGHNESS, COSINE}), CANCELLING, true,
           vec3(reliefGloss(p[0], p[1], p[2]), 0.0)),
      TERM("reliefSheen", ({RELIEF_LEFT, LTC_ROUGHNESS}), OF_ONE, true, vec3(reliefSheen(p[0], p[1]))),
      TERM("reliefSheenAlbedo", ({RELIEF_LEFT, RELIEF_LEFT, LTC_ROUGHNESS, COSINE}), CANCELLING, true,
           vec3(reliefSheenAlbedo(p[0], p[1], p[2], p[3]))),
      TERM("reliefTowards", ({RELIEF_LEFT, UNIT, DIRECTION, OFF_GRAZING}), CANCELLING, true,
           vec3(reliefTowards(p[0], vec3(p[1], 0.0, 0.0), vec3(0.0, 0.0, 1.0),
                              vec3(p[2], sqrt(1.0 - p[3] * p[3]), p[3])))),
      TERM("sheenNormal", ({RELIEF_LEFT, LTC_ROUGHNESS, OFF_GRAZING, DIRECTION, DIRECTION, UPWARD}), CANCELLING, false,
           vec3(sheenNormalCosine(
               sheenNormal(vec3(p[0], 0.0, 0.0), p[1], vec3(0.0, 0.0, 1.0), vec3(sqrt(1.0 - p[2] * p[2]), 0.0, p[2])),
               normalize(vec3(p[3], p[4], p[5])),
               dot(normalize(vec3(p[3], p[4], p[5])), vec3(sqrt(1.0 - p[2] * p[2]), 0.0, p[2]))))),
      TERM("sheenRing", ({RELIEF_LEFT, UNIT, LTC_ROUGHNESS, OFF_GRAZING, DIRECTION, DIRECTION, UPWARD}), CANCELLING,
           false,
           vec3(sheenRingCosine(sheenRing(p[0], vec3(0.0, p[1], 0.0), p[2], vec3(0.0, 0.0, 1.0),
                                          vec3(sqrt(1.0 - p[3] * p[3]), 0.0, p[3])),
                                normalize(vec3(p[4], p[5], p[6])), normalize(vec3(p[4], p[5], p[6])).z,
                                dot(normalize(vec3(p[4], p[5], p[6])), vec3(sqrt(1.0 - p[3] * p[3]), 0.0, p[3]))))),
      TERM("sheenTaps", ({RELIEF_LEFT, LTC_ROUGHNESS, OFF_GRAZING}), CANCELLING, false,
           sheenTaps(p[0], p[1], vec3(0.0, 0.0, 1.0), vec3(sqrt(1.0 - p[2] * p[2]), 0.0, p[2]), p[2]).left +
               sheenTaps(p[0], p[1], vec3(0.0, 0.0, 1.0), vec3(sqrt(1.0 - p[2] * p[2]), 0.0, p[2]), p[2]).aside),
      TERM("grazingExcess", ({ROUGHNESS, COSINE}), OF_ONE, true, vec3(grazingExcess(p[0], p[1]))),
      TERM("tapRoughness", ({WIDE, NARROW}), PRODUCT, true, vec3(tapRoughness(p[0], p[1], stretchedTaps(p[0], p[1])))),
      TERM("stretchedTap", ({WIDE, OFF_GRAZING, SLANT}), OF_ONE, false,
           vec3(stretchedTap(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(sqrt(1.0 - p[1] * p[1]), 0.0, p[1]), p[0],
                             0.75 * p[2])) +
               stretchedTap(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(sqrt(1.0 - p[1] * p[1]), 0.0, p[1]), p[0],
                            0.75 * p[2])
                   .w),
      TERM("bumpMean", ({UNIT}), OF_ONE, true, vec3(bumpMean(p[0]))),
      TERM("bumpBent", ({COSINE}), CANCELLING, false,
           bumpBent(vec3(0.0, 0.0, 1.0), vec3(sqrt(1.0 - p[0] * p[0]), 0.0, p[0]))),
      TERM("bumpGloss", ({UNIT, UNIT, COSINE, UNIT}), OF_ONE, true, vec3(bumpGloss(p[0], p[1], p[2], p[3]))),
      TERM("bumpTerminator", ({UNIT, COSINE}), OF_ONE, true, vec3(bumpTerminator(p[0], p[1]))),
      TERM("glossAlbedo", ({SHADED_ROUGHNESS, COSINE}), OF_ONE, true, vec3(glossAlbedo(glossCurve(p[0]), p[1]), 0.0)),
      TERM("returningShare", ({UNIT, UNIT, UNIT, UNIT, MISSING}), OF_ONE, true,
           returningShare(vec3(p[0], p[1], p[2]), p[3], p[4])),
      TERM("interfaceAlbedo", ({UNIT, UNIT, UNIT, UNIT, UNIT, SHADED_ROUGHNESS, COSINE}), OF_ONE, true,
           interfaceAlbedo(vec3(p[0], p[1], p[2]), p[3], vec3(p[4]), glossAlbedo(glossCurve(p[5]), p[6]))),
      TERM("charlieCurve", ({ALPHA, COSINE}), CANCELLING, false, vec3(charlieCurve(p[0], p[1]))),
      TERM("lambdaCharlie", ({ALPHA, OFF_CLIFF}), PRODUCT, true, vec3(lambdaCharlie(p[0], p[1]))),
      TERM("V_CharlieSoftened", ({ALPHA, OFF_CLIFF, OFF_CLIFF}), PRODUCT, true,
           vec3(V_CharlieSoftened(p[0], p[1], p[2]))),
      TERM("D_Ashikhmin", ({SHEEN_ALPHA, COSINE}), OF_CHARLIE, true, vec3(D_Ashikhmin(p[0], p[1]))),
      TERM("fuzzUncharted4", ({UNIT, COSINE}), OF_ONE, true, vec3(fuzzUncharted4(p[0], p[1]))),
      TERM("sheenLtc", ({LTC_ROUGHNESS, COSINE}), OF_ONE, false, sheenLtc(p[0], p[1])),
      TERM("sheenFit", ({LTC_ROUGHNESS, COSINE}), OF_ONE, false, sheenFit(p[0], p[1])),
      TERM("sheenView", ({LTC_ROUGHNESS, COSINE}), OF_ONE, false, vec3(sheenView(sheenFit(p[0], p[1]), p[1]))),
      TERM("sheenCosine", ({LTC_ROUGHNESS, COSINE, OFF_GRAZING, SLANT}), OF_ONE, true,
           vec3(sheenCosine(sheenView(sheenFit(p[0], p[1]), p[1]), p[1], p[2], p[1] * p[2] + p[3] * 0.5))),
      TERM("sheenLtcCosine", ({LTC_ROUGHNESS, COSINE, SLANT, SLANT, UPWARD}), OF_ONE, true,
           vec3(sheenLtcCosine(sheenLtc(p[0], p[1]), normalize(vec3(p[2], p[3], p[4]))))),
  };
}

}  // namespace telar::test
