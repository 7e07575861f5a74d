// Cloth beyond stock three.js: robust distribution, coherent sheen, velvet. Shared text: see README.md.

// GGX without the cancellation at the peak: relative error 1e-4 at the roughness floor where the usual form has 18 %.
// alpha  (0, 1]      NoH  [0, 1]      NxH2  [0, 1]  squared length of n x h, from the vectors and not from NoH
// src: Guy & Agopian 2018, "Physically Based Rendering in Filament", section 4.4.1, Lagrange's identity
float D_GGXRobust(float alpha, float NoH, float NxH2) {
  float k = alpha / (NxH2 + pow2(NoH * alpha));
  return RECIPROCAL_PI * pow2(k);
}

// Its visibility times NoL, as one product: finite where both directions graze. Without the anisotropy's widths.
// alpha  (0, 1]      NoV, NoL  [0, 1]      return [0, 1 / (2 alpha)]
// src: Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 99
float V_SmithGGXCosine(float alpha, float NoV, float NoL) {
  float a2 = pow2(alpha);
  float gv = NoL * sqrt(a2 + (1.0 - a2) * pow2(NoV));
  float gl = NoV * sqrt(a2 + (1.0 - a2) * pow2(NoL));
  return 0.5 * NoL / max(gv + gl, COSINE_EPSILON);
}

// The same for two widths. The other arguments as in anisotropic.glsl.
float V_SmithGGXAnisotropicCosine(float alphaT, float alphaB, float NoV, float NoL, float ToV, float BoV, float ToL, float BoL) {
  float gv = NoL * length(vec3(alphaT * ToV, alphaB * BoV, NoV));
  float gl = NoV * length(vec3(alphaT * ToL, alphaB * BoL, NoL));
  return 0.5 * NoL / max(gv + gl, COSINE_EPSILON);
}

// Exponent curve of the Charlie masking fit.
// alpha  (0, 1]      x  [0, 1]
// src: Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF", table 1
float charlieCurve(float alpha, float x) {
  float k = pow2(1.0 - alpha);
  float a = mix(21.5473, 25.3245, k);
  float b = mix(3.82987, 3.32435, k);
  float c = mix(0.19823, 0.16801, k);
  float d = mix(-1.97760, -1.27393, k);
  float e = mix(-4.32054, -4.85967, k);
  return a / (1.0 + b * pow(x, c)) + d * x + e;
}

// Smith's Lambda of the Charlie distribution, >= 0.
// src: Estevez & Kulla 2017, eq. 3
float lambdaCharlie(float alpha, float cosine) {
  return exp(cosine < 0.5 ? charlieCurve(alpha, cosine) : 2.0 * charlieCurve(alpha, 0.5) - charlieCurve(alpha, 1.0 - cosine));
}

// Visibility of the Charlie distribution, its terminator softened on the light's side: not reciprocal.
// NoV, NoL  [1e-4, 1]: floored here
// src: Estevez & Kulla 2017, eq. 3 and 4
float V_CharlieSoftened(float alpha, float NoV, float NoL) {
  float v = max(NoV, 1.0e-4);
  float l = max(NoL, 1.0e-4);
  float softened = pow(lambdaCharlie(alpha, l), 1.0 + 2.0 * pow4(pow2(1.0 - l)));
  return 1.0 / ((1.0 + lambdaCharlie(alpha, v) + softened) * 4.0 * v * l);
}

// The fuzz of Uncharted 4: fibres that stand off a cloth. Returns its albedo under uniform light, [0, 1]; times NoL / PI it is a lobe.
// It depends on the viewer's angle alone and not on the light's direction, so it is not reciprocal. The layers below are not darkened
// by what it reflects.
// sheenRoughness  perceptual [0, 1]: how far the fibres stand off and how unlike they are      NoV  [0, 1]
// src: Jiang 2016, "The Process of Creating Volumetric-based Materials in Uncharted 4": powers of the viewer's cosine with weights and
//      exponents that an artist sets for each cloth. Those here are ours, for glTF's one roughness; together they are at most 1.
float fuzzUncharted4(float sheenRoughness, float NoV) {
  float edge = 1.0 - NoV;
  float rim = 0.7 * pow(edge, mix(8.0, 3.0, sheenRoughness));         // along the outline
  float outer = 0.3 * sheenRoughness * pow2(edge);                    // long fibres, far into the cloth
  float inner = 0.2 * sheenRoughness * pow(NoV, mix(6.0, 2.0, sheenRoughness));  // those that point at the viewer
  return rim + outer + inner;
}

// Velvet: an inverted Gaussian on a floor that keeps some light facing the viewer; [1/sr].
// alpha  (0, 1]      NoH  [0, 1]
// src: Ashikhmin & Premoze 2007, "Distribution-based BRDFs", normalised as in Guy & Agopian 2018, section 4.12.1
float D_Ashikhmin(float alpha, float NoH) {
  float a2 = pow2(alpha);
  float cos2 = pow2(NoH);
  float sin2 = max(1.0 - cos2, 0.0078125);
  float cotangent2 = cos2 / (sin2 * a2);
  return RECIPROCAL_PI / (1.0 + 4.0 * a2) * (1.0 + 4.0 * exp(-cotangent2) / pow2(sin2));
}

// Sheen of fibre volumes as a linearly transformed cosine, fitted in closed form.
// x: directional albedo R, y: aInverse, z: bInverse / sqrt(1 - NoV)
// sheenRoughness  [0.01, 1]      NoV  [0, 1]
// src: Zeltner, Burley & Chiang 2022, "Practical Multiple-Scattering Sheen Using Linearly Transformed Cosines"; fit of
//   MaterialX and OpenPBR; at roughness 0.1 it reads 0.53 where the table has 0.55
vec3 sheenFit(float sheenRoughness, float NoV) {
  float x = NoV;
  float y = clamp(sheenRoughness, 0.01, 1.0);
  float s = y * (0.0206607 + 1.58491 * y) / (0.0379424 + y * (1.32227 + y));
  float m = y * (-0.193854 + y * (-1.14885 + y * (1.7932 - 0.95943 * y * y))) / (0.046391 + y);
  float o = y * (0.000654023 + (-0.0207818 + 0.119681 * y) * y) / (1.26264 + y * (-1.92021 + y));
  float albedo = exp(-0.5 * pow2((x - m) / s)) / (s * sqrt(2.0 * PI)) + o;
  float aInverse = (2.58126 * x + 0.813703 * y) * y / (1.0 + 0.310327 * x * x + 2.60994 * x * y);
  float shear = (y - 1.0) * y * y * y / (0.0000254053 + 1.71228 * x - 1.71506 * x * y + 1.34174 * y * y);
  return vec3(saturate(albedo), aInverse, shear);
}

// The same with bInverse itself as z.
vec3 sheenLtc(float sheenRoughness, float NoV) {
  vec3 fit = sheenFit(sheenRoughness, NoV);
  return vec3(fit.x, fit.y, fit.z * sqrt(max(1.0 - NoV, 0.0)));
}

// Sheen lobe times NoL, per unit of sheen colour, [1/sr]. l in the frame whose z is n and whose x holds v.
// ltc  of sheenLtc()      l  unit
// src: Zeltner, Burley & Chiang 2022, eq. 4
float sheenLtcCosine(vec3 ltc, vec3 l) {
  float a = ltc.y;
  float b = ltc.z;
  vec3 w = vec3(a * l.x + b * l.z, a * l.y, l.z);
  float length2 = max(dot(w, w), 1.0e-12);
  return ltc.x * RECIPROCAL_PI * max(w.z, 0.0) * pow2(a) / pow2(length2);
}

// What of the sheen lobe depends on the viewer only: x = R a^2 / PI, and the squared length of the transformed direction
// as y + NoL (z (LoV - NoL NoV) + w NoL).
vec4 sheenView(vec3 fit, float NoV) {
  float a2 = pow2(fit.y);
  return vec4(fit.x * a2 * RECIPROCAL_PI, a2, 2.0 * fit.y * fit.z * inversesqrt(1.0 + NoV), pow2(fit.z) * (1.0 - NoV) + 1.0 - a2);
}

// The lobe of sheenLtcCosine() without a frame: no direction is lost where v is n.
// NoL  [0, 1]      LoV  [-1, 1]
float sheenCosine(vec4 view, float NoV, float NoL, float LoV) {
  float length2 = view.y + NoL * (view.z * (LoV - NoL * NoV) + view.w * NoL);
  return view.x * NoL / pow2(length2);
}
