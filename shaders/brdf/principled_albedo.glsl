// Directional albedos of the diffuse, sheen and coat lobes of the principled models, for light from everywhere.
// Shared text: see README.md. "exact": the integral in closed form; else a fit with its largest error for NoV > 0.02.

// Exact albedo of the diffuse factor (1 + g FL)(1 + g FV), where g = constant + slope LoH^2.
// For Fd_Burley constant = -1/2 and slope = 2 roughness; with 0.5 roughness - 1 and 2 roughness it is Frostbite's.
float diffuseFresnelAlbedo(float constant, float slope, float NoV) {
  float fv = F_SchlickWeight5(NoV);
  // Means over cosine-weighted directions of 1, LoH^2 and LoH^4, without and with FL; LoH^2 = (1 + l.v) / 2.
  float c = 0.5 + NoV / 3.0;
  float fl = 1.0 / 21.0;
  float cFl = 0.5 * (1.0 / 21.0 + NoV / 84.0);
  float c2Fl = 0.25 * (1.0 / 21.0 + NoV / 42.0 + pow2(NoV) / 252.0 + 0.5 * (1.0 - pow2(NoV)) * (11.0 / 252.0));
  float g = constant + slope * c;
  float gFl = constant * fl + slope * cFl;
  float g2Fl = pow2(constant) * fl + 2.0 * constant * slope * cFl + pow2(slope) * c2Fl;
  return 1.0 + gFl + fv * (g + g2Fl);
}

// Exact albedo of Fd_Burley.
float burleyAlbedo(float perceptualRoughness, float NoV) {
  return diffuseFresnelAlbedo(-0.5, 2.0 * perceptualRoughness, NoV);
}

// Exact albedo of Fd_BurleyRenormalised.
float burleyRenormalisedAlbedo(float perceptualRoughness, float NoV) {
  float scale = mix(1.0, 1.0 / 1.51, perceptualRoughness);
  return diffuseFresnelAlbedo(0.5 * perceptualRoughness - 1.0, 2.0 * perceptualRoughness, NoV) * scale;
}

// Exact albedo of Fd_HanrahanKrueger.
float hanrahanKruegerAlbedo(float perceptualRoughness, float NoV) {
  float r = perceptualRoughness;
  float v = max(NoV, 1.0e-4);
  float v2 = v * v;
  float u = 1.0 + v;
  float logarithm = log(u / v);
  // a, b: integrals of 2 x^(n + 1) / (x + v) over [0, 1], without and with (1 - x)^5.
  float a0 = 2.0 - 2.0 * v * logarithm;
  float a1 = 1.0 - v * a0;
  // Integral of (1 - x)^5 / (x + v), from that of 1 / (x + v) up.
  float k = u * (u * (u * (u * (u * logarithm - 1.0) - 0.5) - 1.0 / 3.0) - 0.25) - 0.2;
  float b0 = 1.0 / 3.0 - 2.0 * v * k;
  float b1 = 1.0 / 21.0 - v * b0;
  float b2 = 1.0 / 84.0 - v * b1;
  // The same with LoH^2 and LoH^4 in the integrand.
  float cA = 0.5 * (a0 + v * a1);
  float cB = 0.5 * (b0 + v * b1);
  float c2B = 0.25 * (b0 + 2.0 * v * b1 + v2 * b2 + 0.5 * (1.0 - v2) * (b0 - b2));
  float fv = F_SchlickWeight5(v);
  // Mean of Fss / (NoL + NoV), where Fss = (1 + g FL)(1 + g FV) and g = r LoH^2 - 1.
  float divided = a0 + (r * cB - b0) + fv * (r * cA - a0 + r * r * c2B - 2.0 * r * cB + b0);
  return 1.25 * (divided - 0.5 * diffuseFresnelAlbedo(-1.0, r, v) + 0.5);
}

// Albedo of Fr_SheenDisney per unit of its colour, within 1e-4.
float sheenAlbedoDisney(float NoV) {
  return max(0.088469 + NoV * (-0.250648 + NoV * (0.270689 + NoV * (-0.135808 + NoV * 0.027551))), 0.0);
}

// Albedo of Fr_SheenR115 per unit of its colour, within 0.012.
// alpha  [0.07, 1], clamped
float sheenAlbedoR115(float alpha, float NoV) {
  float x = log(max(alpha, 0.07));
  float level = -0.6119 + x * (-0.2049 + x * 0.0288);
  float slope = -1.2825 + x * (0.2150 - x * 0.2408);
  float bend = -0.0395 + x * (0.3644 - x * 0.1539);
  return exp(level + NoV * (slope + NoV * bend));
}

// Albedo of D_Charlie V_CharlieSoftened, within 0.06.
// sheenRoughness  perceptual [0.07, 1], clamped
float sheenAlbedoEstevezKulla(float sheenRoughness, float NoV) {
  float x = log(max(sheenRoughness, 0.07));
  float level = -0.0906 + x * (0.7467 + x * (0.6647 + x * 0.1315));
  float slope = -2.4102 + x * (-0.7124 + x * (-2.2062 + x * 0.4344));
  float bend = 0.7361 + x * (0.6426 + x * (-1.0713 - x * 1.4253));
  return min(exp(level + NoV * (slope + NoV * bend)), 1.3);
}

// Albedo of D_Ashikhmin V_Neubelt, within 0.03.
// sheenRoughness  perceptual [0.07, 1], clamped
float sheenAlbedoVelvet(float sheenRoughness, float NoV) {
  float x = max(sheenRoughness, 0.07);
  float level = -0.8517 + x * (-0.3254 + x * (3.7885 - x * 3.3949));
  float slope = -0.2985 + x * (-3.8210 + x * (-4.7143 + x * 8.5900));
  float bend = -0.5307 + x * (7.9708 + x * (-9.9166 + x * 1.4935));
  return exp(level + NoV * (slope + NoV * bend));
}

// Albedo of Fr_ClearcoatDisney per unit of its weight, within 0.005.
// gloss  [0, 1]
float clearcoatAlbedoDisney(float gloss, float NoV) {
  float width = log(mix(0.1, 0.001, gloss));
  float x = sqrt(NoV);
  float level = 0.05783 + x * (0.12077 + x * (-1.17076 + x * (2.50701 + x * (-2.25639 + x * 0.74944))));
  float slope = 0.00440 + x * (0.06359 + x * (-0.57478 + x * (1.41240 + x * (-1.38802 + x * 0.48219))));
  return max(level + width * slope, 0.0);
}

// What is left of (A, B) of the split sum where Smith's visibility is separable in place of height-correlated, within 0.05.
vec2 separableShare(float perceptualRoughness, float NoV) {
  float alpha = max(pow2(perceptualRoughness), 0.001);
  float loss = alpha * pow(saturate(1.0 - NoV), 2.0 / alpha);
  return vec2(1.0 - 0.36 * loss, 1.0 - 0.45 * loss);
}
