// Normals of a normal map's texels.

const float STEEPEST = 8.0;  // slope that a texel can have: its z is kept above 1/8 of its length

// Of a texel without a direction there is none.
vec2 slopeOfTexel(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  float length2 = dot(n, n);
  return length2 > 1e-4 ? n.xy / max(n.z, sqrt(length2) / STEEPEST) : vec2(0.0);
}

// RGB the unit normal, A the share of a flat texel that it is: 1 / (1 + 4 slope^2). The mean of that is told by the many texels that
// lie flat, where the mean of squared slopes is told by the few edges.
// texel  colour of a normal map
vec4 reliefOfTexel(vec3 texel) {
  vec2 slope = slopeOfTexel(texel);
  return vec4(normalize(vec3(slope, 1.0)), 1.0 / (1.0 + 4.0 * dot(slope, slope)));
}

// Holes lie flat: how much of a level they are is known from the map of coverage, or from the alpha of what is blended, so that
// they can be taken out again (material/normal.glsl).
// BESIDE 1: there is such a map; 0: there are no holes.
#if BESIDE
#include "texture/coverage.glsl"
#endif

// cover  texel of the map of coverage
vec4 reliefWithHoles(vec3 texel, vec4 cover) {
#if BESIDE
  return mix(vec4(0.0, 0.0, 1.0, 1.0), reliefOfTexel(texel), shareOfTexel(cover.a));
#else
  return reliefOfTexel(texel);
#endif
}
