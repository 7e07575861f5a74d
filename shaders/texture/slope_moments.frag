// Mean slopes of a normal map and the mean of their squares, from one mip level to the next.
// FROM_IMAGE 1: the larger level is the normal map itself; 0: moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/box.glsl"
#include "texture/slope.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // mean of the slope along x and y, mean of its square along x and y

vec4 momentsAt(ivec2 at) {
  vec4 texel = texelFetch(sourceMap, at, 0);
#if FROM_IMAGE
  vec2 slope = slopeOfTexel(texel.rgb);
  return vec4(slope, slope * slope);
#else
  return texel;
#endif
}

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
