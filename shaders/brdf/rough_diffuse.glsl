// Energy-preserving rough diffuse lobe (KHR_materials_diffuse_roughness). Shared text: see README.md.
// src: Portsmouth, Kutz & Hill 2025, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", JCGT 14(1); order of three r187

// Normalisation A of the Fujii Oren-Nayar lobe, (0, 1].   diffuseRoughness  [0, 1]
float fonNormalisation(float diffuseRoughness) {
  return 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * diffuseRoughness);
}

// Directional albedo of that lobe for albedo 1, [0, 1].
float fonAlbedo(float diffuseRoughness, float cosine) {
  float m = 1.0 - cosine;
  float g = m * (0.0571085289 + m * (0.491881867 + m * (-0.332181442 + m * 0.0714429953)));
  return fonNormalisation(diffuseRoughness) * (1.0 + diffuseRoughness * g);
}

// Average albedo of that lobe for albedo 1, [0, 1].
float fonAverageAlbedo(float diffuseRoughness) {
  return fonNormalisation(diffuseRoughness) * (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * PI)) * diffuseRoughness);
}

// Albedo of light that bounces more than once, linear Rec.709.
vec3 eonMultipleAlbedo(vec3 rho, float average) {
  return rho * rho * average / max(1.0 - rho * (1.0 - average), EON_EPSILON);
}

// Diffuse lobe, [1/sr], linear Rec.709. Reciprocal.
// albedo  linear Rec.709 [0, 1]      diffuseRoughness  [0, 1]      LoV  [-1, 1], cosine between light and viewer
vec3 Fd_EON(vec3 albedo, float diffuseRoughness, float NoV, float NoL, float LoV) {
  vec3 rho = saturate(albedo);
  float s = LoV - NoL * NoV;
  float sOverT = s > 0.0 ? s / max(max(NoL, NoV), EON_EPSILON) : s;
  vec3 single = rho * RECIPROCAL_PI * fonNormalisation(diffuseRoughness) * (1.0 + diffuseRoughness * sOverT);
  float average = fonAverageAlbedo(diffuseRoughness);
  vec3 multiple = eonMultipleAlbedo(rho, average) * RECIPROCAL_PI * max(EON_EPSILON, 1.0 - fonAlbedo(diffuseRoughness, NoV)) *
                  max(EON_EPSILON, 1.0 - fonAlbedo(diffuseRoughness, NoL)) / max(EON_EPSILON, 1.0 - average);
  return single + multiple;
}

// Its directional albedo, linear Rec.709.
vec3 eonAlbedo(vec3 albedo, float diffuseRoughness, float NoV) {
  vec3 rho = saturate(albedo);
  float directional = fonAlbedo(diffuseRoughness, NoV);
  return rho * directional + eonMultipleAlbedo(rho, fonAverageAlbedo(diffuseRoughness)) * (1.0 - directional);
}
