// Light of the environment by importance sampling of the BSDF. A direction is drawn from a mixture of the lobes, and the
// environment is read from the mip level that covers the solid angle of the sample, so the result has no noise. Each direction
// is shaded by all lobes. View space.
// src: Krivanek & Colbert 2008, "Real-time Shading with Filtered Importance Sampling"; Veach 1997, "Robust Monte Carlo Methods
//      for Light Transport Simulation", section 9.2: the balance heuristic among the lobes, the power heuristic between the
//      lobes and the bright part
uniform samplerCube environmentSource;     // RGB radiance, A luminance of its bright part; a texel of a level is the mean of
                                           // those of the level before
uniform float environmentSourceSize;       // texels on an edge of level 0
uniform samplerCube environmentIrradianceMap;  // by the direction that a surface faces: irradiance of it all / PI
uniform mat3 viewToEnvironment;
uniform int environmentPass;               // index of the pass over the picture; each has directions of its own
uniform int environmentPasses;
// Directions drawn from the bright part of the map, in proportion to its luminance (renderer/ibl/bright_directions.h).
uniform int brightCount;                             // of this pass, up to BRIGHT_DIRECTIONS
uniform vec3 brightDirection[BRIGHT_DIRECTIONS];     // view space
uniform vec4 brightIrradiance[BRIGHT_DIRECTIONS];    // A = their density there over all passes, per steradian
uniform float brightDensity;                         // that density where the luminance is 1

// A light of this density or more is taken out of the map, and so it is not in the map's irradiance.
const float COMPACT_DENSITY = 1.0e29;

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);  // of linear Rec.709

// Smallest share of the samples that a lobe gets: its share is estimated, and the estimate may be too low.
const float MIN_SHARE = 0.25;

// A GGX lobe.
struct MicrofacetLobe {
  mat3 frame;  // columns x, y, normal
  vec3 v;      // to the viewer, in the frame
  vec2 alpha;
};

// The lobes of a surface, each with its share of the samples. The shares sum to 1.
struct LobeMixture {
  mat3 cosineFrame;
  float cosineShare;
  MicrofacetLobe base;     // of a weave, its warp
  float baseShare;
#if WEAVE
  MicrofacetLobe weft;
  float weftShare;
#endif
  float transmissionShare;  // of a cosine lobe on the other side
#if SHEEN
  float sheenShare;
#if SHADING_FABRIC
  mat3 sheenFrame;    // x holds the viewer
  vec3 sheenLtc;
#endif
#endif
#if CLEARCOAT
  MicrofacetLobe coat;
  float coatShare;
#endif
};

// t  the x axis of alpha; need not be orthogonal to n
MicrofacetLobe microfacetLobe(vec3 n, vec3 t, vec2 alpha, vec3 v) {
  MicrofacetLobe lobe;
  vec3 across = t - n * dot(n, t);
  vec3 x = dot(across, across) > SQUARED_LENGTH_EPSILON ? normalize(across) : basisAbout(n)[0];
  lobe.frame = mat3(x, cross(n, x), n);
  lobe.v = v * lobe.frame;
  lobe.v.z = max(lobe.v.z, 1.0e-4);
  lobe.alpha = alpha;
  return lobe;
}

LobeMixture lobeMixture(SurfaceInfo s) {
  LobeMixture lobes;
  lobes.cosineFrame = basisAbout(s.n);
#if WEAVE
  lobes.base = microfacetLobe(s.warp.n, s.warp.t, vec2(s.warp.alphaT, s.warp.alphaB), s.v);
  lobes.weft = microfacetLobe(s.weft.n, s.weft.t, vec2(s.weft.alphaT, s.weft.alphaB), s.v);
#elif ANISOTROPY
  lobes.base = microfacetLobe(s.n, s.t, vec2(max(s.alphaT, s.alpha), s.alpha), s.v);
#else
  lobes.base = microfacetLobe(s.n, lobes.cosineFrame[0], vec2(s.alpha), s.v);
#endif
  float diffuse = max3(s.diffuse);
#if SHEEN
  float sheen = max3(s.sheenColor);
  lobes.sheenShare = sheen / (sheen + diffuse + 1.0e-4);
  diffuse += sheen;
#if SHADING_FABRIC
  lobes.sheenFrame = microfacetLobe(s.n, s.v, vec2(1.0), s.v).frame;
  lobes.sheenLtc = sheenLtc(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
#endif
#endif
  lobes.transmissionShare = 0.0;
#if DIFFUSE_TRANSMISSION
  lobes.transmissionShare = s.diffuseTransmission * (1.0 - 2.0 * MIN_SHARE);
#endif
  float specular = max3(F_Schlick(s.f0, s.f90, s.NoV));
  lobes.baseShare = clamp(specular / (specular + diffuse + 1.0e-4), MIN_SHARE, 1.0 - MIN_SHARE) * (1.0 - lobes.transmissionShare);
#if CLEARCOAT
  lobes.coat = microfacetLobe(s.coatNormal, basisAbout(s.coatNormal)[0], vec2(alphaFromRoughness(s.clearcoatRoughness)), s.v);
  lobes.coatShare = s.clearcoat * MIN_SHARE;
  lobes.baseShare *= 1.0 - lobes.coatShare;
  lobes.transmissionShare *= 1.0 - lobes.coatShare;
#endif
#if SHEEN
  float left = 1.0 - lobes.baseShare - lobes.transmissionShare;
#if CLEARCOAT
  left -= lobes.coatShare;
#endif
  lobes.sheenShare *= left;
#endif
  lobes.cosineShare = 1.0 - lobes.baseShare;
#if CLEARCOAT
  lobes.cosineShare -= lobes.coatShare;
#endif
  lobes.cosineShare -= lobes.transmissionShare;
#if SHEEN
  lobes.cosineShare -= lobes.sheenShare;
#endif
#if WEAVE
  lobes.weftShare = lobes.baseShare * s.weft.coverage / (s.warp.coverage + s.weft.coverage);
  lobes.baseShare -= lobes.weftShare;
#endif
  return lobes;
}

vec3 sampleLobe(MicrofacetLobe lobe, vec2 u) {
  return lobe.frame * sampleReflection(lobe.v, lobe.alpha, u);
}

float pdfLobe(MicrofacetLobe lobe, vec3 l) {
  return pdfReflection(lobe.v, l * lobe.frame, lobe.alpha);
}

// A lobe of the base. A yarn that leans reflects below the surface too; the shading mirrors that light back, and so do the
// samples.
vec3 sampleBase(LobeMixture lobes, MicrofacetLobe lobe, vec2 u) {
  vec3 l = sampleLobe(lobe, u);
#if WEAVE_MAP
  vec3 n = lobes.cosineFrame[2];
  l -= (2.0 * min(dot(n, l), 0.0)) * n;
#endif
  return l;
}

float pdfBase(LobeMixture lobes, MicrofacetLobe lobe, vec3 l) {
  float pdf = pdfLobe(lobe, l);
#if WEAVE_MAP
  vec3 n = lobes.cosineFrame[2];
  float cosine = dot(n, l);
  pdf += pdfLobe(lobe, l - (2.0 * cosine) * n);
  if (cosine < 0.0) pdf = 0.0;
#endif
  return pdf;
}

#if SHEEN
// Sheen is brightest at grazing angles. The fabric's sheen has a lobe that can be sampled; for the others, directions are uniform.
vec3 sampleSheen(LobeMixture lobes, vec2 u) {
#if SHADING_FABRIC
  return lobes.sheenFrame * sampleSheenLtc(lobes.sheenLtc, u);
#else
  return lobes.cosineFrame * sampleHemisphere(u);
#endif
}

float pdfSheen(LobeMixture lobes, vec3 l) {
#if SHADING_FABRIC
  return sheenLtcCosine(vec3(1.0, lobes.sheenLtc.yz), l * lobes.sheenFrame);
#else
  return pdfHemisphere(dot(lobes.cosineFrame[2], l));
#endif
}
#endif

// u  [0, 1)^2; its x chooses the lobe
vec3 sampleMixture(LobeMixture lobes, vec2 u) {
  if (u.x < lobes.baseShare) return sampleBase(lobes, lobes.base, vec2(u.x / lobes.baseShare, u.y));
  u.x -= lobes.baseShare;
#if WEAVE
  if (u.x < lobes.weftShare) return sampleBase(lobes, lobes.weft, vec2(u.x / lobes.weftShare, u.y));
  u.x -= lobes.weftShare;
#endif
#if CLEARCOAT
  if (u.x < lobes.coatShare) return sampleLobe(lobes.coat, vec2(u.x / lobes.coatShare, u.y));
  u.x -= lobes.coatShare;
#endif
#if DIFFUSE_TRANSMISSION
  if (u.x < lobes.transmissionShare) return -(lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.transmissionShare, u.y)));
  u.x -= lobes.transmissionShare;
#endif
#if SHEEN
  if (u.x < lobes.sheenShare) return sampleSheen(lobes, vec2(u.x / lobes.sheenShare, u.y));
  u.x -= lobes.sheenShare;
#endif
  return lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.cosineShare, u.y));
}

// Density of sampleMixture(), per steradian.
float pdfMixture(LobeMixture lobes, vec3 l) {
  float sum = lobes.baseShare * pdfBase(lobes, lobes.base, l);
#if WEAVE
  sum += lobes.weftShare * pdfBase(lobes, lobes.weft, l);
#endif
#if CLEARCOAT
  sum += lobes.coatShare * pdfLobe(lobes.coat, l);
#endif
#if DIFFUSE_TRANSMISSION
  sum += lobes.transmissionShare * pdfCosine(-dot(lobes.cosineFrame[2], l));
#endif
#if SHEEN
  sum += lobes.sheenShare * pdfSheen(lobes, l);
#endif
  return sum + lobes.cosineShare * pdfCosine(dot(lobes.cosineFrame[2], l));
}

// Sobol's points, [0, 1)^2: of any aligned block of 2^k points one lies in each cell of any division into 2^k cells. So the
// points of one pass are stratified, and those of all passes more finely.
vec2 sobolPoint(uint index) {
  uint x = 0u;
  uint y = 0u;
  uint inverse = 0x80000000u;
  uint direction = 0x80000000u;
  for (; index != 0u; index >>= 1u) {
    uint chosen = 0u - (index & 1u);
    x ^= inverse & chosen;
    y ^= direction & chosen;
    inverse >>= 1u;
    direction ^= direction >> 1u;
  }
  return vec2(uvec2(x, y) >> 8u) * 5.9604645e-8;
}

// Shifts the points of each pixel by another amount, [0, 1)^2. The error of a few points then averages out over neighbouring
// pixels, where it would be bands without the shift.
// src: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2 by pixel
vec2 pixelShift() {
  return vec2(interleavedGradientNoise(gl_FragCoord.xy), fract(dot(gl_FragCoord.xy, vec2(0.7548776662, 0.5698402910))));
}

// Mean over a solid angle about a direction. RGB radiance, A luminance of the bright part.
vec4 environmentMean(vec3 direction, float solidAngle) {
  vec3 d = viewToEnvironment * direction;
  vec3 size = abs(d);
  float nearest = max(max(size.x, size.y), size.z);
  // A texel of a cube's face covers 4 cos^3 / size^2. The factor 0.125 reads a sharper level than the solid angle asks for: the
  // grain that is left is a smaller error than the blur.
  float texels = 0.125 * solidAngle * environmentSourceSize * environmentSourceSize / (4.0 * nearest * nearest * nearest);
  return textureLod(environmentSource, d, 0.5 * log2(max(texels, 1.0)));
}

// Irradiance by the samples, on both sides of a surface, linear Rec.709.
struct SampledIrradiance {
  vec3 front;
#if DIFFUSE_TRANSMISSION
  vec3 back;
#endif
};

SampledIrradiance addIrradiance(SampledIrradiance sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
  sum.front += lightColor * max(cosine, 0.0);
#if DIFFUSE_TRANSMISSION
  sum.back += lightColor * max(-cosine, 0.0);
#endif
  return sum;
}

// A control variate: the irradiance of the whole map is known exactly, and the difference to that of the samples is added as
// ambient light. Diffuse light is then noisy only where its lobe differs from the cosine.
// src: control variates, as Owen 2013, "Monte Carlo Theory, Methods and Examples", section 8.9
Reflected addControlVariate(Reflected sum, SurfaceInfo s, SampledIrradiance sampled) {
  float whole = PI * environmentIntensity;
  vec3 facing = viewToEnvironment * s.n;
  sum.diffuse += addDome(nothingReflected(), s, whole * textureLod(environmentIrradianceMap, facing, 0.0).rgb - sampled.front).diffuse;
#if DIFFUSE_TRANSMISSION
  sum = addBehind(sum, s, whole * textureLod(environmentIrradianceMap, -facing, 0.0).rgb - sampled.back);
#endif
  return sum;
}

Reflected addSampledEnvironment(Reflected sum, SurfaceInfo s) {
  LobeMixture lobes = lobeMixture(s);
  float count = float(ENVIRONMENT_SAMPLES);
  float all = count * float(environmentPasses);
  vec2 shift = pixelShift();
  SampledIrradiance sampled;
  sampled.front = vec3(0.0);
#if DIFFUSE_TRANSMISSION
  sampled.back = vec3(0.0);
#endif
  for (int i = 0; i < ENVIRONMENT_SAMPLES; ++i) {
    vec2 u = fract(sobolPoint(uint(environmentPass * ENVIRONMENT_SAMPLES + i)) + shift);
    vec3 l = sampleMixture(lobes, u);
    float pdf = pdfMixture(lobes, l);
    if (pdf > 0.0) {
      vec4 light = environmentMean(l, 1.0 / (pdf * all));
      // The bright part has samples of its own, and so the lobes' count for less of it. What they read of a small sun is
      // blurred: the power heuristic keeps that weight small.
      float bright = min(light.a / max(dot(vec3(light), LUMINANCE), 1.0e-30), 1.0);
      float misWeight = 1.0 - bright * powerHeuristic(brightDensity * light.a, pdf * all);
      vec3 lightColor = vec3(light) * (misWeight * environmentIntensity / (pdf * count));
      sum = addPunctual(sum, s, l, lightColor);
      sampled = addIrradiance(sampled, s, l, lightColor);
    }
  }
  for (int i = 0; i < brightCount; ++i) {
    vec3 l = brightDirection[i];
    float misWeight = powerHeuristic(brightIrradiance[i].a, pdfMixture(lobes, l) * all);
    vec3 lightColor = vec3(brightIrradiance[i]) * (misWeight * environmentIntensity);
    sum = addPunctual(sum, s, l, lightColor);
    if (brightIrradiance[i].a < COMPACT_DENSITY) sampled = addIrradiance(sampled, s, l, lightColor);
  }
  return addControlVariate(sum, s, sampled);
}
