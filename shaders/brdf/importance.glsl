// Importance sampling of lobes, and the densities of the samples. In the frame of the lobe: z is the normal; directions are
// unit and point away from the surface; densities are per steradian. Shared text: see README.md.

// u  [0, 1)^2
vec3 sampleCosine(vec2 u) {
  float radius = sqrt(u.x);
  float phi = 2.0 * PI * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), sqrt(max(1.0 - u.x, 0.0)));
}

// Density of sampleCosine, 0 below the horizon.
float pdfCosine(float NoL) {
  return max(NoL, 0.0) * RECIPROCAL_PI;
}

// Uniform over the hemisphere.
// u  [0, 1)^2
vec3 sampleHemisphere(vec2 u) {
  float radius = sqrt(max(1.0 - u.x * u.x, 0.0));
  float phi = 2.0 * PI * u.y;
  return vec3(radius * cos(phi), radius * sin(phi), u.x);
}

// Density of sampleHemisphere, 0 below the horizon.
float pdfHemisphere(float NoL) {
  return NoL >= 0.0 ? 0.5 * RECIPROCAL_PI : 0.0;
}

// Directions of the sheen's linearly transformed cosine, in its frame. Their density is sheenLtcCosine() / ltc.x.
// ltc  of sheenLtc()      u  [0, 1)^2
// src: Heitz et al. 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", section 3
vec3 sampleSheenLtc(vec3 ltc, vec2 u) {
  vec3 w = sampleCosine(u);
  return normalize(vec3((w.x - ltc.z * w.z) / ltc.y, w.y / ltc.y, max(w.z, 1.0e-6)));
}

// Microfacet normal of a GGX surface among those that v sees.
// v  z > 0      alpha  widths along x and y, (0, 1]      u  [0, 1)^2
// src: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"
vec3 sampleVisibleNormal(vec3 v, vec2 alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha.x * v.x, alpha.y * v.y, v.z));
  float z = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
  float radius = sqrt(max(1.0 - z * z, 0.0));
  float phi = 2.0 * PI * u.x;
  vec3 h = vec3(radius * cos(phi), radius * sin(phi), z) + stretched;
  return normalize(vec3(alpha.x * h.x, alpha.y * h.y, max(h.z, 1.0e-9)));
}

// Directions of the GGX lobe: v reflected about sampleVisibleNormal(v). They may lie below the horizon.
vec3 sampleReflection(vec3 v, vec2 alpha, vec2 u) {
  vec3 h = sampleVisibleNormal(v, alpha, u);
  return 2.0 * dot(v, h) * h - v;
}

// Density of sampleReflection(). Over the whole sphere of l it integrates to 1.
// src: Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), eq. 17
float pdfReflection(vec3 v, vec3 l, vec2 alpha) {
  vec3 h = safeNormalize(v + l, vec3(0.0, 0.0, -1.0));
  vec3 wide = vec3(h.x / alpha.x, h.y / alpha.y, h.z);
  float k = dot(wide, wide);
  float distribution = RECIPROCAL_PI / (alpha.x * alpha.y * k * k);
  vec3 seen = vec3(alpha.x * v.x, alpha.y * v.y, v.z);
  return v.z > 0.0 && h.z > 0.0 ? distribution / (2.0 * (v.z + length(seen))) : 0.0;
}

// Weight of a sample under multiple importance sampling by two techniques: the power heuristic with exponent 2.
// own, other  densities of the technique that drew it and of the other, each times its number of samples, >= 0
// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.13
float powerHeuristic(float own, float other) {
  float ratio = other / max(own, 1.0e-30);
  return 1.0 / (1.0 + ratio * ratio);
}
