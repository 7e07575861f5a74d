// Tone curves: scene light to display light, both linear Rec.709. Shared text: see README.md.
// color  linear Rec.709, scene radiance; negative where a film takes light away      exposure  [0, inf), factor
// return [0, 1] (neutral: below 1), before the sRGB OETF

// Scene light after exposure. The cap keeps inf out of the quotients below and is white for each of them.
vec3 exposedColor(vec3 color, float exposure) {
  return min(color * exposure, RADIANCE_MAX);
}

// Exposure alone.
vec3 toneMapLinear(vec3 color, float exposure) {
  return saturate(exposedColor(color, exposure));
}

// src: Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 3, per channel
vec3 toneMapReinhard(vec3 color, float exposure) {
  vec3 x = exposedColor(color, exposure);
  return saturate(x / (1.0 + x));
}

// Fit of a film print that holds the sRGB curve; the power of 2.2 takes that out again.
// src: Hejl & Burgess-Dawson 2010, in Duiker, "Filmic Tonemapping for Real-time Rendering", SIGGRAPH course
vec3 toneMapCineon(vec3 color, float exposure) {
  vec3 x = max(exposedColor(color, exposure) - 0.004, 0.0);
  return pow((x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06), vec3(2.2));
}

// Rational fit of the ACES reference rendering and output transforms.
// src: Hill 2016, BakingLab ACES.hlsl, a / b form
vec3 acesCurve(vec3 x) {
  vec3 a = x * (x + 0.0245786) - 0.000090537;
  vec3 b = x * (0.983729 * x + 0.4329510) + 0.238081;
  return a / b;
}

// Matrices are written column by column. The 1/0.6 brightens for a surround that is not a cinema.
// src: Hill 2016, BakingLab ACES.hlsl; exposure of three r187
vec3 toneMapAces(vec3 color, float exposure) {
  mat3 inputMatrix = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  mat3 outputMatrix = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 x = inputMatrix * exposedColor(color, exposure / 0.6);
  return saturate(outputMatrix * acesCurve(x));
}

// Sixth-degree fit of AgX's default contrast, log-encoded [0, 1] to display-encoded.
// src: Wrensch 2023, "Minimal AgX Implementation"
vec3 agxCurve(vec3 x) {
  vec3 x2 = x * x;
  vec3 x4 = x2 * x2;
  return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

// Linear Rec.709 to log2-encoded AgX, [0, 1] over -12.47393 .. 4.026069 stops; through Rec.2020 primaries.
// src: Sobotka 2022, "AgX"; Rec.2020 form and matrices of three r187
vec3 agxEncode(vec3 color) {
  mat3 rec2020FromRec709 = mat3(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113, 0.8956);
  mat3 inset = mat3(0.856627153315983, 0.137318972929847, 0.11189821299995, 0.0951212405381588, 0.761241990602591,
                    0.0767994186031903, 0.0482516061458583, 0.101439036467562, 0.811302368396859);
  float minEv = -12.47393;
  float maxEv = 4.026069;
  vec3 x = log2(max(inset * (rec2020FromRec709 * color), 1.0e-10));
  return saturate((x - minEv) / (maxEv - minEv));
}

// Display-encoded AgX to linear Rec.709, [0, 1].
// src: Sobotka 2022, "AgX"; Rec.2020 form and matrices of three r187
vec3 agxDecode(vec3 x) {
  mat3 outset = mat3(1.1271005818144368, -0.1413297634984383, -0.14132976349843826, -0.11060664309660323,
                     1.157823702216272, -0.11060664309660294, -0.016493938717834573, -0.016493938717834257,
                     1.2519364065950405);
  mat3 rec709FromRec2020 = mat3(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
  vec3 linear = pow(max(outset * x, 0.0), vec3(2.2));
  return saturate(rec709FromRec2020 * linear);
}

// src: Sobotka 2022, "AgX", default look; order of three r187
vec3 toneMapAgx(vec3 color, float exposure) {
  return agxDecode(agxCurve(agxEncode(exposedColor(color, exposure))));
}

// Keeps hue and saturation of base colours up to 0.76 and rolls off above; takes 0.04 off (the specular of a dielectric).
// src: Khronos 2024, "PBR Neutral Tone Mapper Specification"; order of three r187
vec3 toneMapNeutral(vec3 color, float exposure) {
  float startCompression = 0.8 - 0.04;
  float desaturation = 0.15;
  vec3 x = exposedColor(color, exposure);
  float low = min3(x);
  float offset = low < 0.08 ? low - 6.25 * low * low : 0.04;
  x = x - offset;
  float peak = max3(x);
  if (peak < startCompression) {
    return x;
  }
  float d = 1.0 - startCompression;
  float newPeak = 1.0 - d * d / (peak + d - startCompression);
  x = x * (newPeak / peak);
  float g = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return mix(x, vec3(newPeak), g);
}
