// What of a cloth's base colour is metal's.
// YARNS 1: it is woven, and a map tells which yarn lies on top.
uniform sampler2D sourceMap;  // base colour; moments where FROM_IMAGE is 0
uniform sampler2D coverMap;   // metallic-roughness: B metalness
#if YARNS
uniform sampler2D yarnMap;    // A 0 weft .. 1 warp
#endif

// RGB base colour times metalness, linear Rec.709, A metalness times the share of the warp.   at  texel of the base colour
vec4 metalOfTexel(ivec2 at) {
  vec2 place = (vec2(at) + 0.5) / vec2(textureSize(sourceMap, 0));
  vec4 color = vec4(texelFetch(sourceMap, at, 0).rgb, 1.0);
#if YARNS
  color.a = textureLod(yarnMap, place, 0.0).a;
#endif
  return color * textureLod(coverMap, place, 0.0).b;
}
