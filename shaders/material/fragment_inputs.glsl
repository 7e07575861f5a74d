// What the other files read of the renderer: material factors, textures, what the vertex stage gives. js/three/shading/host.glsl
// is the same of three.js. Factors are linear Rec.709; sRGB textures are decoded by the sampler.
uniform vec4 baseColorFactor;
uniform float alphaCutoff;
uniform float metallicFactor;
uniform float roughnessFactor;  // perceptual
uniform vec3 emissiveFactor;

#include "material/varyings.glsl"
#include "shadow/varyings.glsl"
#if BASE_COLOR_MAP
uniform sampler2D baseColorMap;  // sRGB
#endif
#if METAL_MEANS
uniform sampler2D metalMap;  // sRGB: as texture/metal.glsl has it
#endif
#if YARN_RELIEF
uniform sampler2D yarnReliefMap;  // as texture/yarns.glsl has it
#endif
#if METALLIC_ROUGHNESS_MAP
uniform sampler2D metallicRoughnessMap;  // linear, G roughness, B metalness
#endif
#if NORMAL_MAP
uniform sampler2D normalMap;  // linear
uniform vec2 normalScale;
#if NORMAL_VARIANCE
uniform vec2 reliefAxis;  // of the whole map, in its tangent space; of reliefTowards() (texture/relief_axis.frag)
#endif
#if NORMAL_FACETS
uniform vec2 normalMapPeriod;  // sizes of the map after which its texels come again: 1, mirrored 2, 0 where the last ones go on
#endif
#endif
#if OCCLUSION_MAP
uniform sampler2D occlusionMap;  // linear, R
uniform float occlusionStrength;
#endif
#if EMISSIVE_MAP
uniform sampler2D emissiveMap;  // sRGB
#endif
#include "material/layer_declarations.glsl"
#if !UNLIT
uniform sampler2D dfgMap;  // RG = (A, B) of the split sum; x = perceptualRoughness, y = NoV, texel centres at (i + 0.5) / size
#endif
#if ALPHA_TO_COVERAGE
#if SAMPLE_MASK
uniform int coverageSamples;  // of a pixel: 1 or an even number
#else
const int coverageSamples = 1;
#endif
uniform int coverageDraw;  // what is drawn: COVERAGE_ of material/coverage.glsl
#endif

#if VISIBILITY_BUFFER
// What each fragment has of its triangle: front or back, its pixel in the picture, then the varyings (renderer/pass/plan/varyings.h).
uniform highp samplerBuffer varyingMap;
uniform int varyingTexels;  // of a fragment
uniform int varyingRow;     // of the fragments, the first that the map has

bool triangleFront = true;
vec2 trianglePixel = vec2(0.0);

// visibility/quad_varyings.h says where a texel lies; rows have 1024 fragments.
vec4 varyingTexel(int i) {
  ivec2 at = ivec2(gl_FragCoord.xy) - ivec2(0, varyingRow);
  int quad = ((at.y >> 2) * 256 + (at.x >> 2)) * 4 + (at.y & 2) + ((at.x >> 1) & 1);
  return texelFetch(varyingMap, (quad * varyingTexels + i) * 4 + (at.y & 1) * 2 + (at.x & 1));
}

// Written for the varyings that the program has.
void readVaryings();

bool frontFacing() { return triangleFront; }
vec2 pixelCentre() { return trianglePixel; }
#else
// Whether the front of the surface is seen.
bool frontFacing() { return gl_FrontFacing; }
// Centre of the fragment's pixel in the picture, pixels from the lower left corner.
vec2 pixelCentre() { return gl_FragCoord.xy; }
#endif

#if !UNLIT
// To the viewer, view space.
vec3 viewDirection() {
#if ORTHOGRAPHIC
  return vec3(0.0, 0.0, 1.0);
#else
  return normalize(vViewPosition);
#endif
}

// G roughness, B metalness.
vec4 metallicRoughnessTexel() {
#if METALLIC_ROUGHNESS_MAP
  return texture(metallicRoughnessMap, vMetallicRoughnessUv);
#else
  return vec4(1.0);
#endif
}

#if METAL_MEANS
vec3 colorTexel() { return texture(baseColorMap, vBaseColorUv).rgb; }
vec4 metalTexel() { return texture(metalMap, vBaseColorUv); }
#endif

#if YARN_RELIEF
vec4 yarnReliefTexel() { return texture(yarnReliefMap, vNormalUv); }
#endif

// Of a normal map, or of the map of slopes that was made of it (NORMAL_VARIANCE).
#if NORMAL_MAP
vec4 normalTexel() { return texture(normalMap, vNormalUv); }
#if NORMAL_FACETS
vec4 normalTexel(float lodBias) { return texture(normalMap, vNormalUv, lodBias); }
// Its first level.
vec4 sharpNormalTexel(ivec2 at) { return texelFetch(normalMap, at, 0); }
vec2 normalMapSize() { return vec2(textureSize(normalMap, 0)); }
#endif
#endif
#if CLEARCOAT_NORMAL_MAP
vec4 coatNormalTexel() { return texture(clearcoatNormalMap, vClearcoatNormalUv); }
#endif
#if OCCLUSION_MAP
#if OCCLUSION_WITH_ROUGHNESS
float occlusionTexel() { return metallicRoughnessTexel().r; }
#else
float occlusionTexel() { return texture(occlusionMap, vOcclusionUv).r; }
#endif
#endif

// (A, B) of the split sum.
#if THREE_DFG_TERM == THREE_DFG_KARIS
vec2 dfgKaris(float perceptualRoughness, float NoV);
vec2 splitSum(float perceptualRoughness, float NoV) { return dfgKaris(perceptualRoughness, NoV); }
#else
vec2 splitSum(float perceptualRoughness, float NoV) { return textureLod(dfgMap, vec2(perceptualRoughness, NoV), 0.0).rg; }
#endif
#endif

#if ALPHA_TO_COVERAGE
// Whether a draw covers a pixel whose covered samples are the bits of `mask`.
bool isCovered(int mask) { return mask != 0; }
#endif
#if NORMAL_HOLES
// Share of what the maps show that is there.
float shareThere() { return texture(baseColorMap, vBaseColorUv).a; }
#endif
