// Light of the environment by importance sampling of the BSDF. A direction is drawn from a mixture of the lobes, and the
// environment is read from the mip level that covers the solid angle of the sample, so the result has no noise. Each direction
// is shaded by all lobes. View space.
// src: Krivanek & Colbert 2008, "Real-time Shading with Filtered Importance Sampling"; Veach 1997, "Robust Monte Carlo Methods
//      for Light Transport Simulation", section 9.2: the balance heuristic among the lobes, the power heuristic between the
//      lobes and the bright part
#include "light/lobe_types.glsl"
#include "light/lobe_mixture.glsl"
#include "environment/octahedral_map.glsl"
uniform sampler2D environmentSource;         // octahedral: RGB radiance, A luminance of its bright part; a texel of a level is
                                             // the mean of those of the level before
uniform float environmentSourceSize;         // texels on an edge of level 0
uniform sampler2D environmentIrradianceMap;  // octahedral, by the direction that a surface faces: irradiance of it all / PI
uniform float environmentIrradianceSize;     // texels on its edge
uniform mat3 viewToEnvironment;
uniform int environmentPasses;               // over the picture; each has directions of its own
uniform vec2 environmentPoint;               // sobolPoint() of the first direction of this pass, an aligned block's first
// Directions drawn from the bright part of the map, in proportion to its luminance (renderer/ibl/bright_directions.h).
uniform int brightCount;                             // of this pass, up to BRIGHT_DIRECTIONS
uniform vec3 brightDirection[BRIGHT_DIRECTIONS];     // view space
uniform vec4 brightIrradiance[BRIGHT_DIRECTIONS];    // A = their density there over all passes, per steradian
uniform float brightDensity;                         // that density where the luminance is 1

// A light of this density or more is taken out of the map, and so it is not in the map's irradiance.
const float COMPACT_DENSITY = 1.0e29;

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);  // of linear Rec.709

// Sobol's points: of any aligned block of 2^k points one lies in each cell of any division into 2^k cells. So the points of one
// pass are stratified, and those of all passes more finely. In 24 bits.
uvec2 sobolBits(uint index) {
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
  return uvec2(x, y) >> 8u;
}

// Point of a direction of this pass, [0, 1)^2. The bits of a point are those of its block's first one, with those of its index
// in the block added without carry.
vec2 pointOf(int i) {
  return vec2(sobolBits(uint(i)) ^ uvec2(environmentPoint * 16777216.0)) * 5.9604645e-8;
}

// Shift of the points, another for each pixel, [0, 1)^2. With it, the error of a few points averages out over neighbouring
// pixels; without it, there would be bands.
// src: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2 by pixel
vec2 pixelShift() {
  return vec2(interleavedGradientNoise(pixelCentre()), fract(dot(pixelCentre(), vec2(0.7548776662, 0.5698402910))));
}

// Mean over a solid angle about a direction. RGB radiance, A luminance of the bright part.
vec4 environmentMean(vec3 direction, float solidAngle) {
  vec3 d = viewToEnvironment * direction;
  float size = environmentSourceSize;
  float sum = abs(d.x) + abs(d.y) + abs(d.z);
  // A texel of an octahedron covers 4 sum^3 / size^2. The factor 0.125 reads a sharper level than the solid angle asks for: the
  // grain that is left is a smaller error than the blur.
  float texels = 0.125 * solidAngle * size * size / (4.0 * sum * sum * sum);
  float level = floor(0.5 * log2(max(texels, 1.0)));
  return textureLod(environmentSource, octahedralUv(d, max(size * exp2(-level), OCTAHEDRAL_LEAST_SIZE)), level);
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

// Of the whole map, at a surface that faces a direction of view space, linear Rec.709.
vec3 environmentIrradiance(vec3 n) {
  vec2 uv = octahedralUv(viewToEnvironment * n, environmentIrradianceSize);
  return PI * environmentIntensity * textureLod(environmentIrradianceMap, uv, 0.0).rgb;
}

// A control variate: the irradiance of the whole map is known exactly, and the difference to that of the samples is added as
// ambient light. Diffuse light is then noisy only where its lobe differs from the cosine.
// src: control variates, as Owen 2013, "Monte Carlo Theory, Methods and Examples", section 8.9
Reflected addControlVariate(Reflected sum, SurfaceInfo s, SampledIrradiance sampled) {
  sum.diffuse += addDome(nothingReflected(), s, environmentIrradiance(s.n) - sampled.front).diffuse;
#if DIFFUSE_TRANSMISSION
  sum = addBehind(sum, s, environmentIrradiance(-s.n) - sampled.back);
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
    vec2 u = fract(pointOf(i) + shift);
    vec3 l = sampleMixture(lobes, u);
    float pdf = pdfMixture(lobes, l);
    if (pdf > 0.0) {
      vec4 light = environmentMean(l, 1.0 / (pdf * all));
      // MIS weight: the bright part has samples of its own, so samples of the lobes count less there. They read a small sun
      // blurred, and the power heuristic keeps their weight small.
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
