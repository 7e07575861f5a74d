// One mip level of a texture with holes: the colour of what is there, and the share of the texel that is. Of a blended texture the
// colour is times the share, so that between texels, too, what is not there has none.
// FROM_IMAGE 1: level 0, of a cut-out texture as it is, alpha for the sharp edge; 0: a smaller one, from its moments.
// src: Porter & Duff 1984, "Compositing Digital Images": premultiplied colours are what is averaged
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/coverage.glsl"

uniform sampler2D sourceMap;

out vec4 fragmentColor;  // linear Rec.709: the target encodes it

void main() {
  vec4 texel = texelFetch(sourceMap, ivec2(gl_FragCoord.xy), 0);
#if FROM_IMAGE
  fragmentColor = cutoff > 0.0 ? texel : vec4(texel.rgb * texel.a, texel.a);
#else
  fragmentColor = cutoff > 0.0 ? vec4(texel.rgb / (texel.a + CUT_OUT_WEIGHT), texel.a) : texel;
#endif
}
