// Cut-out materials of the shading "fabric": which samples of a pixel the cloth covers. Levels of the base colour map
// below 0 hold the share of a texel that is there (texture/coverage_level.frag).
//
// The holes of two layers are independent: two layers that each cover c together cover 1 - (1 - c)^2. So a mask must take every
// sample equally often, and the masks of layers over each other must be independent.
// WebGL has no masks but the first n samples and the last n (js/three/shading/coverage.mjs). From far, where the share is
// all that is known, the two halves of a pixel are covered by thresholds of their own; at an edge that can be seen, the
// first n samples are, or the last n.
// src: Enderton, Sintorn, Shirley & Luebke 2010, "Stochastic Transparency": a mask of random samples for each layer,
//      stratified; Wyman & McGuire 2017, "Hashed Alpha Testing": a hash of place in place of a random number

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

// Bits of the samples to cover.
// cutoff  of the map's alpha
int coveredSamples(float cutoff) {
  uint hash = layerHash();
  float edge = shareOfEdge(texture(baseColorMap, vBaseColorUv).a, cutoff);
#if FULL_DETAIL
  return maskOfEdge(edge, hash);
#else
  vec2 size = vec2(textureSize(baseColorMap, 0));
  vec2 dx = dFdx(vBaseColorUv) * size;
  vec2 dy = dFdy(vBaseColorUv) * size;
  // How far the sampler is from level 0. Only in level 0 does alpha have an edge.
  float level = 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0));
  float there = textureLod(baseColorMap, vBaseColorUv, max(level, 1.0)).a;
  return level < 0.5 ? maskOfEdge(mix(edge, there, level), hash) : maskOfShare(mix(edge, there, min(level, 1.0)), hash);
#endif
}

void coverSamples(float vertexAlpha) {
  float cutoff = alphaCutoff / max(baseColorFactor.a * vertexAlpha, 1e-6);
  int mask = cutoff > 1.0 ? 0 : coveredSamples(cutoff);
  if (!isCovered(mask)) discard;
#if SAMPLE_MASK
  gl_SampleMask[0] = mask;
#endif
}
