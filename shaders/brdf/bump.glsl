// Where a normal map and the surface disagree on which side light and viewer are. Shared text: see README.md.

// The shading normal. If it faces away from the viewer, it is turned until it just faces him.
// n, v  unit      return  unit
vec3 normalFacing(vec3 n, vec3 v) {
  float away = 1.0e-3 - dot(n, v);
  return away > 0.0 ? safeNormalize(n + v * away, v) : n;
}

// Rounding of the squared cosine of two equal unit vectors: below it there are no bumps.
const float UNIT_ROUNDING = 1.0e-6;

// Square of the width that the mapped normal stands for, [0, 1], of bumpTerminator().
// surface  unit, of the geometry      mapped  unit
float bumpAlpha2(vec3 surface, vec3 mapped) {
  float cosine2 = pow2(max(abs(dot(surface, mapped)), 1.0e-3));
  return saturate(0.125 * (1.0 - UNIT_ROUNDING - cosine2) / cosine2);
}

// Share of the light that reaches the bumps for which a mapped normal stands, [0, 1]. It falls to 0 towards the horizon of the
// surface, in place of a hard edge.
// cosine  [-1, 1], between the light and the normal of the geometry
// src: Estevez, Lecocq & Stein 2019, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem", Ray
//      Tracing Gems, chapter 12
float bumpTerminator(float alpha2, float cosine) {
  float c = max(cosine, 0.0);
  return 2.0 * c / max(c + sqrt(pow2(c) + alpha2 * (1.0 - pow2(c))), COSINE_EPSILON);
}

// Mean of bumpTerminator() over light from everywhere, weighted by the cosine, [0.77, 1]: within 4e-4 of the integral.
// alpha2  [0, 1]
float bumpMean(float alpha2) {
  float alpha = sqrt(alpha2);
  return 1.0 - alpha2 * (1.7 - 0.32416163 * alpha) / (1.0 + 5.05 * alpha);
}
