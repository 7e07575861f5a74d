// One mip level of a map of relief: RGB the mean of unit normals, A that of how flat they lie (relief.glsl).
// FROM_IMAGE 1: level 0, of the normal map's own texels; 0: a smaller one, of its moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/relief.glsl"

uniform sampler2D sourceMap;

out vec4 fragmentColor;

void main() {
  vec4 texel = texelFetch(sourceMap, ivec2(gl_FragCoord.xy), 0);
#if FROM_IMAGE
  fragmentColor = reliefWithHoles(texel.rgb, gl_FragCoord.xy / vec2(textureSize(sourceMap, 0)));
#else
  fragmentColor = texel;
#endif
}
