// Thin film on a surface (KHR_materials_iridescence). Shared text: see README.md.
// src: Belcour & Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence"; order of
//      three r187. Thicknesses are nanometres.

// Index of refraction whose normal reflectance against air is f0, per channel; f0  [0, 1)
vec3 iorFromF0(vec3 f0) {
  vec3 root = sqrt(f0);
  return (1.0 + root) / (1.0 - root);
}

// Normal reflectance between two media, per channel.
vec3 f0FromIor(vec3 transmittedIor, float incidentIor) {
  vec3 ratio = (transmittedIor - incidentIor) / (transmittedIor + incidentIor);
  return ratio * ratio;
}

// Linear Rec.709 response to an optical path difference, nanometres, with a phase shift per channel, radians.
vec3 filmSensitivity(float pathDifference, vec3 shift) {
  float phase = 2.0 * PI * pathDifference * 1.0e-9;
  vec3 height = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13);
  vec3 centre = vec3(1.6810e6, 1.7953e6, 2.2084e6);
  vec3 width = vec3(4.3278e9, 9.3046e9, 6.6121e9);
  vec3 xyz = height * sqrt(2.0 * PI * width) * cos(centre * phase + shift) * exp(-pow2(phase) * width);
  xyz.x += 9.7470e-14 * sqrt(2.0 * PI * 4.5282e9) * cos(2.2399e6 * phase + shift.x) * exp(-4.5282e9 * pow2(phase));
  mat3 rec709FromXyz = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560, 1.0572252);
  return rec709FromXyz * (xyz / 1.0685e-7);
}

// Reflectance of a film between air and a base, linear Rec.709, >= 0.
// filmIor  [1, 3]      thickness  nanometres >= 0      cosTheta  [0, 1]      baseF0  linear Rec.709 [0, 1]
vec3 F_Iridescence(float filmIor, float thickness, float cosTheta, vec3 baseF0) {
  // A film of no thickness is no film.
  float t = saturate(thickness / 0.03);
  float ior = mix(1.0, filmIor, t * t * (3.0 - 2.0 * t));
  float cosTheta2Squared = 1.0 - pow2(1.0 / ior) * (1.0 - pow2(cosTheta));
  if (cosTheta2Squared < 0.0) {
    return vec3(1.0);
  }
  float cosTheta2 = sqrt(cosTheta2Squared);
  float r0 = pow2((ior - 1.0) / (ior + 1.0));
  float r12 = r0 * (1.0 - F_SchlickWeight(cosTheta)) + F_SchlickWeight(cosTheta);
  float t121 = 1.0 - r12;
  float phi21 = ior < 1.0 ? 0.0 : PI;
  vec3 baseIor = iorFromF0(clamp(baseF0, 0.0, 0.9999));
  vec3 r23 = F_Schlick(f0FromIor(baseIor, ior), 1.0, cosTheta2);
  vec3 phi = vec3(phi21 + (baseIor.x < ior ? PI : 0.0), phi21 + (baseIor.y < ior ? PI : 0.0), phi21 + (baseIor.z < ior ? PI : 0.0));
  float pathDifference = 2.0 * ior * thickness * cosTheta2;
  vec3 r123 = clamp(r12 * r23, 1.0e-5, 0.9999);
  vec3 rs = pow2(t121) * r23 / (1.0 - r123);
  vec3 amplitude = (rs - t121) * sqrt(r123);
  vec3 sum = r12 + rs + amplitude * (2.0 * filmSensitivity(pathDifference, phi));
  amplitude = amplitude * sqrt(r123);
  sum = sum + amplitude * (2.0 * filmSensitivity(2.0 * pathDifference, 2.0 * phi));
  return max(sum, 0.0);
}

// Normal reflectance that gives reflectance f at cosine VoH under Schlick's curve with f90 = 1.
vec3 f0FromSchlick(vec3 f, float VoH) {
  float x = saturate(1.0 - VoH);
  float x2 = x * x;
  float x5 = clamp(x * x2 * x2, 0.0, 0.9999);
  return (f - x5) / (1.0 - x5);
}
