// What telar's shading reads in another form than three.js holds it.

#if METALLIC_ROUGHNESS_MAP
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
#endif

#if NORMAL_MAP
vec3 normalTexel() {
  vec3 texel = texture(normalMap, vNormalMapUv).xyz;
#ifdef USE_PACKED_NORMALMAP
  vec2 n = 2.0 * texel.xy - 1.0;
  texel.z = 0.5 + 0.5 * sqrt(clamp(1.0 - dot(n, n), 0.0, 1.0));
#endif
  return texel;
}
#endif

#if NORMAL_VARIANCE
#if NORMAL_MAP
uniform sampler2D normalVarianceMap;
#endif
#if CLEARCOAT_NORMAL_MAP
uniform sampler2D clearcoatNormalVarianceMap;
#endif
#endif
#if ALPHA_TO_COVERAGE
uniform sampler2D coverageMap;  // sRGB
uniform int coverageSamples;  // of a pixel
uniform int coverageMask;     // bits of those that are covered where this draw is seen
#endif

// three.js gives no number for a light on the shaded point itself: it gives no light.
vec3 lightDirection(vec3 l) { return any(isnan(l)) ? vec3(0.0) : l; }
