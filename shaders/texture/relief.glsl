// Normals of a normal map's texels.

const float STEEPEST = 8.0;  // slope that a texel can have: its z is kept above 1/8 of its length

// RGB the unit normal, A the share of a flat texel that it is: 1 / (1 + 4 slope^2). The mean of that is told by the many texels that
// lie flat, where the mean of squared slopes is told by the few edges.
// texel  colour of a normal map
vec4 reliefOfTexel(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  float length2 = dot(n, n);
  if (length2 <= 1e-4) return vec4(0.0, 0.0, 1.0, 1.0);
  vec2 slope = n.xy / max(n.z, sqrt(length2) / STEEPEST);
  return vec4(normalize(vec3(slope, 1.0)), 1.0 / (1.0 + 4.0 * dot(slope, slope)));
}
