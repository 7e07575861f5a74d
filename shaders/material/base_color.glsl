// What a fragment has without light: colour and coverage, and what it emits.

vec4 baseColorAndAlpha() {
  vec4 color = baseColorFactor;
#if BASE_COLOR_MAP
  color *= texture(baseColorMap, vBaseColorUv);
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
