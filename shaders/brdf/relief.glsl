// What a relief does that is finer than a pixel: the normals of a normal map that the sampler has averaged. Shared text: see
// README.md. A texel alone is lit as bump.glsl says: its normal turned to where it just faces the viewer, its terminator. The
// means over reliefs of cloth depend on little but the length of the mean normal. The numbers are those of knits, weaves, pile and
// grain; `node test/fits/relief.mjs` fits diffuse light of one direction and the gloss.
// relief  1 - length of the mean normal, [0, 1)
// src: Toksvig 2005, "Mipmapping Normal Maps", for that length; Han et al. 2007, "Frequency Domain Normal Map Filtering", for
//      lobes over a distribution of normals

// Share that diffuse light keeps of light of one direction: of grazing light, texels that lean towards it take more. Of light from
// everywhere: bumpMean().   NoL  [0, 1]
float reliefDiffuseTowards(float relief, float NoL) {
  float leaning = 0.8 * saturate(20.0 * relief) * exp(-NoL / (0.03 + 0.6 * relief));
  return (1.0 - relief) * (1.0 + leaning);
}

// Mean cosine of light on the other side, where normals lean to it and away. Within 0.03 of reliefs up to 0.5; over all directions up to
// 1.02 times the light there.   cosine  [-1, 1], with the mean normal
float reliefBehind(float relief, float cosine) {
  float mean = cosine * (1.0 - relief);
  return 0.5 * (sqrt(pow2(mean) + 0.5 * relief * max(1.0 - pow2(cosine), 0.0)) - mean);
}

// Mean direction of diffuse light: normals that face away from the viewer are turned to him. Within 1 degree.
// bent  unit, of bumpBent()      n, v  unit      NoV  [0, 1]      return  unit
vec3 reliefBent(float relief, vec3 bent, vec3 n, vec3 v, float NoV) {
  return safeNormalize(bent + (v - n * NoV) * (relief * pow2(1.0 - NoV)), bent);
}

// By how much more diffuse light there is of them, as they lean less. Within 0.01.
// NoV  [0, 1]
float reliefTurned(float relief, float NoV) {
  float slant = 1.0 - NoV;
  return 1.0 + 1.05 * pow2(relief) * slant * sqrt(slant);
}

// Shares that the gloss keeps of light from everywhere, of its parts of f0 (x) and of f90 (y).
// perceptualRoughness  (0, 1], of a texel      NoV  [0, 1]
vec2 reliefGloss(float relief, float perceptualRoughness, float NoV) {
  float r = perceptualRoughness;
  float head = -0.696 + r * (1.915 * r - 0.14);
  float middle = 13.6 + r * (5.675 * r - 22.311);
  float side = -11.779 + r * (25.081 - 10.92 * r);
  float lost = clamp(head + NoV * (middle + NoV * side), 0.0, 2.0);
  float seen = max(1.0 - max(NoV - 0.35, 0.0) / (0.07 + 3.2 * relief), 0.0);  // from above, texels that lean away make up for what others lose
  return vec2(exp(-1.25 * relief * lost), max(1.0 - sqrt(relief) * (1.8 - 1.62 * r) * seen, 0.0));
}

// Cosines of the viewer with normals that lean by two angles about their mean, towards the viewer and away, [0, 1]; by Gauss's
// quadrature of the azimuth a third of them leans aside, whose cosine is NoV (1 - relief).   NoV  [0, 1]
LeaningCosines leaningCosines(float relief, float NoV) {
  float sine = 0.8660254 * sqrt(max(1.0 - pow2(NoV), 0.0));
  vec2 upright = max(1.0 - vec2(0.4, 1.6) * relief, 0.0);
  vec2 along = upright * NoV;
  vec2 across = sqrt(max(1.0 - upright * upright, 0.0)) * sine;
  return LeaningCosines(min(along + across, 1.0), max(along - across, 0.0), NoV * (1.0 - relief));
}

// glossGrazing(), the mean over these normals: those that lean away reflect much more. Within 0.006 rms.
float reliefGrazing(float relief, vec4 curve, float NoV) {
  LeaningCosines cosines = leaningCosines(relief, NoV);
  float sum = glossGrazing(curve, cosines.towards.x) + glossGrazing(curve, cosines.towards.y) + glossGrazing(curve, cosines.away.x) +
              glossGrazing(curve, cosines.away.y) + 2.0 * glossGrazing(curve, cosines.aside);
  return sum * (1.0 / 6.0);
}

// Albedo of the sheen, the mean over these normals.   sheenRoughness  [0.01, 1]      NoV  [0, 1]
float reliefSheenAlbedo(float relief, float sheenRoughness, float NoV) {
  LeaningCosines cosines = leaningCosines(relief, NoV);
  float sum = sheenFit(sheenRoughness, cosines.towards.x).x + sheenFit(sheenRoughness, cosines.towards.y).x +
              sheenFit(sheenRoughness, cosines.away.x).x + sheenFit(sheenRoughness, cosines.away.y).x +
              2.0 * sheenFit(sheenRoughness, cosines.aside).x;
  return sum * (1.0 / 6.0);
}

// Share that the sheen keeps of light from everywhere.   sheenRoughness  [0, 1]
float reliefSheen(float relief, float sheenRoughness) {
  float power = -0.14 + sheenRoughness * (1.44 - 0.46 * sheenRoughness);
  return relief > 0.0 ? 1.0 - 0.67 * pow(relief, max(power, 0.1)) : 1.0;
}

// The sheen as the mean over six normals that lean by one angle about their mean.
// sheenRoughness  [0.01, 1]      n, v  unit      NoV  [0, 1]
SheenRing sheenRing(float relief, float sheenRoughness, vec3 n, vec3 v, float NoV) {
  SheenRing ring;
  ring.upright = 1.0 - relief;
  float leaning = sqrt(max(1.0 - pow2(ring.upright), 0.0));
  ring.towards = safeNormalize(v - n * NoV, anyTangent(n)) * leaning;
  ring.aside = cross(n, ring.towards);
  float tilt = 0.8660254 * dot(ring.towards, v);
  float along = NoV * ring.upright;
  ring.NoV = saturate(vec3(along + tilt, along, along - tilt));
  vec3 towards = sheenFit(sheenRoughness, ring.NoV.x);
  vec3 aside = sheenFit(sheenRoughness, ring.NoV.y);
  vec3 away = sheenFit(sheenRoughness, ring.NoV.z);
  ring.viewTowards = sheenView(towards, ring.NoV.x);
  ring.viewAside = sheenView(aside, ring.NoV.y);
  ring.viewAway = sheenView(away, ring.NoV.z);
  ring.albedo = reliefSheenAlbedo(relief, sheenRoughness, NoV);
  ring.scale = 0.5 * ring.albedo / max(towards.x + aside.x + away.x, 1.0e-6);
  return ring;
}

// Its lobe times the cosine, [1/sr].   l  unit      NoL  [0, 1], with the mean normal      LoV  [-1, 1]
float sheenRingCosine(SheenRing ring, vec3 l, float NoL, float LoV) {
  float upright = NoL * ring.upright;
  float towards = 0.8660254 * dot(ring.towards, l);
  float aside = dot(ring.aside, l);
  float sum = sheenCosine(ring.viewTowards, ring.NoV.x, saturate(upright + towards + 0.5 * aside), LoV) +
              sheenCosine(ring.viewTowards, ring.NoV.x, saturate(upright + towards - 0.5 * aside), LoV) +
              sheenCosine(ring.viewAside, ring.NoV.y, saturate(upright + aside), LoV) +
              sheenCosine(ring.viewAside, ring.NoV.y, saturate(upright - aside), LoV) +
              sheenCosine(ring.viewAway, ring.NoV.z, saturate(upright - towards + 0.5 * aside), LoV) +
              sheenCosine(ring.viewAway, ring.NoV.z, saturate(upright - towards - 0.5 * aside), LoV);
  float alpha2 = saturate(0.125 * (1.0 / max(pow2(ring.upright), 1.0e-4) - 1.0));
  return sum * ring.scale * bumpTerminator(alpha2, NoL);
}

// Lobes by which sheen reads a prefiltered environment. Their sum has the mean direction of the sheen's light, which is fitted.
// n, v  unit      NoV  [0, 1]
SheenTaps sheenTaps(float relief, float sheenRoughness, vec3 n, vec3 v, float NoV) {
  float r = sheenRoughness;
  float grazing = 1.0 - NoV;
  float rough = min(1.08 * (1.0 - exp(-9.0 * relief)), 1.0);
  float up = mix(0.68 * r - 0.03 + 0.37 * (1.0 - r) * NoV, 0.24 + 0.4 * r + (0.47 - 0.48 * r) * NoV, rough);
  float bent = grazing * (0.12 + 2.95 * pow2(1.0 - r) * (1.0 - r) * NoV);
  float along = mix(0.12 * pow2(grazing), bent, sqrt(rough));
  vec3 x = safeNormalize(v - n * NoV, anyTangent(n));
  SheenTaps taps;
  taps.aside = 0.0;
  taps.roughness = 1.0;
  taps.front = taps.left = taps.right = safeNormalize(n * up + x * along, n);
  if (r > 0.6) return taps;  // it is about as wide as one cosine lobe
  float size = 0.667 + 0.4 * max(0.667 - up, 0.0);
  float cosine = clamp(up / size, 0.0, 1.0);
  float sine = sqrt(1.0 - pow2(cosine));
  taps.aside = saturate(1.0 - along / max(size * sine, 1.0e-3)) / 2.52;
  taps.roughness = 1.0 - 3.4 * (size - 0.667);
  taps.front = n * cosine + x * sine;
  vec3 back = n * cosine - x * (0.26 * sine);
  vec3 across = cross(n, x) * (0.9656 * sine);
  taps.left = back + across;
  taps.right = back - across;
  return taps;
}
