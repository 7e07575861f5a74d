// Included in a namespace where Real is the scalar type and `float` stands for it. One line a function of shaders/brdf,
// which the linker checks against the text.
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
using mat3 = glm::mat<3, 3, Real>;

#include "constants.glsl"
#include "types.glsl"

Real pow2(Real x);
Real pow4(Real x);
Real max3(vec3 v);
Real min3(vec3 v);
Real saturate(Real x);
vec3 saturate(vec3 v);
vec3 safeNormalize(vec3 x, vec3 fallback);
vec3 anyTangent(vec3 n);
mat3 basisAbout(vec3 n);

Real geometricRoughness(vec3 dndx, vec3 dndy);
Real shadedRoughness(Real perceptualRoughness, Real geometric);
Real roughnessWithSlopes(Real perceptualRoughness, Real slopeVariance);
Real widthWithSlopes(Real alpha, Real slopeVariance);
Real alphaFromRoughness(Real perceptualRoughness);

Real D_GGX(Real alpha, Real NoH);
Real V_SmithGGXCorrelated(Real alpha, Real NoV, Real NoL);
Real F_SchlickWeight(Real LoH);
Real F_SchlickWeight5(Real cosine);
vec3 F_Schlick(vec3 f0, Real f90, Real LoH);
vec3 diffuseAlbedo(vec3 baseColor, Real metallic);
vec3 Fr_GGX(vec3 f0, Real f90, Real alpha, Real NoV, Real NoL, Real NoH, Real LoH);
vec3 Fd_Lambert(vec3 diffuse);

Real fonNormalisation(Real diffuseRoughness);
Real fonAlbedo(Real diffuseRoughness, Real cosine);
Real fonAverageAlbedo(Real diffuseRoughness);
vec3 eonMultipleAlbedo(vec3 rho, Real average);
vec3 Fd_EON(vec3 albedo, Real diffuseRoughness, Real NoV, Real NoL, Real LoV);
vec3 eonAlbedo(vec3 albedo, Real diffuseRoughness, Real NoV);

Real D_Charlie(Real alpha, Real NoH);
Real V_Neubelt(Real NoV, Real NoL);
vec3 Fr_Sheen(vec3 sheenColor, Real sheenRoughness, Real NoV, Real NoL, Real NoH);
Real sheenAlbedo(Real sheenRoughness, Real NoV);

Real D_GGXRobust(Real alpha, Real NoH, Real NxH2);
Real charlieCurve(Real alpha, Real x);
Real lambdaCharlie(Real alpha, Real cosine);
Real V_CharlieSoftened(Real alpha, Real NoV, Real NoL);
Real D_Ashikhmin(Real alpha, Real NoH);
Real fuzzUncharted4(Real sheenRoughness, Real NoV);
Real V_SmithGGXCosine(Real alpha, Real NoV, Real NoL);
Real V_SmithGGXAnisotropicCosine(Real alphaT, Real alphaB, Real NoV, Real NoL, Real ToV, Real BoV, Real ToL, Real BoL);
vec3 sheenFit(Real sheenRoughness, Real NoV);
vec3 sheenLtc(Real sheenRoughness, Real NoV);
Real sheenLtcCosine(vec3 ltc, vec3 l);
vec4 sheenView(vec3 fit, Real NoV);
Real sheenCosine(vec4 view, Real NoV, Real NoL, Real LoV);

GlossCurve glossCurve(Real perceptualRoughness);
vec4 grazingCurve(Real r);
Real grazingExcess(Real perceptualRoughness, Real cosine);
Real glossMissing(GlossCurve curve, Real cosine);
Real glossGrazing(vec4 curve, Real cosine);
vec2 glossAlbedo(GlossCurve curve, Real cosine);
vec2 glossAverage(GlossCurve curve);
StretchedCurve stretchedCurve(Real wide, Real narrow);
vec2 stretchedAlbedo(StretchedCurve curve, Real cosine, Real alongWide, Real alongNarrow);
Real grazingRatio(Real r, Real cosine);
Real sheetAlbedo(Real cosine);
vec3 sheetMultiple(vec3 rho);
vec3 Fd_SheetCosine(vec3 albedo, Real NoV, Real NoL);
vec3 sheetReflectance(vec3 albedo, Real NoV);
vec3 normalFacing(vec3 n, vec3 v);
Real bumpAlpha2(vec3 surface, vec3 mapped);
Real bumpMean(Real cosine);
vec3 bumpBent(vec3 surface, vec3 mapped);
Real bumpTerminator(Real alpha2, Real cosine);
Real bumpGloss(Real perceptualRoughness, Real alpha2, Real cosine, Real mean);
Real facetShare(Real slope2);
Real facetCellDistribution(Real alpha2, vec2 slope, vec2 across, vec2 down);
Real edgeShare(Real share, Real slope2);
Real reliefDiffuseTowards(Real relief, Real towards, Real NoL);
Real reliefTowards(Real relief, vec3 axis, vec3 n, vec3 d);
Real reliefBehind(Real relief, Real cosine);
vec3 reliefBent(Real relief, vec3 bent, vec3 n, vec3 v, Real NoV);
vec2 reliefGloss(Real relief, Real perceptualRoughness, Real NoV);
SheenNormal sheenNormal(vec3 leaning, Real sheenRoughness, vec3 n, vec3 v);
SheenRing sheenRing(Real relief, vec3 axis, Real sheenRoughness, vec3 n, vec3 v);
Real reliefTurned(Real relief, Real NoV);
Real reliefGrazing(Real relief, vec4 curve, Real NoV);
Real reliefSheenAlbedo(Real relief, Real towards, Real sheenRoughness, Real NoV);
Real sheenNormalCosine(SheenNormal normal, vec3 l, Real LoV);
Real sheenRingCosine(SheenRing ring, vec3 l, Real NoL, Real LoV);
Real reliefSheen(Real relief, Real sheenRoughness);
SheenTaps sheenTaps(Real relief, Real sheenRoughness, vec3 n, vec3 v, Real NoV);
Real stretchedTaps(Real wide, Real narrow);
Real tapRoughness(Real wide, Real narrow, Real taps);
vec4 stretchedTap(vec3 n, vec3 axis, vec3 v, Real wide, Real u);
vec3 returningShare(vec3 f0, Real f90, Real averageMissing);
vec3 interfaceAlbedo(vec3 f0, Real f90, vec3 returning, vec2 albedo);

Real prefilteredRoughness(Real perceptualRoughness, Real f0, Real NoV);
vec3 dominantReflectionByAlpha(Real perceptualRoughness, vec3 n, vec3 v);
vec3 addedScattering(vec3 f0, Real f90, vec2 dfgV, vec2 dfgL, vec3 passes);
vec3 diffuseShareOfLargest(Scattering whole);
Real sheenAlbedoInRanges(Real sheenRoughness, Real cosine);
Real underSheenOfColor(vec3 sheenColor);
vec3 ltcAlbedoToWhite(vec3 f0, vec2 scaleAndBias);
Real glassOpacityWithTenth(Real coverage, Real transmission);
vec3 toneMapNeutralWhite(vec3 color, Real exposure);

Real roughnessR115(Real perceptualRoughness);
vec3 specularF0R115(vec3 baseColor, Real reflectivity, Real metallic);
Real clearcoatDHR(Real perceptualRoughness, Real cosine);
vec3 Fr_SheenR115(vec3 sheenColor, Real alpha, Real NoV, Real NoL, Real NoH);

vec3 F_SchlickRoughness(vec3 f0, Real perceptualRoughness, Real NoV);
Scattering multipleScatteringR115(vec3 f0, Real perceptualRoughness, Real NoV, vec2 dfg);

Real luminanceDisney(vec3 color);
vec3 tintDisney(vec3 baseColor);
vec3 specularF0Disney(vec3 baseColor, Real metallic, Real specular, Real specularTint);
Real diffuseFresnel(Real f90, Real NoV, Real NoL);
Real Fd_Burley(Real perceptualRoughness, Real NoV, Real NoL, Real LoH);
Real Fd_BurleyRenormalised(Real perceptualRoughness, Real NoV, Real NoL, Real LoH);
Real Fd_HanrahanKrueger(Real perceptualRoughness, Real NoV, Real NoL, Real LoH);
vec2 alphasDisney(Real perceptualRoughness, Real anisotropic);
Real G1_SmithAnisotropic(Real alphaT, Real alphaB, Real cosine, Real alongT, Real alongB);
Real D_GTR1(Real alpha, Real NoH);
Real Fr_ClearcoatDisney(Real clearcoat, Real gloss, Real NoV, Real NoL, Real NoH, Real LoH);
vec3 Fr_SheenDisney(vec3 baseColor, Real sheen, Real sheenTint, Real LoH);
vec2 Fd_DisneyThin(Real perceptualRoughness, Real diffuseTransmission, Real flatness, Real NoV, Real NoL, Real LoH);

Real tintAmountDisney(vec3 color, vec3 baseColor);
vec3 specularF0FromGltf(vec3 baseColor, Real metallic, vec3 f0Dielectric);
vec3 sheenFromGltf(vec3 baseColor, vec3 sheenColor);
Real anisotropicFromGltf(Real perceptualRoughness, Real strength);
Real glossFromGltf(Real perceptualRoughness);

Real diffuseFresnelAlbedo(Real constant, Real slope, Real NoV);
Real burleyAlbedo(Real perceptualRoughness, Real NoV);
Real burleyRenormalisedAlbedo(Real perceptualRoughness, Real NoV);
Real hanrahanKruegerAlbedo(Real perceptualRoughness, Real NoV);
Real sheenAlbedoDisney(Real NoV);
Real sheenAlbedoR115(Real alpha, Real NoV);
Real sheenAlbedoEstevezKulla(Real sheenRoughness, Real NoV);
Real sheenAlbedoVelvet(Real sheenRoughness, Real NoV);
Real clearcoatAlbedoDisney(Real gloss, Real NoV);
vec2 separableShare(Real perceptualRoughness, Real NoV);

vec2 dfgKaris(Real perceptualRoughness, Real NoV);
vec2 dfgLazarov(Real perceptualRoughness, Real NoV);

Real D_GGXAnisotropic(Real alphaT, Real alphaB, Real NoH, Real ToH, Real BoH);
Real smithSumAnisotropic(Real alphaT, Real alphaB, Real NoV, Real NoL, Real ToV, Real BoV, Real ToL, Real BoL);
Real V_SmithGGXCorrelatedAnisotropic(Real alphaT, Real alphaB, Real NoV, Real NoL, Real ToV, Real BoV, Real ToL,
                                     Real BoL);
Real alphaAlongTangent(Real perceptualRoughness, Real strength);
vec3 bentNormal(Real perceptualRoughness, Real strength, vec3 n, vec3 b, vec3 v);

vec3 iorFromF0(vec3 f0);
vec3 f0FromIor(vec3 transmittedIor, Real incidentIor);
vec3 filmSensitivity(Real pathDifference, vec3 shift);
vec3 F_Iridescence(Real filmIor, Real thickness, Real cosTheta, vec3 baseF0);
vec3 f0FromSchlick(vec3 f, Real VoH);

vec3 F_SchlickAverage(vec3 f0);
Scattering multipleScattering(vec3 f0, Real f90, vec2 dfg);
Scattering mixScattering(Scattering dielectric, Scattering metal, Real metallic);
vec3 diffuseShare(Scattering dielectric);
vec3 directCompensation(vec3 f0, vec2 dfg);

vec3 refractedDirection(vec3 n, vec3 v, Real ior);
vec3 dispersedIor(Real ior, Real dispersion);
vec3 volumeTransmittance(Real pathLength, vec3 attenuationColor, Real attenuationDistance);
Real transmissionLod(Real perceptualRoughness, Real ior, Real maxLod);
Real transmittedAlpha(vec3 transmittance, Real alpha);
BicubicTaps bicubicTaps(Real x);

vec3 halfVector(vec3 n, vec3 l, vec3 v);
Real distanceAttenuation(Real lightDistance, Real range);
Real spotAttenuation(Real outerCos, Real innerCos, Real angleCos);
vec3 hemisphereIrradiance(vec3 skyColor, vec3 groundColor, Real NoUp);

vec2 ltcCoordinates(Real perceptualRoughness, Real NoV);
mat3 ltcInverse(vec4 fit);
mat3 ltcFrame(vec3 n, vec3 v);
vec3 ltcEdge(vec3 a, vec3 b);
Real ltcAboveHorizon(vec3 f);
Real ltcRectangle(mat3 toLobe, vec3 a, vec3 b, vec3 c, vec3 d);
Real ltcDisk(mat3 toLobe, vec3 centre, vec3 x, vec3 y);
vec3 ltcAlbedo(vec3 f0, Real f90, vec2 scaleAndBias);

Real diffuseOcclusion(Real texel, Real strength);
Real specularOcclusion(Real perceptualRoughness, Real occlusion, Real NoV);

vec3 multiBounceVisibility(Real visibility, vec3 albedo);
Real visibilityBesideMap(Real visibility, Real occlusion);
Real arcCosine(Real x);
Real conesIntersection(Real cosA, Real cosB, Real cosBetween);
Real specularVisibility(Real visibility, Real perceptualRoughness, Real cosOpen, Real cosFace);

Real lodFromRoughness(Real perceptualRoughness, Real maxLod);
vec3 dominantReflection(Real perceptualRoughness, vec3 n, vec3 v);
vec3 environmentSpecular(Scattering scattering, vec3 radiance, vec3 meanRadiance);

vec3 sampleCosine(vec2 u);
Real pdfCosine(Real NoL);
vec3 sampleHemisphere(vec2 u);
Real pdfHemisphere(Real NoL);
vec3 sampleSheenLtc(vec3 ltc, vec2 u);
vec3 sampleVisibleNormal(vec3 v, vec2 alpha, vec2 u);
vec3 sampleReflection(vec3 v, vec2 alpha, vec2 u);
Real pdfReflection(vec3 v, vec3 l, vec2 alpha);
Real powerHeuristic(Real own, Real other);

vec3 exposedColor(vec3 color, Real exposure);
#define TELAR_TONE_MAP(name, function, three) vec3 function(vec3 color, Real exposure);
TELAR_TONE_MAPPINGS(TELAR_TONE_MAP)
#undef TELAR_TONE_MAP
vec3 acesCurve(vec3 x);
vec3 agxCurve(vec3 x);
vec3 agxEncode(vec3 color);
vec3 agxDecode(vec3 x);

Real srgbFromLinear(Real linear);
vec3 srgbFromLinear(vec3 linear);
Real linearFromSrgb(Real encoded);
vec3 linearFromSrgb(vec3 encoded);
