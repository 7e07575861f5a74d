// Visibility terms, V = G / (4 NoV NoL). Shared text: see README.md.

// Height-correlated Smith masking and shadowing for GGX. Symmetric in NoV and NoL.
// alpha  (0, 1]  = perceptualRoughness^2      NoV, NoL  [0, 1]
// return [0, 5e5]; at NoV = NoL = 0 the floor of the denominator answers
// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 2; order of three r187
float V_SmithGGXCorrelated(float alpha, float NoV, float NoL) {
  float a2 = pow2(alpha);
  float gv = NoL * sqrt(a2 + (1.0 - a2) * pow2(NoV));
  float gl = NoV * sqrt(a2 + (1.0 - a2) * pow2(NoL));
  return 0.5 / max(gv + gl, VISIBILITY_EPSILON);
}
