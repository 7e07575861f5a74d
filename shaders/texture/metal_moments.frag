// Means of base colour times metalness (metal.glsl), from one mip level to the next: means of each alone do not tell which colour is metal's.
// FROM_IMAGE 1: the larger level is the maps themselves; 0: moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/box.glsl"
#include "texture/metal.glsl"

out vec4 moments;

vec4 momentsAt(ivec2 at) {
#if FROM_IMAGE
  return metalOfTexel(at);
#else
  return texelFetch(sourceMap, at, 0);
#endif
}

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
