// One mip level of a map of what of a base colour is metal's (metal.glsl).
// FROM_IMAGE 1: level 0, of the maps' own texels; 0: a smaller one, of its moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/metal.glsl"

out vec4 fragmentColor;  // linear Rec.709: the target encodes it

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
#if FROM_IMAGE
  fragmentColor = metalOfTexel(at);
#else
  fragmentColor = texelFetch(sourceMap, at, 0);
#endif
}
