// What a relief does that is finer than a pixel: the normals of a normal map that the sampler has averaged. Shared text: see
// README.md. A texel alone is lit as bump.glsl says: its normal turned to where it just faces the viewer, its terminator. The
// means over reliefs of cloth depend on little but the length of the mean normal, and on their lines where they run along some. The numbers are those of knits, weaves, pile and
// grain; `node test/fits/relief.mjs` fits diffuse light of one direction and the gloss.
// relief  1 - length of the mean normal, [0, 1)
// src: Toksvig 2005, "Mipmapping Normal Maps", for that length; Han et al. 2007, "Frequency Domain Normal Map Filtering", for
//      lobes over a distribution of normals

// What a relief is in the plane of n and a direction. Cords and ribs run along lines: they lean across them, and hardly along.
// axis  across the lines; as long as (X - Y) / (X + Y), of the mean squares of the normals' components across them and along them, [0, 1]:
//       0 = they lean alike all around      n  unit      d  any length      return  [0, 0.95]
float reliefTowards(float relief, vec3 axis, vec3 n, vec3 d) {
  float stretch = min(length(axis), 1.0);
  vec3 tangent = d - n * dot(n, d);
  float along = pow2(dot(axis, tangent)) / max(dot(tangent, tangent) * stretch, 1.0e-6);  // stretch times the squared cosine
  return clamp(relief * (1.0 - stretch + 2.0 * along), 0.0, 0.95);
}

// Share that diffuse light keeps of light of one direction: of grazing light, texels that lean towards it take more. Of light from
// everywhere: bumpMean().   towards  reliefTowards() of the light      NoL  [0, 1]
float reliefDiffuseTowards(float relief, float towards, float NoL) {
  float leaning = 0.8 * saturate(20.0 * towards) * exp(-NoL / (0.03 + 0.6 * towards));
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
// relief  reliefTowards() of the viewer      NoV  [0, 1]
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
// quadrature of the azimuth a third of them leans aside, whose cosine is NoV (1 - relief).
// towards  reliefTowards() of the viewer      NoV  [0, 1]
LeaningCosines leaningCosines(float relief, float towards, float NoV) {
  float sine = 0.8660254 * sqrt(max(1.0 - pow2(NoV), 0.0));
  vec2 upright = max(1.0 - vec2(0.4, 1.6) * relief, 0.0);
  vec2 along = upright * NoV;
  vec2 across = sqrt(max(1.0 - upright * upright, 0.0) * (towards / max(relief, 1.0e-6))) * sine;
  return LeaningCosines(min(along + across, 1.0), max(along - across, 0.0), NoV * (1.0 - relief));
}

// glossGrazing(), the mean over these normals: those that lean away reflect much more. Within 0.006 rms.
float reliefGrazing(float relief, vec4 curve, float NoV) {
  LeaningCosines cosines = leaningCosines(relief, relief, NoV);
  float sum = glossGrazing(curve, cosines.towards.x) + glossGrazing(curve, cosines.towards.y) + glossGrazing(curve, cosines.away.x) +
              glossGrazing(curve, cosines.away.y) + 2.0 * glossGrazing(curve, cosines.aside);
  return sum * (1.0 / 6.0);
}

// Albedo of the sheen, the mean over these normals.
// towards  reliefTowards() of the viewer      sheenRoughness  [0.01, 1]      NoV  [0, 1]
float reliefSheenAlbedo(float relief, float towards, float sheenRoughness, float NoV) {
  LeaningCosines cosines = leaningCosines(relief, towards, NoV);
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

// The sheen where a normal leans from n.
// leaning  square to n, as long as the sine of the angle; from 1 on the normal is square to n      sheenRoughness  [0.01, 1]      n, v  unit
SheenNormal sheenNormal(vec3 leaning, float sheenRoughness, vec3 n, vec3 v) {
  vec3 m = normalize(leaning + n * sqrt(max(1.0 - dot(leaning, leaning), 0.0)));
  float cosine = dot(m, v);
  SheenNormal normal;
  normal.n = safeNormalize(m - v * min(cosine, 0.0), n);
  normal.NoV = saturate(cosine);
  normal.view = sheenView(sheenFit(sheenRoughness, normal.NoV), normal.NoV);
  return normal;
}

// The sheen as the mean over six normals that lean by one angle about their mean; where there are lines, by more across them than
// along. They begin at 15 degrees from the axis: so they are spread as evenly across lines as all around.
// axis  of reliefTowards()      sheenRoughness  [0.01, 1]      n, v  unit
SheenRing sheenRing(float relief, vec3 axis, float sheenRoughness, vec3 n, vec3 v) {
  float sine2 = 1.0 - pow2(1.0 - relief);
  float stretch = min(length(axis), 1.0);
  vec3 x = safeNormalize(axis - n * dot(n, axis), anyTangent(n));
  vec3 y = cross(n, x) * sqrt(sine2 * (1.0 - stretch));
  x *= sqrt(sine2 * (1.0 + stretch));
  vec3 first = x * 0.9659258 + y * 0.2588190;
  vec3 second = x * 0.2588190 + y * 0.9659258;
  vec3 third = (y - x) * 0.7071068;
  SheenRing ring;
  ring.first = sheenNormal(first, sheenRoughness, n, v);
  ring.againstFirst = sheenNormal(-first, sheenRoughness, n, v);
  ring.second = sheenNormal(second, sheenRoughness, n, v);
  ring.againstSecond = sheenNormal(-second, sheenRoughness, n, v);
  ring.third = sheenNormal(third, sheenRoughness, n, v);
  ring.againstThird = sheenNormal(-third, sheenRoughness, n, v);
  ring.alpha2 = saturate(0.125 * (1.0 / max(1.0 - sine2, 1.0e-4) - 1.0));
  return ring;
}

// Its lobe times the cosine, [1/sr].   l  unit      LoV  [-1, 1]
float sheenNormalCosine(SheenNormal normal, vec3 l, float LoV) {
  return sheenCosine(normal.view, normal.NoV, saturate(dot(normal.n, l)), LoV);
}

// The same of all.   NoL  [0, 1], with the mean normal
float sheenRingCosine(SheenRing ring, vec3 l, float NoL, float LoV) {
  float sum = sheenNormalCosine(ring.first, l, LoV) + sheenNormalCosine(ring.againstFirst, l, LoV) +
              sheenNormalCosine(ring.second, l, LoV) + sheenNormalCosine(ring.againstSecond, l, LoV) +
              sheenNormalCosine(ring.third, l, LoV) + sheenNormalCosine(ring.againstThird, l, LoV);
  return sum * (1.0 / 6.0) * bumpTerminator(ring.alpha2, NoL);
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
