// One mip level of moments of a normal map's texels. Included after momentsOfTexel().
// FROM_IMAGE 1: level 0, of the normal map's own texels; 0: a smaller one, of its moments.
#include "texture/beside.glsl"

uniform sampler2D sourceMap;

out vec4 fragmentColor;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 texel = texelFetch(sourceMap, at, 0);
#if FROM_IMAGE
  vec4 beside = vec4(0.0);
#if BESIDE
  beside = besideTexel(besideMap, at, textureSize(sourceMap, 0));
#endif
  fragmentColor = momentsOfTexel(texel.rgb, beside);
#else
  fragmentColor = texel;
#endif
}
