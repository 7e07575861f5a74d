// Albedo of a GGX lobe in closed form. What it does not reflect goes to the lobes below.
// Shared text: see README.md. The numbers are fitted to the exact integrals by `node test/fits/cloth_energy.mjs`. Both
// sides of every coupled lobe go by the same curve, so that it is reciprocal whatever the error of the fit.

// Coefficients of the curve of the part of the reflectance that belongs to f90.   r  perceptual roughness, (0, 1]
vec4 grazingCurve(float r) {
  float n1 = -0.2037537 + r * (5.228794 - r * 10.03187);
  float q0 = 0.62014 + r * (3.359124 + r * (-3.627132 + r * 1.558323));
  float q1 = 0.6659579 + r * (-1.713347 + r * (-3.442731 + r * 16.68406));
  float q2 = 2.488344 + r * (0.9767137 - r * 6.302822);
  return vec4(pow2(n1), 1.0 + r * pow2(q0), pow2(q1), pow2(q2));
}

// Curves of one roughness.   perceptualRoughness  [PERCEPTUAL_ROUGHNESS_MIN, 1]
GlossCurve glossCurve(float perceptualRoughness) {
  float r = perceptualRoughness;
  float r2 = r * r;
  float m0 = pow2(0.1722752 + r * (0.1449183 + r * 0.9587954));
  float m1 = pow2(0.02384477 + r * (-0.0343379 + r * 2.601833));
  float k0 = 0.007781421 + r * (-1.468594 + r * 0.8729609);
  float k1 = -0.1979422 + r * (1.122898 + r * 1.332237);
  float k2 = 0.8220883 + r * (-3.029146 + r * 4.002057);
  return GlossCurve(vec4(r2 * m0, r2 * (m1 - m0), r2 * r * pow2(k0), r * pow2(k1)), pow2(k2), grazingCurve(r));
}

// Share of light of this direction that a lobe of f0 = f90 = 1 does not reflect at once, [0, 0.7].   cosine  [0, 1]
float glossMissing(GlossCurve curve, float cosine) {
  float numerator = cosine * (curve.missing.x + curve.missing.y * cosine);
  return numerator / (curve.missing.z + cosine * (curve.missing.w + cosine * (curve.missingSlope + cosine)));
}

// Share of the lobe's albedo that belongs to f90, [0, 1].   cosine  [0, 1]
float glossGrazing(vec4 curve, float cosine) {
  return pow2((1.0 - cosine) * (1.0 + curve.x * cosine) / (curve.y + cosine * (curve.z + cosine * curve.w)));
}

// By how much glossGrazing() is above the exact share. Its fit errs to one side only, so that no cloth reflects more than it gets. For
// a dielectric this is up to a sixth of a rough gloss and a tenth of a smoother one, so uniform light subtracts it. Within
// 0.004 of the difference to the exact integrals.
// perceptualRoughness  [0, 1]      cosine  [0, 1]
float grazingExcess(float perceptualRoughness, float cosine) {
  float r = perceptualRoughness;
  float between = cosine * (1.0 - cosine);
  float smoother = max(0.43 - 7.0 * pow2(r - 0.25), 0.0) * between * between * between;
  return smoother + clamp(0.029 * (r - 0.61), 0.0, 0.0071) * pow2(1.0 - pow2(cosine));
}

// x: glossMissing(), y: glossGrazing(). The lobe's albedo is f0 (1 - x - y) + f90 y.
// cosine  [0, 1]
vec2 glossAlbedo(GlossCurve curve, float cosine) {
  return vec2(glossMissing(curve, cosine), glossGrazing(curve.grazing, cosine));
}

// Both over the cosine-weighted hemisphere, by a quadrature whose nodes are fitted to these curves.
vec2 glossAverage(GlossCurve curve) {
  return glossAlbedo(curve, 0.02598168) * 0.002542228 + glossAlbedo(curve, 0.120406) * 0.03768536 +
         glossAlbedo(curve, 0.3735179) * 0.2702435 + glossAlbedo(curve, 0.8084923) * 0.6889268;
}

// Share of the light not reflected after one bounce that leaves after more bounces between the microfacets.
// f0, f90  [0, 1]      averageMissing  x of glossAverage()
// src: Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks", with the colour of the first bounce as
//      in Hill 2018, "A Multi-Faceted Exploration (Part 2)"
vec3 returningShare(vec3 f0, float f90, float averageMissing) {
  vec3 average = f0 + (f90 - f0) * (1.0 / 21.0);
  return average * average * (1.0 - averageMissing) / (1.0 - average * averageMissing);
}

// Whole albedo of a rough interface, linear Rec.709, [0, 1].
// albedo  of glossAlbedo()      returning  of returningShare()
vec3 interfaceAlbedo(vec3 f0, float f90, vec3 returning, vec2 albedo) {
  return f0 * (1.0 - albedo.x - albedo.y) + f90 * albedo.y + returning * albedo.x;
}
