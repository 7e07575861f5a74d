// What of a cloth's base colour is metal's.
// YARNS 1: it is woven, and a map tells which yarn lies on top.
// The map beside it is that of metallic-roughness: B metalness.
#include "texture/beside.glsl"

uniform sampler2D sourceMap;  // base colour; moments where FROM_IMAGE is 0
#if YARNS
uniform sampler2D yarnMap;  // A 0 weft .. 1 warp
#endif

// RGB base colour times metalness, linear Rec.709, A metalness times the share of the warp.   at  texel of the base colour
vec4 metalOfTexel(ivec2 at) {
  ivec2 count = textureSize(sourceMap, 0);
  vec4 color = vec4(texelFetch(sourceMap, at, 0).rgb, 1.0);
#if YARNS
  color.a = besideTexel(yarnMap, at, count).a;
#endif
  return color * besideTexel(besideMap, at, count).b;
}
