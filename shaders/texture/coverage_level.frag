// One mip level of a cut-out texture: the colour of what is there, and the share of the texel that is.
// FROM_IMAGE 1: level 0, as it is, alpha for the sharp edge; 0: a smaller one, from its moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/coverage.glsl"

uniform sampler2D sourceMap;

out vec4 fragmentColor;  // linear Rec.709: the target encodes it

void main() {
  vec4 texel = texelFetch(sourceMap, ivec2(gl_FragCoord.xy), 0);
#if FROM_IMAGE
  fragmentColor = texel;
#else
  fragmentColor = vec4(texel.rgb / (texel.a + CUT_OUT_WEIGHT), texel.a);
#endif
}
