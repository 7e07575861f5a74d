// Specular lobes put together from D, V and F, before the cosine of the light. Shared text: see README.md.

// Isotropic GGX lobe, single scattering, [1/sr], linear Rec.709. Reciprocal: symmetric in NoV and NoL.
// f0, f90  as in F_Schlick      alpha  (0, 1]      NoV, NoL, NoH, LoH  [0, 1]
// src: Cook & Torrance 1982, "A Reflectance Model for Computer Graphics"; order of three r187
vec3 Fr_GGX(vec3 f0, float f90, float alpha, float NoV, float NoL, float NoH, float LoH) {
  vec3 fresnel = F_Schlick(f0, f90, LoH);
  float visibility = V_SmithGGXCorrelated(alpha, NoV, NoL);
  float distribution = D_GGX(alpha, NoH);
  return fresnel * (visibility * distribution);
}
