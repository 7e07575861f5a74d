// What a light sees. Of the alpha, three.js's depth material knows the texture alone. Only depth is kept, or before 0.182 a
// packed one: the depth of a flat map, the distance to a point light.
precision highp float;
#include "shading/three_terms.glsl"
#if ALPHA_MASK
#include "sampler_precision.glsl"
uniform sampler2D baseColorMap;
uniform float alphaCutoff;
in vec2 vBaseColorUv;
#endif
#if PACKED_DEPTH + PACKED_DISTANCE > 0
#include "shadow/packing.glsl"
out vec4 packedTexel;
#endif
#if PACKED_DEPTH
in vec2 vDepth;
#endif
#if PACKED_DISTANCE
uniform vec2 range;          // near and far, metres
uniform vec3 lightPosition;  // world
in vec3 vWorldPosition;
#endif

void main() {
#if ALPHA_MASK
  if (texture(baseColorMap, vBaseColorUv).a < alphaCutoff) discard;
#endif
#if PACKED_DEPTH
  packedTexel = packedDepth(0.5 * vDepth.x / vDepth.y + 0.5);
#endif
#if PACKED_DISTANCE
  float reach = length(vWorldPosition - lightPosition);
  packedTexel = packedDepth(clamp((reach - range.x) / (range.y - range.x), 0.0, 1.0));
#endif
}
