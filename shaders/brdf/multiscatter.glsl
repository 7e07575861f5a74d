// Energy of light that bounces more than once between the microfacets. Shared text: see README.md.
// dfg  (A, B) of the split sum at (perceptualRoughness, NoV): directional albedo of the GGX lobe = f0 A + f90 B,
//      each [0, 1], A + B in [0.34, 1.0002] for the 16 x 16 table of three r187

// Average of Schlick's reflectance over the cosine-weighted hemisphere for f90 = 1, linear Rec.709.
// f0  [0, 1]
// src: Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image-Based Lighting", JCGT 8(1), eq. 14
vec3 F_SchlickAverage(vec3 f0) {
  return f0 + (1.0 - f0) * 0.047619;
}

// Directional albedo under a uniform environment, split by the number of bounces, linear Rec.709.
// f0  [0, 1]      f90  [0, 1]      dfg  see above
// For f0 = f90 = 1 the two parts sum to 1 at every roughness.
// src: Fdez-Aguera 2019, JCGT 8(1), eq. 12-16; order of three r187
Scattering multipleScattering(vec3 f0, float f90, vec2 dfg) {
  vec3 single = f0 * dfg.x + f90 * dfg.y;
  float ems = 1.0 - (dfg.x + dfg.y);
  vec3 favg = F_SchlickAverage(f0);
  vec3 fms = single * favg / (1.0 - ems * favg);
  return Scattering(single, fms * ems);
}

// Scattering of a part-metal interface, linear Rec.709.
// metallic  [0, 1]
// src: three r187
Scattering mixScattering(Scattering dielectric, Scattering metal, float metallic) {
  return Scattering(mix(dielectric.single, metal.single, metallic), mix(dielectric.multiple, metal.multiple, metallic));
}

// Share of the light that passes the dielectric interface and reaches the diffuse lobe, linear Rec.709, [0, 1].
// dielectric  of f0 [0, 0.5]; towards f0 = 1 nothing is left and rounding may take it an ulp below 0
// src: three r187
vec3 diffuseShare(Scattering dielectric) {
  return 1.0 - (dielectric.single + dielectric.multiple);
}

// Factor on the single-scattering GGX lobe of a punctual light, >= 1, linear Rec.709. It depends on the viewer only, so
// the product is not reciprocal.
// f0  [0, 1], of the whole material      dfg  see above
// src: Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models", eq. 16; order of three r187
vec3 directCompensation(vec3 f0, vec2 dfg) {
  return 1.0 + f0 * (1.0 / (dfg.x + dfg.y) - 1.0);
}
