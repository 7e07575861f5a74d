// What alpha must pass for a texel of a shadow map to be covered, where light gets through by alpha. The thresholds of three by three
// neighbours are spread evenly, so that the filter averages them: a lattice whose steps are a third along one axis and one, two or four
// ninths along the other. Each layer has steps and a start of its own, a little off those, so that what two layers leave out is left out
// independently. Layers are told apart by their depth: there are so many in a map. Integers are the same on every GPU.
#include "pixel_noise.glsl"

const float LAYERS = 256.0;
const uint THIRD = 0x55555555u;  // of 2^32
const uint NINTH = 0x1c71c71cu;
const uint OFF = 0x4000000u;  // most that a step is off: 1/64

float layerThreshold() {
  uint hash = mixedBits(uint(gl_FragCoord.z * LAYERS) + 1u);
  uint off = mixedBits(hash);
  uint ninths = NINTH << ((hash >> 8) % 3u);
  uvec2 steps = uvec2(THIRD, (hash & 1u) == 0u ? ninths : 0u - ninths) + (uvec2(off & 0xffffu, off >> 16) << 11) - OFF;
  uvec2 texel = uvec2((hash & 2u) == 0u ? gl_FragCoord.xy : gl_FragCoord.yx);
  uint threshold = mixedBits(off) + steps.x * texel.x + steps.y * texel.y;
  return float(threshold >> 8) / 16777216.0;
}
