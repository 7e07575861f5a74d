// One mip level of a map of facets (facets.glsl). Level 0 is seen from near, place by place: it has the texel's normal, so that between
// texels it blends as the normal map does, and B is no share there.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/facets.glsl"

#if FROM_IMAGE
vec4 momentsOfTexel(vec3 texel, vec4 beside) {
  vec3 n = texel * 2.0 - 1.0;
  float length2 = dot(n, n);
  if (length2 <= 1e-4) return vec4(0.0, 0.0, 1.0, 0.0);
  n.z = max(n.z, sqrt(length2) / STEEPEST);
  return vec4(n, dot(n.xy, n.xy) / n.z);
}
#endif

#include "texture/normal_level.glsl"
