// Normal maps as three.js holds them: for all shadings but cloth's.
#if NORMAL_MAP
vec4 normalTexel() {
  vec4 texel = texture(normalMap, vNormalMapUv);
#ifdef USE_PACKED_NORMALMAP
  vec2 n = 2.0 * texel.xy - 1.0;
  texel.z = 0.5 + 0.5 * sqrt(clamp(1.0 - dot(n, n), 0.0, 1.0));
#endif
  return texel;
}
#endif

#if CLEARCOAT_NORMAL_MAP
vec4 coatNormalTexel() { return texture(clearcoatNormalMap, vClearcoatNormalMapUv); }
#endif
