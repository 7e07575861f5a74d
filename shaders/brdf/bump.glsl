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

// Share of uniform light that diffuse reflection keeps where a mapped normal leans, as no light comes from below the surface. Within
// 0.01 of the integral. It is linear in the cosine for all but the steepest normals, so that the mean cosine gives the mean share.
// cosine  [0, 1], between the surface and the mapped normal, times the length of the mean normal
float bumpMean(float cosine) { return max(1.0 - 0.87 * (1.0 - cosine), 0.27 + 0.43 * cosine); }

// Mean direction of that light: the mapped normal, bent towards the surface's. Within 2 degrees.
// surface, mapped  unit      return  unit
vec3 bumpBent(vec3 surface, vec3 mapped) {
  float sine2 = saturate(1.0 - pow2(dot(surface, mapped)));
  return safeNormalize(mapped + surface * (sqrt(sine2) * (0.58 + 0.28 * sine2)), mapped);
}

// Share of uniform light that a gloss keeps there: that of its one direction for a narrow lobe, that of diffuse light for the widest.
// cosine  [-1, 1], between the surface and the lobe's mean direction      mean  bumpMean()
float bumpGloss(float perceptualRoughness, float alpha2, float cosine, float mean) {
  return mix(bumpTerminator(alpha2, cosine), mean, perceptualRoughness);
}
