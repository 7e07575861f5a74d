// Reading the prefiltered environment cube. Shared text: see README.md.

// Level of detail of the cube whose level k was filtered for perceptual roughness 1 - sqrt(1 - k / maxLod), [0, maxLod].
// perceptualRoughness  [0, 1]      maxLod  [1, 8]  the roughness 1 level
// src: three r187
float lodFromRoughness(float perceptualRoughness, float maxLod) {
  float r = saturate(perceptualRoughness);
  return maxLod * r * (2.0 - r);
}

// Unit direction in which the cube is read: the mirror direction, drawn to the normal as the lobe widens.
// perceptualRoughness  [0, 1]      n, v  unit, NoV > 0 or the mix may vanish at roughness^4 = 1/2
// src: three r187; after Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 22
vec3 dominantReflection(float perceptualRoughness, vec3 n, vec3 v) {
  return normalize(mix(reflect(-v, n), n, pow4(perceptualRoughness)));
}

// Roughness whose prefiltered lobe, that of a viewer along the normal, is as wide as the lobe of this roughness seen aslant: its mean
// direction is as long, within 0.03. A prefiltered lobe has the cosine of the light once more and is narrower, so even straight on it is
// read rougher. Aslant a lobe is narrower across; what a metal reflects is pulled towards its normal and stays wide.
// perceptualRoughness  [0, 1]      f0  [0, 1]      NoV  [0, 1]
float prefilteredRoughness(float perceptualRoughness, float f0, float NoV) {
  float r = perceptualRoughness;
  float slant = 1.0 - NoV;
  float narrower = max(0.14 + r * (1.04 - 1.38 * r), 0.0) * pow2(1.0 - f0) * pow2(slant) * (3.6 - 2.45 * slant);
  return min(r * (1.0 + 0.31 * r - narrower), 1.0);
}

// Specular part of the light from the environment, the unit of its arguments, linear Rec.709.
// radiance  prefiltered at the material's roughness      meanRadiance  irradiance / PI
// src: Fdez-Aguera 2019, JCGT 8(1), eq. 11; order of three r187
vec3 environmentSpecular(Scattering scattering, vec3 radiance, vec3 meanRadiance) {
  return radiance * scattering.single + scattering.multiple * meanRadiance;
}
