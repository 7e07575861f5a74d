#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "brdf/gpu_probe.h"
#include "brdf/terms.h"
#include "telar/shot/tone_mapping.inc"

/// Our terms against the shader text of three.js itself, both on the GPU.
namespace telar::test::three_test {
namespace {

const std::string CHUNKS = TELAR_SOURCE_DIR "/node_modules/three/src/renderers/shaders/ShaderChunk/";

// Relative to the larger of |value| and the row's scale: a few ulps, as both sides take the same steps.
constexpr double TOLERANCE = 2e-6;

const Column UNIT{0, 1, {0, 1e-6, 0.04, 0.5, 1}};
const Column ALPHA{0.002025, 1, {0.002025, 0.04, 1}};
const Column DFG_A{0.3, 0.95, {0.3, 0.95}};
const Column DFG_B{0.04, 0.05, {0.04, 0.05}};
const Column DISTANCE{0.01, 20, {0.05, 0.1, 1, 10, 1e4}};
const Column RANGE{0, 20, {0, 10}};
const Column INNER_CONE{0.6, 1, {0.995, 1}};
const Column OUTER_CONE{0, 0.59, {0, 0.5}};
const Column SIGNED_COSINE{-1, 1, {-1, 0, 1}};
const Column FIT{0.3, 1.2, {0.3, 0.5, 1.2}};
const Column SLANT{-0.7, 0.7, {-0.7, 0, 0.7}};
const Column OFF_AXIS{0.01, 1, {0.01, 1}};  // where both are 0 three.js has no frame
const Column RADIANCE{0, 3, {0, 1e-4, 0.01, 0.08, 0.18, 0.76, 1, 4, 100}};
const Column EXPOSURE{0.1, 4, {0.5, 1, 16}};

struct Pair {
  const char* ours;
  const char* theirs;
  std::vector<Column> columns;
  double scale;
};

const std::vector<Column> TONE{RADIANCE, RADIANCE, RADIANCE, EXPOSURE};

const Pair PAIRS[] = {
    {"vec3(D_GGX(p[0], p[1]))", "vec3(D_GGX(p[0], p[1]))", {ALPHA, UNIT}, 1e-6},
    {"vec3(V_SmithGGXCorrelated(p[0], p[1], p[2]))",
     "vec3(V_GGX_SmithCorrelated(p[0], p[2], p[1]))",
     {ALPHA, UNIT, UNIT},
     1e-6},
    {"F_Schlick(vec3(p[0], p[1], p[2]), p[3], p[4])",
     "F_Schlick(vec3(p[0], p[1], p[2]), p[3], p[4])",
     {UNIT, UNIT, UNIT, UNIT, UNIT},
     0.1},
    {"Fd_Lambert(vec3(p[0], p[1], p[2]))", "BRDF_Lambert(vec3(p[0], p[1], p[2]))", {UNIT, UNIT, UNIT}, 1e-6},
    {"multipleScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5])).single",
     "scattering(vec2(p[4], p[5]), vec3(p[0], p[1], p[2]), p[3], 0)",
     {UNIT, UNIT, UNIT, UNIT, DFG_A, DFG_B},
     1e-6},
    {"multipleScattering(vec3(p[0], p[1], p[2]), p[3], vec2(p[4], p[5])).multiple",
     "scattering(vec2(p[4], p[5]), vec3(p[0], p[1], p[2]), p[3], 1)",
     {UNIT, UNIT, UNIT, UNIT, DFG_A, DFG_B},
     0.1},
    {"vec3(distanceAttenuation(p[0], p[1]))", "vec3(getDistanceAttenuation(p[0], p[1], 2.0))", {DISTANCE, RANGE}, 1e-3},
    {"vec3(spotAttenuation(p[0], p[1], p[2]))",
     "vec3(getSpotAttenuation(p[0], p[1], p[2]))",
     {OUTER_CONE, INNER_CONE, SIGNED_COSINE},
     1e-6},
    {"hemisphereIrradiance(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5]), p[6])",
     "getHemisphereLightIrradiance(HemisphereLight(vec3(0.0, 1.0, 0.0), vec3(p[0], p[1], p[2]), vec3(p[3], p[4], "
     "p[5])), "
     "vec3(0.0, p[6], 0.0))",
     {UNIT, UNIT, UNIT, UNIT, UNIT, UNIT, SIGNED_COSINE},
     0.1},
    {"refractedDirection(normalize(vec3(p[0], p[1], 1.0)), normalize(vec3(p[2], p[3], 1.0)), 1.0 + p[4])",
     "getVolumeTransmissionRay(normalize(vec3(p[0], p[1], 1.0)), normalize(vec3(p[2], p[3], 1.0)), 1.0, 1.0 + p[4], "
     "mat4(1.0))",
     {SIGNED_COSINE, SIGNED_COSINE, SIGNED_COSINE, SIGNED_COSINE, UNIT},
     0.1},
    {"volumeTransmittance(p[0], vec3(p[1], p[2], p[3]), p[4])",
     "volumeAttenuation(p[0], vec3(p[1], p[2], p[3]), p[4])",
     {DISTANCE, UNIT, UNIT, UNIT, DISTANCE},
     0.1},
    {"vec3(transmissionLod(p[0], 1.0 + p[1], 8.5))",
     "vec3(8.5 * applyIorToRoughness(p[0], 1.0 + p[1]))",
     {UNIT, UNIT},
     1e-6},
    {"vec3(bicubicTaps(p[0]).lowWeight, bicubicTaps(p[0]).lowOffset, 0.0)",
     "vec3(g0(p[0]), h0(p[0]), 0.0)",
     {UNIT},
     0.1},
    {"vec3(bicubicTaps(p[0]).highWeight, bicubicTaps(p[0]).highOffset, 0.0)",
     "vec3(g1(p[0]), h1(p[0]), 0.0)",
     {UNIT},
     0.1},
    {"vec3(specularOcclusion(p[0], p[1], p[2]))",
     "vec3(computeSpecularOcclusion(p[2], p[1], p[0]))",
     {UNIT, UNIT, UNIT},
     0.1},
    {"vec3(lodFromRoughness(p[0], 6.0))", "vec3(roughnessToMip(p[0]))", {SIGNED_COSINE}, 1e-6},
    {"vec3(alphaFromRoughness(p[0]))", "vec3(pow2(max(p[0], 0.045)))", {UNIT}, 1e-6},
    {"vec3(ltcCoordinates(p[0], p[1]), 0.0)",
     "vec3(LTC_Uv(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, p[1]), p[0]), 0.0)",
     {UNIT, UNIT},
     0.1},
    {"ltcEdge(normalize(vec3(p[0], p[1], 0.3)), normalize(vec3(p[2], p[3], 0.3)))",
     "LTC_EdgeVectorFormFactor(normalize(vec3(p[0], p[1], 0.3)), normalize(vec3(p[2], p[3], 0.3)))",
     {SIGNED_COSINE, SIGNED_COSINE, SIGNED_COSINE, SIGNED_COSINE},
     1e-3},
    {"vec3(ltcAboveHorizon(vec3(p[0], p[1], p[2])))",
     "vec3(LTC_ClippedSphereFormFactor(vec3(p[0], p[1], p[2])))",
     {SIGNED_COSINE, SIGNED_COSINE, SIGNED_COSINE},
     1e-3},
    {"vec3(ltcRectangle(ltcInverse(vec4(p[0], p[1], p[2], p[3])) * ltcFrame(vec3(0.0, 0.0, 1.0), normalize(vec3(p[4], "
     "p[5], 0.7))), vec3(p[6] + 0.5, p[7] - 0.4, 1.2), vec3(p[6] - 0.5, p[7] - 0.4, 1.2), "
     "vec3(p[6] - 0.5, p[7] + 0.4, 0.8), vec3(p[6] + 0.5, p[7] + 0.4, 0.8)))",
     "LTC_Evaluate(vec3(0.0, 0.0, 1.0), normalize(vec3(p[4], p[5], 0.7)), vec3(0.0), mat3(vec3(p[0], 0.0, p[1]), "
     "vec3(0.0, 1.0, 0.0), vec3(p[2], 0.0, p[3])), vec3[4](vec3(p[6] + 0.5, p[7] - 0.4, 1.2), vec3(p[6] - 0.5, p[7] - "
     "0.4, 1.2), vec3(p[6] - 0.5, p[7] + 0.4, 0.8), vec3(p[6] + 0.5, p[7] + 0.4, 0.8)))",
     {FIT, SLANT, SLANT, FIT, OFF_AXIS, OFF_AXIS, SIGNED_COSINE, SIGNED_COSINE},
     1e-3},
#define TELAR_TONE_PAIR(name, function, three) \
  {#function "(vec3(p[0], p[1], p[2]), p[3])", three "(vec3(p[0], p[1], p[2]))", TONE, 0.1},
    TELAR_TONE_MAPPINGS(TELAR_TONE_PAIR)
#undef TELAR_TONE_PAIR
        {"srgbFromLinear(vec3(p[0], p[1], p[2]))",
         "vec3(sRGBTransferOETF(vec4(p[0], p[1], p[2], 1.0)))",
         {UNIT, UNIT, UNIT},
         1e-6},
    {"linearFromSrgb(vec3(p[0], p[1], p[2]))",
     "vec3(sRGBTransferEOTF(vec4(p[0], p[1], p[2], 1.0)))",
     {UNIT, UNIT, UNIT},
     1e-6},
};

/// GLSL of one chunk, its own includes left out.
std::string chunk(const std::string& name) {
  const std::string file = readFile(CHUNKS + name + ".glsl.js");
  const std::size_t begin = file.find('`') + 1;
  std::string text = file.substr(begin, file.rfind('`') - begin);
  for (std::size_t at = text.find("#include"); at != std::string::npos; at = text.find("#include", at)) {
    text.erase(at, text.find('\n', at) - at);
  }
  return text;
}

/// What WebGLRenderer puts around these chunks for a MeshStandardMaterial under one hemisphere light.
std::string threeText() {
  std::string text =
      "#define texture2D texture\n#define STANDARD\n#define USE_ENVMAP\n#define ENVMAP_TYPE_PMREM\n#define "
      "ENVMAP_MAX_LOD 6.0\n"
      "#define NUM_SUN_LIGHTS 0\n#define NUM_DIR_LIGHTS 0\n#define NUM_POINT_LIGHTS 0\n#define NUM_SPOT_LIGHTS 0\n"
      "#define NUM_RECT_AREA_LIGHTS 0\n#define NUM_HEMI_LIGHTS 1\n#define USE_TRANSMISSION\n#define "
      "varying\nuniform mat4 viewMatrix;\n";
  for (const char* name : {"common", "lights_pars_begin", "lights_physical_pars_fragment", "transmission_pars_fragment",
                           "envmap_common_pars_fragment", "tonemapping_pars_fragment", "colorspace_pars_fragment"}) {
    text += chunk(name);
  }
  // Exposure is an argument here; its value at the start silences drivers that see it read before it is set.
  const std::string exposure = "uniform float toneMappingExposure";
  text.replace(text.find(exposure), exposure.size(), "float toneMappingExposure = 1.0");
  return text +
         "vec3 scattering(vec2 fab, vec3 f0, float f90, int part) {\n  vec3 single = vec3(0.0), multiple = vec3(0.0);\n"
         "  computeMultiscattering(fab, f0, f90, single, multiple);\n  return part == 0 ? single : multiple;\n}\n";
}

TEST(AgainstThree, EveryTermGivesItsNumbers) {
  if (!std::filesystem::exists(CHUNKS)) GTEST_SKIP() << "three is not installed";
  GpuProbe probe(Backend::kEglSurfaceless);
  const std::string ourText = sharedText(), theirText = threeText();
  for (const Pair& pair : PAIRS) {
    const Term row{pair.ours, pair.ours, pair.columns, pair.scale, false, nullptr, nullptr};
    const std::vector<float> arguments = samples(row, GpuProbe::ROWS);
    const std::vector<float> ours = probe.evaluate(ourText, pair.ours, arguments);
    const std::vector<float> theirs = probe.evaluate(theirText, pair.theirs, arguments, "toneMappingExposure = p[3];");
    double worst = 0;
    float largest = 0;
    for (std::size_t i = 0; i < GpuProbe::ROWS; ++i) {
      const glm::vec3 a(ours[4 * i], ours[4 * i + 1], ours[4 * i + 2]),
          b(theirs[4 * i], theirs[4 * i + 1], theirs[4 * i + 2]);
      worst = std::max(worst, relativeError(row, a, glm::dvec3(b)));
      largest = std::max({largest, b.x, b.y, b.z});
    }
    std::printf("%-80s %9.1e\n", pair.ours, worst);
    EXPECT_LE(worst, TOLERANCE) << pair.ours;
    EXPECT_GT(largest, 0) << pair.theirs << " was not evaluated";
  }
}

}  // namespace
}  // namespace telar::test::three_test
