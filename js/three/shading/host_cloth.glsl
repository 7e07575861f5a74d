// Maps that js/three/shading/texture_bake.mjs makes of three.js's own, and the samples that coverage.mjs draws in turn.
#if NORMAL_MAP
uniform sampler2D normalVarianceMap;
vec4 normalTexel() { return texture(normalVarianceMap, vNormalMapUv); }
uniform vec2 reliefAxis;  // as the server's
#if NORMAL_FACETS
vec4 normalTexel(float lodBias) { return texture(normalVarianceMap, vNormalMapUv, lodBias); }
vec4 sharpNormalTexel(ivec2 at) { return texelFetch(normalVarianceMap, at, 0); }
uniform vec2 normalMapPeriod;  // as the server's
vec2 normalMapSize() { return vec2(textureSize(normalVarianceMap, 0)); }
#endif
#endif

#if CLEARCOAT_NORMAL_MAP
uniform sampler2D clearcoatNormalVarianceMap;
vec4 coatNormalTexel() { return texture(clearcoatNormalVarianceMap, vClearcoatNormalMapUv); }
#endif

#if ALPHA_TO_COVERAGE || ALPHA_MEANS
uniform sampler2D coverageMap;  // sRGB
#endif

#if ALPHA_TO_COVERAGE
#define vBaseColorUv vMapUv
#define baseColorMap coverageMap
uniform int coverageSamples;    // of a pixel
uniform int coverageMask;       // bits of those that are covered where this draw is seen
uniform int coverageDraw;       // as the server's
bool isCovered(int mask) { return mask != 0 && mask == coverageMask; }
#endif

#if NORMAL_HOLES
float shareThere() { return texture(coverageMap, vMapUv).a; }
#endif

#if METAL_MEANS
uniform sampler2D metalMap;  // sRGB
vec3 colorTexel() { return texture(map, vMapUv).rgb; }
vec4 metalTexel() { return texture(metalMap, vMapUv); }
#endif

#if YARN_RELIEF
uniform sampler2D yarnReliefMap;
vec4 yarnReliefTexel() { return texture(yarnReliefMap, vNormalMapUv); }
#endif

#if AMBIENT_VISIBILITY
in vec4 vVisibility;
#if AMBIENT_VISIBILITY_BACK
in vec4 vVisibilityBack;
#endif
#endif
