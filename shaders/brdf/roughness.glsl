// Roughness from the authored value to alpha. Shared text: see README.md.

// Roughness that the curvature of the surface adds within one pixel, perceptual units, >= 0.
// dndx, dndy  screen-space derivatives per pixel of the unit interpolated normal, before any normal map
// src: three r187; after Tokuyoshi & Kaplanyan 2019, "Improved Geometric Specular Antialiasing", in a one-line form
float geometricRoughness(vec3 dndx, vec3 dndy) {
  return max3(max(abs(dndx), abs(dndy)));
}

// Perceptual roughness to shade with, [PERCEPTUAL_ROUGHNESS_MIN, 1].
// perceptualRoughness  [0, 1]  factor x texture      geometric  [0, inf)  geometricRoughness()
// src: three r187
float shadedRoughness(float perceptualRoughness, float geometric) {
  return min(max(perceptualRoughness, PERCEPTUAL_ROUGHNESS_MIN) + geometric, 1.0);
}

// GGX width of a surface whose normals vary within what is seen of it at once, (0, 1].
// alpha  (0, 1]      slopeVariance  [0, inf)  of the slopes along two axes that are square, their sum
// src: Olano & Baker 2010, "LEAN Mapping": variances of slopes add; alpha^2 is twice the variance of one axis
float widthWithSlopes(float alpha, float slopeVariance) { return sqrt(min(pow2(alpha) + slopeVariance, 1.0)); }

// The same of a perceptual roughness, [0, 1].
float roughnessWithSlopes(float perceptualRoughness, float slopeVariance) {
  return sqrt(widthWithSlopes(pow2(perceptualRoughness), slopeVariance));
}

// GGX width, [PERCEPTUAL_ROUGHNESS_MIN^2, 1].
// perceptualRoughness  [0, 1]
// src: Burley 2012, "Physically-Based Shading at Disney", section 5.4
float alphaFromRoughness(float perceptualRoughness) {
  return pow2(max(perceptualRoughness, PERCEPTUAL_ROUGHNESS_MIN));
}
