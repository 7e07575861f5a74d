// One mip level of a map of facets (facets.glsl). Level 0 is seen from near, texel by texel: all of it counts as facet.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/facets.glsl"

#if FROM_IMAGE
vec4 momentsOfTexel(vec3 texel, vec2 at) {
  vec2 slope = slopeOfTexel(texel);
  return vec4(slope, 1.0, dot(slope, slope));
}
#endif

#include "texture/normal_level.glsl"
