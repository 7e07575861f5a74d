// What a fragment has without light: colour and coverage, and what it emits.

#if ALPHA_MEANS
#include "material/straight_texel.glsl"
#endif

vec4 baseColorAndAlpha() {
  vec4 color = baseColorFactor;
#if BASE_COLOR_MAP
#if ALPHA_MEANS
  color *= straightTexel(texture(baseColorMap, vBaseColorUv));
#else
  color *= texture(baseColorMap, vBaseColorUv);
#endif
#endif
#if VERTEX_COLOR
  color *= vColor;
#endif
  return color;
}

#if EMISSIVE
// Linear Rec.709.
vec3 emittedRadiance() {
#if EMISSIVE_MAP
  return emissiveFactor * texture(emissiveMap, vEmissiveUv).rgb;
#else
  return emissiveFactor;
#endif
}
#endif
