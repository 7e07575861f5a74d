// One mip level of a map of slopes: RG the mean slope along tangent and bitangent, BA the mean of its square.
// FROM_IMAGE 1: level 0, of the normal map's own texels; 0: a smaller one, of its moments.
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
  fragmentColor = vec4(slope, slope * slope);
#else
  fragmentColor = texel;
#endif
}
