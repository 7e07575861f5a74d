// Diffuse lobe of a thin scattering sheet: fibres that each scatter once, and what they hand on. Shared text: see README.md.
// One bounce goes by the law of Lommel and Seeliger, which fills the limb; more bounces bring back what it leaves, so that a
// white sheet reflects all light from every side.
// src: Seeliger 1887; Kulla & Conty 2017 for the second part, its colour as in eonMultipleAlbedo()

// Directional albedo of one bounce for albedo 1, [0.153, 0.5].   cosine  [0, 1]
float sheetAlbedo(float cosine) {
  return 0.5 * (1.0 - cosine * log((1.0 + cosine) / max(cosine, 1.0e-6)));
}

// Albedo of what bounces more than once, linear Rec.709.
vec3 sheetMultiple(vec3 rho) {
  return rho * rho * SHEET_AVERAGE / (1.0 - rho * (1.0 - SHEET_AVERAGE));
}

// Lobe times NoL, [1/sr], linear Rec.709. Without NoL it is reciprocal.
// albedo  linear Rec.709 [0, 1]      NoV, NoL  [0, 1]
vec3 Fd_SheetCosine(vec3 albedo, float NoV, float NoL) {
  vec3 rho = saturate(albedo);
  float single = 0.25 * NoL / max(NoL + NoV, COSINE_EPSILON);
  float multiple = NoL * (1.0 - sheetAlbedo(NoV)) * (1.0 - sheetAlbedo(NoL)) / (1.0 - SHEET_AVERAGE);
  return (rho * single + sheetMultiple(rho) * multiple) * RECIPROCAL_PI;
}

// Its directional albedo, linear Rec.709.
vec3 sheetReflectance(vec3 albedo, float NoV) {
  vec3 rho = saturate(albedo);
  float once = sheetAlbedo(NoV);
  return rho * once + sheetMultiple(rho) * (1.0 - once);
}
