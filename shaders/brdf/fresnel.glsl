// Fresnel terms and the colours that feed them. Shared text: see README.md.

// How far the reflectance has gone from f0 to f90, [0, 1]; stands for (1 - LoH)^5 and is at most 0.0038 off it.
// LoH  [0, 1]
// src: Karis 2013, "Real Shading in Unreal Engine 4", spherical Gaussian form; order of three r187
float F_SchlickWeight(float LoH) {
  return exp2((-5.55473 * LoH - 6.98316) * LoH);
}

// The same with the exact power, for the models that were written with it.
// cosine  [0, 1]
// src: Schlick 1994
float F_SchlickWeight5(float cosine) {
  float grazing = saturate(1.0 - cosine);
  return pow4(grazing) * grazing;
}

// Reflectance of the interface, linear Rec.709.
// f0   [0, 1]  at normal incidence      f90  [0, 1]  at grazing incidence      LoH  [0, 1], equals VoH
// src: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15; order of three r187
vec3 F_Schlick(vec3 f0, float f90, float LoH) {
  float weight = F_SchlickWeight(LoH);
  return f0 * (1.0 - weight) + (f90 * weight);
}

// Albedo that is left for the diffuse lobe, linear Rec.709, [0, 1].
// baseColor  linear Rec.709 [0, 1]      metallic  [0, 1]
// src: Khronos glTF 2.0 specification, appendix B
vec3 diffuseAlbedo(vec3 baseColor, float metallic) {
  return baseColor * (1.0 - metallic);
}
