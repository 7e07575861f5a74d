// Means of a normal map's unit normals and of how flat they lie, from one mip level to the next.
// FROM_IMAGE 1: the larger level is the normal map itself; 0: moments.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/box.glsl"
#include "texture/relief.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // of reliefOfTexel()

#if FROM_IMAGE
vec3 texelBeside(ivec2 at, ivec2 step) {
  ivec2 size = ivec2(sourceSize);
  return texelFetch(sourceMap, (at + step + size) % size, 0).rgb;
}

// Between the middles of texels the sampler blends them, and a texture in full detail is seen so: means over texels alone would
// be too steep. Four points of each texel, between it and its neighbours.
vec4 momentsAt(ivec2 at) {
  vec3 texel = texelFetch(sourceMap, at, 0).rgb;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 side = 2 * ivec2(i & 1, i >> 1) - 1;
    vec3 beside = texelBeside(at, ivec2(side.x, 0)) + texelBeside(at, ivec2(0, side.y));
    vec2 place = (vec2(at) + 0.5 + 0.25 * vec2(side)) / sourceSize;
    sum += reliefWithHoles((9.0 * texel + 3.0 * beside + texelBeside(at, side)) / 16.0, place);
  }
  return 0.25 * sum;
}
#else
vec4 momentsAt(ivec2 at) { return texelFetch(sourceMap, at, 0); }
#endif

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
