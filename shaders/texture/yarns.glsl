// How flat yarns lie: slopes of the normal map and those of the weave map together, along each yarn and across it. A yarn is round
// across and straight along, so that one width for both would be too wide along.
#include "texture/relief.glsl"

float flatness(float slope) { return 1.0 / (1.0 + 4.0 * slope * slope); }

// Of the warp along (x) and across it (y), times its share; z and w of the weft.
// texel  colour of a normal map      weave  of the weave map
vec4 yarnsOfTexel(vec3 texel, vec4 weave) {
  vec2 slope = slopeOfTexel(texel);
  vec2 turn = 2.0 * weave.rg - 1.0;
  turn = dot(turn, turn) > 1e-4 ? normalize(turn) : vec2(1.0, 0.0);
  float rise = clamp(2.0 * weave.b - 1.0, -0.95, 0.95);
  rise *= inversesqrt(1.0 - rise * rise);
  float inTurn = dot(slope, turn);
  float aside = slope.y * turn.x - slope.x * turn.y;
  vec4 flat4 = vec4(flatness(aside - rise), flatness(inTurn), flatness(inTurn - rise), flatness(aside));
  return flat4 * vec4(weave.a, weave.a, 1.0 - weave.a, 1.0 - weave.a);
}
