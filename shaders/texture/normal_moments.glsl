// From one mip level of moments of a normal map's texels to the next. Included after momentsOfTexel(), which has them of one texel.
// FROM_IMAGE 1: the larger level is the normal map itself; 0: moments.
#include "texture/box.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // of momentsOfTexel()

#if FROM_IMAGE
vec3 texelAt(int x, int y) { return texelFetch(sourceMap, ivec2(x, y), 0).rgb; }

// One of the four points of a texel.
// side    -1 or 1: towards which neighbours
// beside  sum of the two neighbours that share an edge with the texel
vec4 pointOf(ivec2 at, vec2 side, vec3 texel, vec3 beside, vec3 corner) {
  vec2 place = (vec2(at) + 0.5 + 0.25 * side) / sourceSize;
  return momentsOfTexel((9.0 * texel + 3.0 * beside + corner) / 16.0, place);
}

// Between the middles of texels the sampler blends them, and a texture in full detail is seen so: means over texels alone would
// be too steep. Four points of each texel, between it and its neighbours, which are those across the edge at the texture's edges.
vec4 momentsAt(ivec2 at) {
  ivec2 last = ivec2(sourceSize) - 1;
  ivec2 low = ivec2(at.x > 0 ? at.x - 1 : last.x, at.y > 0 ? at.y - 1 : last.y);
  ivec2 high = ivec2(at.x < last.x ? at.x + 1 : 0, at.y < last.y ? at.y + 1 : 0);
  vec3 texel = texelAt(at.x, at.y);
  vec3 left = texelAt(low.x, at.y), right = texelAt(high.x, at.y);
  vec3 below = texelAt(at.x, low.y), above = texelAt(at.x, high.y);
  vec4 sum = pointOf(at, vec2(-1.0), texel, left + below, texelAt(low.x, low.y));
  sum += pointOf(at, vec2(1.0, -1.0), texel, right + below, texelAt(high.x, low.y));
  sum += pointOf(at, vec2(-1.0, 1.0), texel, left + above, texelAt(low.x, high.y));
  sum += pointOf(at, vec2(1.0), texel, right + above, texelAt(high.x, high.y));
  return 0.25 * sum;
}
#else
vec4 momentsAt(ivec2 at) { return texelFetch(sourceMap, at, 0); }
#endif

void main() {
  moments = boxMean(floor(gl_FragCoord.xy));
}
