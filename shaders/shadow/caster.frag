// What a light sees. Of the alpha, three.js's depth material knows the texture alone. Only depth is kept, or before 0.182 a
// packed one: the depth of a flat map, the distance to a point light.
// ALPHA_MAP 1: a base colour map tells where there is nothing.
// EVERY_HOLE 1: light gets through the holes of a net, however small, and through what is blended by its alpha: so many texels of the
// map are left out, evenly, for the filter to average; of each layer others.
precision highp float;
precision highp int;
#include "shading/three_terms.glsl"
#if ALPHA_MAP
#include "sampler_precision.glsl"
uniform sampler2D baseColorMap;
in vec2 vBaseColorUv;
#endif
#if ALPHA_MAP || EVERY_HOLE
uniform float alphaCutoff;  // of the texture's alpha; 0 = it is blended
#endif
#if EVERY_HOLE
uniform float alphaFactor;  // of what is blended; of a net 1, whose cutoff is divided by it
#include "shadow/layer_threshold.glsl"
#if ALPHA_MAP
#include "material/sampled_level.glsl"
#endif
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
#if EVERY_HOLE
  float alpha = alphaFactor;
  float threshold = layerThreshold();
#if ALPHA_MAP
  alpha *= texture(baseColorMap, vBaseColorUv).a;
  // In smaller levels alpha is the share that is there.
  float level = sampledLevel(vBaseColorUv, vec2(textureSize(baseColorMap, 0)));
  if (alphaCutoff > 0.0) threshold = mix(alphaCutoff, threshold, min(level, 1.0));
#endif
  if (alpha <= threshold) discard;
#elif ALPHA_MAP
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
