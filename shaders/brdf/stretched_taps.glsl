// A GGX lobe of two widths as a few lobes of one, by which a prefiltered environment is read. Shared text: see README.md.
// src: Kautz & McCool 2000, "Approximation of Glossy Reflection with Prefiltered Environment Maps"

// How many: as many as the lobe is longer than wide, [1, 4].   wide, narrow  widths, (0, 1], wide >= narrow
float stretchedTaps(float wide, float narrow) { return wide > 1.6 * narrow ? 4.0 : wide > 1.15 * narrow ? 2.0 : 1.0; }

// Perceptual roughness of each: they overlap along the wide axis.
float tapRoughness(float wide, float narrow, float taps) {
  float part = min(1.2 / taps, 1.0);
  return sqrt(sqrt(pow2(narrow) + pow2(part) * (pow2(wide) - pow2(narrow))));
}

// Direction of the light of one of them, unit, and its weight. It stands for an even share of the facets, by how much they lean
// along the axis: GGX over one axis has the quantiles wide u / sqrt(1 - u^2).
// n, axis, v  unit; axis is that of the wide width      u  (-1, 1)
vec4 stretchedTap(vec3 n, vec3 axis, vec3 v, float wide, float u) {
  vec3 facet = n + axis * (wide * u * inversesqrt(1.0 - pow2(u)));
  float seen = dot(v, facet);
  vec3 l = facet * (2.0 * seen / dot(facet, facet)) - v;
  return vec4(l, max(seen, 0.0) * saturate(8.0 * dot(n, l)));
}
