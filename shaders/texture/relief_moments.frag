// Means of a normal map's unit normals and of how flat they lie, from one mip level to the next.
// FROM_IMAGE 1: the larger level is the normal map itself; 0: moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/box.glsl"
#include "texture/relief.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // of reliefOfTexel()

vec4 momentsAt(ivec2 at) {
  vec4 texel = texelFetch(sourceMap, at, 0);
#if FROM_IMAGE
  return reliefOfTexel(texel.rgb);
#else
  return texel;
#endif
}

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
