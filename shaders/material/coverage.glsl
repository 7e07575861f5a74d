// Cut-out materials of the shading "fabric": how many samples of a pixel the cloth covers. Levels of the base colour map
// below 0 hold the share of a texel that is there (texture/coverage_level.frag).
#if SAMPLE_MASK
uniform int coverageSamples;  // of a pixel
#else
const int coverageSamples = 1;
#endif

// Samples to cover, 0 .. coverageSamples.
// alpha  of the map      cutoff  of the map's alpha
int coveredSamples(float alpha, float cutoff) {
  vec2 size = vec2(textureSize(baseColorMap, 0));
  vec2 dx = dFdx(vBaseColorUv) * size;
  vec2 dy = dFdy(vBaseColorUv) * size;
  // How far the sampler has left level 0, and with it the alpha whose edge can be told.
  float share = clamp(0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0)), 0.0, 1.0);
  float edge = clamp((alpha - cutoff) / max(fwidth(alpha), 1e-4) + 0.5, 0.0, 1.0);
  float covered = mix(edge, alpha, share);
  float threshold = mix(0.5, interleavedGradientNoise(gl_FragCoord.xy), share);
  return int(covered * float(coverageSamples) + threshold);
}

void coverSamples(float vertexAlpha) {
  float cutoff = alphaCutoff / max(baseColorFactor.a * vertexAlpha, 1e-6);
  int count = coveredSamples(texture(baseColorMap, vBaseColorUv).a, cutoff);
  if (count == 0) discard;
#if SAMPLE_MASK
  gl_SampleMask[0] = (1 << count) - 1;
#endif
}
