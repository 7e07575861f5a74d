// Slopes of a normal map's texels.

const float STEEPEST = 8.0;  // slope that a texel can have: its z is kept above 1/8 of its length

// Slope of the surface along tangent and bitangent, for the colour of a normal map.
vec2 slopeOfTexel(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  float length2 = dot(n, n);
  return length2 > 1e-4 ? n.xy / max(n.z, sqrt(length2) / STEEPEST) : vec2(0.0);
}
