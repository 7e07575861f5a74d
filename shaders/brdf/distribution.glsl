// Normal distributions. Shared text: see README.md.

// Trowbridge-Reitz (GGX). D NoH integrates to 1 over the hemisphere of h.
// alpha  (0, 1]  = perceptualRoughness^2      NoH  [0, 1]
// return [1/sr], up to 1 / (PI alpha^2): 77 625 at the roughness floor
// The denominator cancels near the peak: in fp32 its relative error is about 2^-23 / denominator.
// src: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33; order of three r187
float D_GGX(float alpha, float NoH) {
  float a2 = pow2(alpha);
  float denominator = pow2(NoH) * (a2 - 1.0) + 1.0;
  return RECIPROCAL_PI * a2 / pow2(denominator);
}
