// Cut-out materials of the shading "fabric": which samples of a pixel the cloth covers. Levels of the base colour map
// below 0 hold the share of a texel that is there (texture/coverage_level.frag).
//
// The holes of two layers are independent: two layers that each cover c together cover 1 - (1 - c)^2.
//
// At an edge that can be seen, the first n samples of a pixel are covered, or the last n: WebGL has no other masks
// (js/three/shading/coverage.mjs). From far, where the share is all that is known, what is there in part is blended over what
// lies behind it, after all else of the model and without depth, triangles far to near. In any order, the layers together cover the
// right share; only which layer's colour counts more depends on the order.
// What is blended cannot be seen through glass. Where a model has glass, far pixels get masks too, and each half of a pixel has a
// threshold of its own. Such a mask must take every sample equally often, and the masks of layers over each other must be
// independent.
// src: Enderton, Sintorn, Shirley & Luebke 2010, "Stochastic Transparency": a mask of random samples for each layer,
//      stratified; Wyman & McGuire 2017, "Hashed Alpha Testing": a hash of place in place of a random number

#include "material/sampled_level.glsl"

// Layers are told apart by these digits of their depth: their depths must differ by more than 1/8192.
const int LAYER_DEPTH_SHIFT = 10;

// A random number of the layer that is drawn, the same at the four pixels of a quad.
uint layerHash() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 toMiddle = 0.5 - vec2(pixel & 1);
  float depth = vViewPosition.z + dFdx(vViewPosition.z) * toMiddle.x + dFdy(vViewPosition.z) * toMiddle.y;
  uint quad = uint(pixel.x >> 1) | (uint(pixel.y >> 1) << 16);
  return mixedBits(mixedBits(quad) ^ uint(floatBitsToInt(depth) >> LAYER_DEPTH_SHIFT));
}

int firstSamples(int count) { return (1 << count) - 1; }
int lastSamples(int count) { return firstSamples(count) << (coverageSamples - count); }

// Samples to cover in a pixel of which only the share is known. The thresholds of a quad are evenly spaced from a random start.
int maskOfShare(float share, uint hash) {
  uint place = (uint(gl_FragCoord.x) & 1u) | ((uint(gl_FragCoord.y) & 1u) << 1);
  float strata = coverageSamples > 1 ? 8.0 : 4.0;
  float threshold = fract(float(hash >> 8) / 16777216.0 + float((place ^ hash) & 3u) / strata);
  if (coverageSamples == 1) return threshold < share ? 1 : 0;
  int count = coverageSamples / 2;
  return (threshold < share ? firstSamples(count) : 0) | (fract(threshold + 0.5) < share ? lastSamples(count) : 0);
}

// Samples of a pixel through which an edge runs.
int maskOfEdge(float share, uint hash) {
  int count = int(share * float(coverageSamples) + 0.5);
  return (hash & 4u) == 0u ? firstSamples(count) : lastSamples(count);
}

// Share of a pixel that lies on the covered side of the edge. Where alpha is constant there is no edge.
float shareOfEdge(float alpha, float cutoff) {
  float width = fwidth(alpha);
  return width > 1e-4 ? clamp((alpha - cutoff) / width + 0.5, 0.0, 1.0) : step(cutoff, alpha);
}

// coverageDraw
const int COVERAGE_MASKED = 0;   // all that is there, by masks
const int COVERAGE_WHOLE = 1;    // edges, and where nothing is missing
const int COVERAGE_BLENDED = 2;  // the rest, blended
const int COVERAGE_SHARES = 3;   // both, blended: of a net of which next to nothing is whole

// Shares that count as the whole, and as nothing.
const float WHOLE_SHARE = 0.99;
const float NO_SHARE = 0.002;

struct Coverage {
  int mask;     // bits of the samples to cover
  float alpha;  // straight, of what is blended
};

// How much finer the levels are that hold the share than the sampler's: threads about as wide as a pixel are seen, and beat with
// the pixels as they do for paths.
const float LEVELS_FINER = 1.5;

// Two levels are mixed only where one gives way to the other: on llvmpipe one alone is read in half the time.
float finerLevel(float level) {
  float finer = max(level - LEVELS_FINER, 1.0);
  return floor(finer) + saturate(4.0 * fract(finer) - 1.5);
}

// Share of a pixel that is there: the mean of the middles of its quarters.
// level  the sampler's; from 1 on levels hold shares
float shareThere(float level) {
  vec2 across = 0.25 * dFdx(vBaseColorUv);
  vec2 up = 0.25 * dFdy(vBaseColorUv);
  float finer = finerLevel(level);
  float left = textureLod(baseColorMap, vBaseColorUv - across - up, finer).a + textureLod(baseColorMap, vBaseColorUv - across + up, finer).a;
  float right = textureLod(baseColorMap, vBaseColorUv + across - up, finer).a + textureLod(baseColorMap, vBaseColorUv + across + up, finer).a;
  return 0.25 * (left + right);
}

// cutoff  of the map's alpha
Coverage coverageFrom(float cutoff) {
  uint hash = layerHash();
  float edge = shareOfEdge(texture(baseColorMap, vBaseColorUv).a, cutoff);
  float level = sampledLevel(vBaseColorUv, vec2(textureSize(baseColorMap, 0)));
  float there = shareThere(level);
  if (level < 0.5) return Coverage(coverageDraw == COVERAGE_BLENDED ? 0 : maskOfEdge(mix(edge, there, level), hash), 1.0);
  float share = mix(edge, there, min(level, 1.0));
  if (coverageDraw == COVERAGE_MASKED) return Coverage(maskOfShare(share, hash), 1.0);
  bool isWhole = share > WHOLE_SHARE;
  int all = firstSamples(coverageSamples);
  if (coverageDraw == COVERAGE_WHOLE) return Coverage(isWhole ? all : 0, 1.0);
  bool isDrawn = isWhole && coverageDraw == COVERAGE_BLENDED;
  return Coverage(isDrawn || share < NO_SHARE ? 0 : all, share);
}

// return  alpha of the fragment
float coverSamples(float vertexAlpha) {
  float cutoff = alphaCutoff / max(baseColorFactor.a * vertexAlpha, 1e-6);
  Coverage coverage = Coverage(0, 1.0);
  if (cutoff <= 1.0) coverage = coverageFrom(cutoff);
  if (!isCovered(coverage.mask)) discard;
#if SAMPLE_MASK
  gl_SampleMask[0] = coverage.mask;
#endif
  return coverage.alpha;
}
