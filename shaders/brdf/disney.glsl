// The principled model of 2012 and the thin surface of 2015. Shared text: see README.md.
// src unless said: Burley 2012, "Physically-Based Shading at Disney", section 5 and appendix B; code of wdas/brdf

// Brightness that tints are relative to.
// color  linear Rec.709
float luminanceDisney(vec3 color) {
  return dot(color, vec3(0.3, 0.6, 0.1));
}

// Hue and saturation of a colour at brightness 1; white for black.
vec3 tintDisney(vec3 baseColor) {
  float luminance = luminanceDisney(baseColor);
  return luminance > 0.0 ? baseColor / luminance : vec3(1.0);
}

// Normal reflectance, linear Rec.709.
// specular  [0, 1]: 0.5 is an index of 1.5      specularTint, metallic  [0, 1]
vec3 specularF0Disney(vec3 baseColor, float metallic, float specular, float specularTint) {
  vec3 dielectric = (0.08 * specular) * mix(vec3(1.0), tintDisney(baseColor), specularTint);
  return mix(dielectric, baseColor, metallic);
}

// From 1 to f90 as both directions go from normal to grazing.
float diffuseFresnel(float f90, float NoV, float NoL) {
  return mix(1.0, f90, F_SchlickWeight5(NoL)) * mix(1.0, f90, F_SchlickWeight5(NoV));
}

// Retro-reflective diffuse factor: times albedo / PI it is the lobe. At most 2.5^2 (grazing, rough).
// perceptualRoughness  [0, 1]: enters as it is, not squared
float Fd_Burley(float perceptualRoughness, float NoV, float NoL, float LoH) {
  float fd90 = 0.5 + 2.0 * pow2(LoH) * perceptualRoughness;
  return diffuseFresnel(fd90, NoV, NoL);
}

// The same, scaled so that it reflects no more than arrives.
// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 1
float Fd_BurleyRenormalised(float perceptualRoughness, float NoV, float NoL, float LoH) {
  float fd90 = 0.5 * perceptualRoughness + 2.0 * pow2(LoH) * perceptualRoughness;
  float scale = mix(1.0, 1.0 / 1.51, perceptualRoughness);
  return diffuseFresnel(fd90, NoV, NoL) * scale;
}

// Subsurface factor: times albedo / PI it is the lobe.
// src: Burley 2012, after Hanrahan & Krueger 1993; the floor answers NoV = NoL = 0
float Fd_HanrahanKrueger(float perceptualRoughness, float NoV, float NoL, float LoH) {
  float fss90 = pow2(LoH) * perceptualRoughness;
  float fss = diffuseFresnel(fss90, NoV, NoL);
  return 1.25 * (fss * (1.0 / max(NoL + NoV, 1.0e-5) - 0.5) + 0.5);
}

// Widths along tangent and bitangent, each [0.001, 3.2].
// anisotropic  [0, 1]
vec2 alphasDisney(float perceptualRoughness, float anisotropic) {
  float aspect = sqrt(1.0 - 0.9 * anisotropic);
  float alpha = pow2(perceptualRoughness);
  return vec2(max(0.001, alpha / aspect), max(0.001, alpha * aspect));
}

// One side of the separable Smith term, 2 / (cosine of that side) folded in; the product of both sides is V.
// cosine  [0, 1] with the normal; alongT, alongB  with tangent and bitangent [-1, 1]
float G1_SmithAnisotropic(float alphaT, float alphaB, float cosine, float alongT, float alongB) {
  float root = sqrt(pow2(alongT * alphaT) + pow2(alongB * alphaB) + pow2(cosine));
  return 1.0 / max(cosine + root, VISIBILITY_EPSILON);
}

// Long-tailed distribution of the coat. D NoH integrates to 1 over the hemisphere of h.
// alpha  (0, 0.5] or 1: close to 1 both sides of the fraction vanish, and fp32 with them
float D_GTR1(float alpha, float NoH) {
  if (alpha >= 1.0) return RECIPROCAL_PI;
  float a2 = pow2(alpha);
  return (a2 - 1.0) / (PI * log(a2) * (1.0 + (a2 - 1.0) * pow2(NoH)));
}

// The coat, added to what lies beneath; [1/sr].
// clearcoat  [0, 1]      gloss  [0, 1]: 0 satin, 1 gloss
float Fr_ClearcoatDisney(float clearcoat, float gloss, float NoV, float NoL, float NoH, float LoH) {
  float d = D_GTR1(mix(0.1, 0.001, gloss), NoH);
  float f = mix(0.04, 1.0, F_SchlickWeight5(LoH));
  float g = G1_SmithAnisotropic(0.25, 0.25, NoL, sqrt(max(1.0 - pow2(NoL), 0.0)), 0.0) *
            G1_SmithAnisotropic(0.25, 0.25, NoV, sqrt(max(1.0 - pow2(NoV), 0.0)), 0.0);
  return 0.25 * clearcoat * g * f * d;
}

// Sheen, added to the diffuse lobe; no distribution and no 1 / PI; [1/sr], linear Rec.709.
// sheen, sheenTint  [0, 1]
vec3 Fr_SheenDisney(vec3 baseColor, float sheen, float sheenTint, float LoH) {
  return sheen * mix(vec3(1.0), tintDisney(baseColor), sheenTint) * F_SchlickWeight5(LoH);
}

// Factors of a thin surface: x reflects, y transmits; each times albedo / PI is a lobe.
// diffuseTransmission  [0, 1]: the 0..2 of the paper halved      flatness  [0, 1]
// NoL  for the transmitted lobe the cosine on the other side
// src: Burley 2015, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", section 5.3
vec2 Fd_DisneyThin(float perceptualRoughness, float diffuseTransmission, float flatness, float NoV, float NoL, float LoH) {
  float fl = F_SchlickWeight5(NoL);
  float fv = F_SchlickWeight5(NoV);
  float rr = 2.0 * perceptualRoughness * pow2(LoH);
  float lambert = (1.0 - 0.5 * fl) * (1.0 - 0.5 * fv);
  float retro = rr * (fl + fv + fl * fv * (rr - 1.0));
  float flattened = Fd_HanrahanKrueger(perceptualRoughness, NoV, NoL, LoH);
  return vec2((1.0 - diffuseTransmission) * mix(lambert + retro, flattened, flatness), diffuseTransmission);
}
