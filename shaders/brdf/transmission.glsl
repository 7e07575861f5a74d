// Light that passes through a surface. Shared text: see README.md.

// Unit direction in which light goes on behind the surface, or straight on where all of it is reflected.
// n  facing v      v  unit, to the viewer      ior  [1, 1000]
// src: Snell's law; order of three r187
vec3 refractedDirection(vec3 n, vec3 v, float ior) {
  return safeNormalize(refract(-v, normalize(n), 1.0 / ior), -v);
}

// Indices of refraction for red, green and blue light.
// ior  [1, 1000], of green      dispersion  [0, 40], 20 / Abbe number
// src: KHR_materials_dispersion; order of three r187
vec3 dispersedIor(float ior, float dispersion) {
  float halfSpread = (ior - 1.0) * 0.025 * dispersion;
  return vec3(ior - halfSpread, ior, ior + halfSpread);
}

// Share of the light that is left after a path through the volume, linear Rec.709, [0, 1].
// pathLength, attenuationDistance  [m], the latter > 0      attenuationColor  [0, 1], left after attenuationDistance
// src: Beer-Lambert; order of three r187, which gives NaN for black over a path of 0
vec3 volumeTransmittance(float pathLength, vec3 attenuationColor, float attenuationDistance) {
  vec3 attenuation = -log(attenuationColor) / attenuationDistance;
  return pathLength > 0.0 ? exp(-attenuation * min(pathLength, PATH_LENGTH_MAX)) : vec3(1.0);
}

// Level of detail at which the picture of what lies behind is read: blurred as a rough surface refracts, not at ior 1.
// perceptualRoughness  [0, 1]      ior  [1, 1000]      maxLod  [0, 13]  log2 of the picture's width in pixels
// src: glTF-Sample-Viewer; order of three r187
float transmissionLod(float perceptualRoughness, float ior, float maxLod) {
  return maxLod * (perceptualRoughness * clamp(ior * 2.0 - 2.0, 0.0, 1.0));
}

// Opacity of the surface: where little light comes through, what lies behind the picture does not either.
// transmittance  [0, 1]      alpha  [0, 1]  of what lies behind
// src: three r187
float transmittedAlpha(vec3 transmittance, float alpha) {
  float mean = (transmittance.x + transmittance.y + transmittance.z) / 3.0;
  return 1.0 - (1.0 - alpha) * mean;
}

// A cubic B-spline along one axis as two bilinear reads.
// x  [0, 1]  place between the two middle ones of four texels
// src: Sigg & Hadwiger 2005, "Fast Third-Order Texture Filtering", GPU Gems 2, ch. 20; order of three r187
BicubicTaps bicubicTaps(float x) {
  float w0 = (1.0 / 6.0) * (x * (x * (-x + 3.0) - 3.0) + 1.0);
  float w1 = (1.0 / 6.0) * (x * x * (3.0 * x - 6.0) + 4.0);
  float w2 = (1.0 / 6.0) * (x * (x * (-3.0 * x + 3.0) + 3.0) + 1.0);
  float w3 = (1.0 / 6.0) * (x * x * x);
  return BicubicTaps(w0 + w1, w2 + w3, -1.0 + w1 / (w0 + w1), 1.0 + w3 / (w2 + w3));
}
