// Slopes of a normal map's texels, and the texels of the map with variance that is made of them.

const float STEEPEST = 8.0;         // slope that a texel can have: its z is kept above 1/8 of its length
const float DEVIATION_MAX = 1.0;    // standard deviation of slopes that 1.0 in a texel stands for

// Slope of the surface along tangent and bitangent, for the colour of a normal map.
vec2 slopeOfTexel(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  float length2 = dot(n, n);
  return length2 > 1e-4 ? n.xy / max(n.z, sqrt(length2) / STEEPEST) : vec2(0.0);
}

// RG: x and y of the mean normal, as in a normal map. BA: 0 .. DEVIATION_MAX, standard deviation of the slope along
// tangent and bitangent.
vec4 texelOfMoments(vec2 meanSlope, vec2 meanSquare) {
  vec3 n = normalize(vec3(meanSlope, 1.0));
  vec2 deviation = sqrt(max(meanSquare - meanSlope * meanSlope, 0.0));
  return vec4(0.5 + 0.5 * n.xy, min(deviation / DEVIATION_MAX, 1.0));
}
