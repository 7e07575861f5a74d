// One mip level of a normal map with variance: see texelOfMoments().
// FROM_IMAGE 1: level 0, whose texels have no variance; 0: a smaller one, from its moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/slope.glsl"

uniform sampler2D sourceMap;

out vec4 fragmentColor;

void main() {
  vec4 texel = texelFetch(sourceMap, ivec2(gl_FragCoord.xy), 0);
#if FROM_IMAGE
  vec2 slope = slopeOfTexel(texel.rgb);
  fragmentColor = texelOfMoments(slope, slope * slope);
#else
  fragmentColor = texelOfMoments(texel.rg, texel.ba);
#endif
}
