// What telar's shading reads of three.js: in place of shaders/material/fragment_inputs.glsl, shaders/light/*_inputs.glsl.
// The other inputs of the layers are written from js/material/table.mjs.

// Names that differ.
#define alphaCutoff alphaTest
#define baseColorFactor vec4(diffuse, opacity)
#define metallicFactor metalness
#define roughnessFactor roughness
#define occlusionStrength aoMapIntensity
#define vNormalUv vNormalMapUv
#define vClearcoatNormalUv vClearcoatNormalMapUv
#define vUv0 vUv
#define ambientIrradiance ambientLightColor
#define environmentMaxLod float(ENVMAP_MAX_LOD)
#define ltcInverseMap ltc_1
#define ltcAlbedoMap ltc_2

bool frontFacing() { return gl_FrontFacing; }

vec3 viewDirection() { return isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition); }

vec2 splitSum(float perceptualRoughness, float NoV) { return texture(dfgLUT, vec2(perceptualRoughness, NoV)).rg; }

vec4 metallicRoughnessTexel() {
  vec4 texel = vec4(1.0);
#ifdef USE_ROUGHNESSMAP
  texel.g = texture(roughnessMap, vRoughnessMapUv).g;
#endif
#ifdef USE_METALNESSMAP
  texel.b = texture(metalnessMap, vMetalnessMapUv).b;
#endif
  return texel;
}

#if OCCLUSION_MAP
float occlusionTexel() { return texture(aoMap, vAoMapUv).r; }
#endif

// three.js gives no number for a light on the shaded point itself: it gives no light.
vec3 lightDirection(vec3 l) { return any(isnan(l)) ? vec3(0.0) : l; }
