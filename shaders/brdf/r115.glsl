// What three.js r115 shaded differently from r187. Shared text: see README.md.
// src: three r115, lights_physical_pars_fragment; listings 6.1 to 6.13 of the thesis that telar grew from

// Roughness that is shaded, [0.04, 1]; no geometric roughness.
// perceptualRoughness  [0, 1]
float roughnessR115(float perceptualRoughness) {
  return clamp(perceptualRoughness, 0.04, 1.0);
}

// The authored reflectivity of a dielectric, [0, 1]: 0.5 for an index of 1.5.
// ior  [1, inf)
float reflectivityFromIor(float ior) {
  return saturate(2.5 * (ior - 1.0) / (ior + 1.0));
}

// Normal reflectance, linear Rec.709, [0, 1].
// reflectivity  [0, 1]      metallic  [0, 1]
vec3 specularF0R115(vec3 baseColor, float reflectivity, float metallic) {
  return mix(vec3(0.16 * pow2(reflectivity)), baseColor, metallic);
}

// What a coat of index 1.5 takes from the layers beneath it: stands for its directional-hemispherical reflectance, [0.04, 1].
// perceptualRoughness  of the coat [0, 1]      cosine  NoL for a light, NoV for the environment [0, 1]
float clearcoatDHR(float perceptualRoughness, float cosine) {
  return 0.04 + 0.96 * F_SchlickWeight5(cosine) * pow2(1.0 - perceptualRoughness);
}

// Sheen lobe, which stood in place of the base specular lobe; [1/sr], linear Rec.709.
// alpha  (0, 1]  the base's perceptual roughness as it is, not squared
vec3 Fr_SheenR115(vec3 sheenColor, float alpha, float NoV, float NoL, float NoH) {
  return sheenColor * (D_Charlie(alpha, NoH) * V_Neubelt(NoV, NoL));
}
