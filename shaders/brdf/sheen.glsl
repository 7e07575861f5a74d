// Sheen: the fuzz on top of a cloth (KHR_materials_sheen). Shared text: see README.md.

// Inverted-Gaussian distribution. D NoH integrates to 1 over the hemisphere of h.
// alpha  [1e-8, 1]  = sheenRoughness^2      NoH  [0, 1]
// return [1/sr]
// The floor of sin^2 is 2^-7, so that its square is above 0 in fp16; with it the integral is 1 within 4e-4.
// src: Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF", eq. 2; floor of three r187
float D_Charlie(float alpha, float NoH) {
  float inverseAlpha = 1.0 / alpha;
  float sin2 = max(1.0 - NoH * NoH, 0.0078125);
  return (2.0 + inverseAlpha) * pow(sin2, inverseAlpha * 0.5) / (2.0 * PI);
}

// Visibility of cloth fibres, without a shadowing term of its own.
// NoV, NoL  [0, 1]      return [0, 1]; the floor answers NoV = NoL = 0
// src: Neubelt & Pettineo 2013, "Crafting a Next-gen Material Pipeline for The Order: 1886"; cap of three r187
float V_Neubelt(float NoV, float NoL) {
  return saturate(1.0 / max(4.0 * (NoL + NoV - NoL * NoV), 1.0e-5));
}

// Sheen lobe before the cosine of the light, [1/sr], linear Rec.709.
// sheenColor  linear Rec.709 [0, 1]      sheenRoughness  perceptual, [1e-4, 1]
// src: order of three r187
vec3 Fr_Sheen(vec3 sheenColor, float sheenRoughness, float NoV, float NoL, float NoH) {
  return sheenColor * (D_Charlie(pow2(sheenRoughness), NoH) * V_Neubelt(NoV, NoL));
}

// Directional albedo of the sheen lobe, a fit, [0, 1].
// sheenRoughness  perceptual, [0, 1]      NoV  [0, 1]
// src: curve of three r187, fitted to Estevez & Kulla 2017; not the albedo of Fr_Sheen (mean 0.11 off below 0.5)
float sheenAlbedo(float sheenRoughness, float NoV) {
  float r2 = sheenRoughness * sheenRoughness;
  float inverse = 1.0 / (sheenRoughness + 0.1);
  float a = -1.9362 + 1.0678 * sheenRoughness + 0.4573 * r2 - 0.8469 * inverse;
  float b = -0.6014 + 0.5538 * sheenRoughness - 0.4670 * r2 - 0.1255 * inverse;
  return saturate(exp(a * NoV + b));
}

// Sheen lobe of three.js r115, which stood in place of the base specular lobe; [1/sr], linear Rec.709.
// alpha  (0, 1]  the base's perceptual roughness as it is, not squared
vec3 Fr_SheenR115(vec3 sheenColor, float alpha, float NoV, float NoL, float NoH) {
  return sheenColor * (D_Charlie(alpha, NoH) * V_Neubelt(NoV, NoL));
}
