// From one mip level of moments of a normal map's texels to the next. Included after momentsOfTexel(), which has them of one texel.
// POINTS_PER_TEXEL: of each texel as they are seen, 4 or 1.
// FROM_IMAGE 1: the larger level is the normal map itself; 0: moments.
// HALVES 1: both sides are halved exactly; 0: any size.
#include "texture/beside.glsl"

uniform sampler2D sourceMap;

out vec4 moments;  // of momentsOfTexel()

#if FROM_IMAGE
// Between the middles of texels the sampler blends them, and a texture in full detail is seen so: means over texels alone would
// be too steep. Four points of each texel, a quarter towards its neighbours, which are those across the edge at the texture's edges.
const float TOWARDS_NEIGHBOUR = 0.25;

struct Texel {
  vec3 normal;
  vec4 beside;  // BESIDE_FITS only
};

Texel texelAt(int x, int y) {
  Texel texel = Texel(texelFetch(sourceMap, ivec2(x, y), 0).rgb, vec4(0.0));
#if BESIDE_FITS
  texel.beside = texelFetch(besideMap, ivec2(x, y), 0);
#endif
  return texel;
}

Texel towards(Texel texel, Texel neighbour) {
  return Texel(mix(texel.normal, neighbour.normal, TOWARDS_NEIGHBOUR), mix(texel.beside, neighbour.beside, TOWARDS_NEIGHBOUR));
}

int before(int at, int count) { return at > 0 ? at - 1 : count - 1; }

int after(int at, int count) { return at < count - 1 ? at + 1 : 0; }

// Two points of a texel, towards the texels before and after it in its row.
struct Pair {
  Texel low, high;
};

// side  -1 or 1: towards which neighbours the point lies
vec4 momentsOfPoint(ivec2 at, vec2 side, Texel row, Texel otherRow) {
  Texel point = towards(row, otherRow);
#if BESIDE && !BESIDE_FITS
  point.beside = besideAt(besideMap, (vec2(at) + 0.5 + TOWARDS_NEIGHBOUR * side) / vec2(textureSize(sourceMap, 0)));
#endif
  return momentsOfTexel(point.normal, point.beside);
}

// Mean over the four points of a texel.
vec4 momentsOfPoints(ivec2 at, Pair below, Pair row, Pair above) {
  return 0.25 * (momentsOfPoint(at, vec2(-1.0), row.low, below.low) + momentsOfPoint(at, vec2(1.0, -1.0), row.high, below.high) +
                 momentsOfPoint(at, vec2(-1.0, 1.0), row.low, above.low) + momentsOfPoint(at, vec2(1.0), row.high, above.high));
}
#endif

#if FROM_IMAGE && HALVES
// Four texels have 12 neighbours together, where each alone has eight.
void main() {
  ivec2 at = 2 * ivec2(gl_FragCoord.xy), count = textureSize(sourceMap, 0);
  ivec4 x = ivec4(before(at.x, count.x), at.x, at.x + 1, after(at.x + 1, count.x));
  ivec4 y = ivec4(before(at.y, count.y), at.y, at.y + 1, after(at.y + 1, count.y));
  Pair left[4], right[4];
  for (int i = 0; i < 4; ++i) {
    Texel first = texelAt(x[1], y[i]), second = texelAt(x[2], y[i]);
    left[i] = Pair(towards(first, texelAt(x[0], y[i])), towards(first, second));
    right[i] = Pair(towards(second, first), towards(second, texelAt(x[3], y[i])));
  }
#if POINTS_PER_TEXEL == 4
  moments = momentsOfPoints(ivec2(x[1], y[1]), left[0], left[1], left[2]) +
            momentsOfPoints(ivec2(x[2], y[1]), right[0], right[1], right[2]) +
            momentsOfPoints(ivec2(x[1], y[2]), left[1], left[2], left[3]) +
            momentsOfPoints(ivec2(x[2], y[2]), right[1], right[2], right[3]);
#else
  // Another one of the four in each texel.
  moments = momentsOfPoint(ivec2(x[1], y[1]), vec2(-1.0), left[1].low, left[0].low) +
            momentsOfPoint(ivec2(x[2], y[1]), vec2(1.0), right[1].high, right[2].high) +
            momentsOfPoint(ivec2(x[1], y[2]), vec2(1.0, -1.0), left[2].high, left[1].high) +
            momentsOfPoint(ivec2(x[2], y[2]), vec2(-1.0, 1.0), right[2].low, right[3].low);
#endif
  moments *= 0.25;
}
#else
#include "texture/box.glsl"

#if FROM_IMAGE
Pair pairAt(int x, int y) {
  int count = textureSize(sourceMap, 0).x;
  Texel texel = texelAt(x, y);
  return Pair(towards(texel, texelAt(before(x, count), y)), towards(texel, texelAt(after(x, count), y)));
}

vec4 momentsAt(ivec2 at) {
  int count = textureSize(sourceMap, 0).y;
  return momentsOfPoints(at, pairAt(at.x, before(at.y, count)), pairAt(at.x, at.y), pairAt(at.x, after(at.y, count)));
}
#else
vec4 momentsAt(ivec2 at) { return texelFetch(sourceMap, at, 0); }
#endif

void main() { moments = boxMean(floor(gl_FragCoord.xy)); }
#endif
