// What alpha must pass for a texel of a shadow map to be covered, where light gets through by alpha. Few neighbours have thresholds that
// are spread evenly, for the filter to average. The pattern of a layer is mirrored and moved against those of others, so that what two of
// them leave out is left out independently. Layers are told apart by their depth: there are so many in a map.
const float LAYERS = 256.0;

float layerThreshold() {
  uint hash = mixedBits(uint(gl_FragCoord.z * LAYERS));
  vec2 texel = (hash & 1u) == 0u ? gl_FragCoord.xy : gl_FragCoord.yx;
  texel *= 1.0 - vec2(hash & 2u, (hash & 4u) >> 1);
  return interleavedGradientNoise(texel + vec2((hash >> 8) & 255u, (hash >> 16) & 255u));
}
