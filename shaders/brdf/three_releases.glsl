// What releases of three.js before 0.187 shaded otherwise: js/docs/families.md says which, and how it was measured. Shared text:
// see README.md.

// Smallest perceptual roughness that was shaded before 0.187.
const float PERCEPTUAL_ROUGHNESS_MIN_R186 = 0.0525;

// Unit direction in which the prefiltered environment is read, drawn to the normal by alpha.
// perceptualRoughness  [0, 1]      n, v  unit
// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 22; three r150 to r180
vec3 dominantReflectionByAlpha(float perceptualRoughness, vec3 n, vec3 v) {
  vec3 mirrored = reflect(-v, n);
  return normalize(mix(mirrored, n, pow2(perceptualRoughness)));
}

// A lobe for light that bounces more than once, without a direction of its own, [1], linear Rec.709: it stands beside the GGX
// lobe. Not the integral of what is missing, which would be 20 times that for a rough white metal.
// f0  [0, 1], of the whole material      f90  [0, 1]      dfgV, dfgL  (A, B) of the split sum towards viewer and light
// passes  [0, 1], factor on the light of a bounce between the two
// src: three r181 to r185; after Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models"
vec3 addedScattering(vec3 f0, float f90, vec2 dfgV, vec2 dfgL, vec3 passes) {
  float missing = (1.0 - dfgV.x - dfgV.y) * (1.0 - dfgL.x - dfgL.y);
  vec3 towardsViewer = f0 * dfgV.x + f90 * dfgV.y;
  vec3 towardsLight = f0 * dfgL.x + f90 * dfgL.y;
  vec3 bounces = F_SchlickAverage(f0) / (1.0 + 1.0e-6 - missing * passes);
  return towardsViewer * towardsLight * (missing * bounces);
}

// Largest channel of what the interface sends back, which no channel of the diffuse lobe gets; the share that it leaves.
// src: three r150 to r181
vec3 diffuseShareOfLargest(Scattering whole) {
  return vec3(1.0 - max3(whole.single + whole.multiple));
}

// Directional albedo of the sheen lobe, by one curve below a roughness of 0.25 and another above, [0, 1].
// sheenRoughness  perceptual, (0, 1]      cosine  [0, 1]
// src: fit of three r150 to r181 to Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF"
float sheenAlbedoInRanges(float sheenRoughness, float cosine) {
  float r = sheenRoughness;
  vec3 powers = vec3(r * r, r, 1.0);
  float slope = dot(vec3(-339.2, 161.4, -25.9), powers);
  float height = dot(vec3(44.0, -23.7, 3.26), powers);
  float lift = 0.0;
  if (r >= 0.25) {
    slope = dot(vec3(-8.48, 14.3, -9.95), powers);
    height = dot(vec3(1.97, -3.27, 0.72), powers);
    lift = 0.1 * (r - 0.25);
  }
  return saturate(RECIPROCAL_PI * (exp(slope * cosine + height) + lift));
}

// Share of all light of the base that sheen leaves, whatever the directions, [0.843, 1].
// sheenColor  linear Rec.709 [0, 1]
// src: three r150 to r181; after Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks"
float underSheenOfColor(vec3 sheenColor) {
  return 1.0 - 0.157 * max3(sheenColor);
}

// Albedo of an area light's GGX lobe whose reflectance at grazing is 1 whatever the material says, linear Rec.709.
// scaleAndBias  as ltcAlbedo
// src: three r150 to r182
vec3 ltcAlbedoToWhite(vec3 f0, vec2 scaleAndBias) {
  return f0 * scaleAndBias.x + (1.0 - f0) * scaleAndBias.y;
}

// Factor on the opacity of glass: the coverage of what lies behind, weighed, and a tenth.
// coverage  [0, 1]      transmission  [0, 1], weight of the glass
// src: three r150 to r152
float glassOpacityWithTenth(float coverage, float transmission) {
  return mix(1.0, coverage, transmission) + 0.1;
}
