// Anisotropic GGX: two widths about the tangent (KHR_materials_anisotropy). Shared text: see README.md.
// alphaT, alphaB  (0, 1]  along tangent and bitangent
// ToV BoV ToL BoL ToH BoH  [-1, 1], signed cosines with tangent and bitangent

// The floor is never reached where the axes are square with n. On a normal map they lean, and h may be square with all.
// src: Burley 2012, "Physically-Based Shading at Disney", appendix B, eq. 13, in the form of three r187
float D_GGXAnisotropic(float alphaT, float alphaB, float NoH, float ToH, float BoH) {
  float a2 = alphaT * alphaB;
  vec3 v = vec3(alphaB * ToH, alphaT * BoH, a2 * NoH);
  float w2 = a2 / max(dot(v, v), pow2(a2) * 1.0e-4);
  return RECIPROCAL_PI * a2 * pow2(w2);
}

// Half of what one is divided by to get the height-correlated Smith visibility, [0, 2]: 0 where NoV = NoL = 0.
// src: Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 99; order of three r187
float smithSumAnisotropic(float alphaT, float alphaB, float NoV, float NoL, float ToV, float BoV, float ToL, float BoL) {
  float gv = NoL * length(vec3(alphaT * ToV, alphaB * BoV, NoV));
  float gl = NoV * length(vec3(alphaT * ToL, alphaB * BoL, NoL));
  return gv + gl;
}

// Height-correlated Smith visibility.
float V_SmithGGXCorrelatedAnisotropic(float alphaT, float alphaB, float NoV, float NoL, float ToV, float BoV, float ToL, float BoL) {
  return 0.5 / max(smithSumAnisotropic(alphaT, alphaB, NoV, NoL, ToV, BoV, ToL, BoL), VISIBILITY_EPSILON);
}

// Width along the tangent: it grows from alpha to 1 with the strength.
// perceptualRoughness  [0, 1]      strength  [0, 1]
// src: Khronos KHR_materials_anisotropy; order of three r187
float alphaAlongTangent(float perceptualRoughness, float strength) {
  return mix(pow2(perceptualRoughness), 1.0, pow2(strength));
}

// Normal with which a stretched highlight reads the environment.
// src: McAuley 2015, "Rendering the World of Far Cry 4"; order of three r187
vec3 bentNormal(float perceptualRoughness, float strength, vec3 n, vec3 b, vec3 v) {
  vec3 bent = safeNormalize(cross(cross(b, v), b), n);
  return safeNormalize(mix(bent, n, pow2(pow2(1.0 - strength * (1.0 - perceptualRoughness)))), n);
}
