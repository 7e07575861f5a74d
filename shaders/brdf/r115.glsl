// What three.js r115 shaded differently from r187. Shared text: see README.md.
// src: three r115, lights_physical_pars_fragment; listings 6.1 to 6.13 of the thesis that telar grew from

// Roughness that is shaded, [0.04, 1]; no geometric roughness.
// perceptualRoughness  [0, 1]
float roughnessR115(float perceptualRoughness) {
  return clamp(perceptualRoughness, 0.04, 1.0);
}

// Normal reflectance, linear Rec.709, [0, 1].
// reflectivity  [0, 1]: of a dielectric as authored, 0.5 for an index of 1.5      metallic  [0, 1]
vec3 specularF0R115(vec3 baseColor, float reflectivity, float metallic) {
  return mix(vec3(0.16 * pow2(reflectivity)), baseColor, metallic);
}

// What a coat of index 1.5 takes from the layers beneath it: stands for its directional-hemispherical reflectance, [0.04, 1].
// perceptualRoughness  of the coat [0, 1]      cosine  NoL for a light, NoV for the environment [0, 1]
float clearcoatDHR(float perceptualRoughness, float cosine) {
  return 0.04 + 0.96 * F_SchlickWeight5(cosine) * pow2(1.0 - perceptualRoughness);
}

// Reflectance of a rough interface as its environment saw it: at grazing it rises no higher than 1 - roughness.
// perceptualRoughness  [0, 1]      f0  linear Rec.709 [0, 1]
vec3 F_SchlickRoughness(vec3 f0, float perceptualRoughness, float NoV) {
  vec3 f90 = max(f0, 1.0 - perceptualRoughness);
  return (f90 - f0) * F_SchlickWeight(NoV) + f0;
}

// What the interface sends back of uniform light, by the number of bounces; linear Rec.709.
// dfg  see multiscatter.glsl, here of dfgKaris(), which is a little below 0 for a black metal: no light is taken there
Scattering multipleScatteringR115(vec3 f0, float perceptualRoughness, float NoV, vec2 dfg) {
  vec3 single = max(F_SchlickRoughness(f0, perceptualRoughness, NoV) * dfg.x + dfg.y, 0.0);
  float ems = 1.0 - (dfg.x + dfg.y);
  vec3 favg = F_SchlickAverage(f0);
  vec3 fms = single * favg / (1.0 - ems * favg);
  return Scattering(single, fms * ems);
}
