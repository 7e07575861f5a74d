// Share of a texture with holes that is there, and its mean colour, from one mip level to the next.
// FROM_IMAGE 1: the larger level is the texture itself; 0: moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/box.glsl"
#include "texture/coverage.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // mean of the colour by weight, mean of the coverage

vec4 momentsAt(ivec2 at) {
  vec4 texel = texelFetch(sourceMap, at, 0);
#if FROM_IMAGE
  float there = shareOfTexel(texel.a);
  return vec4(texel.rgb * (cutoff > 0.0 ? there + CUT_OUT_WEIGHT : there), there);
#else
  return texel;
#endif
}

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
