// Depth in the four bytes of a texel, the most significant first: how releases of three.js before 0.182 keep shadow maps.
const vec4 BYTE_STEPS = vec4(1.0, 256.0, 65536.0, 16777216.0);

// depth  0..1
vec4 packedDepth(float depth) {
#if THREE_SHADOW_PACKING_TERM == THREE_SHADOW_PACKING_TO_ONE
  if (depth >= 1.0) return vec4(1.0);
#endif
  // The first byte is not wrapped: 1 stays in it, and is read as 255/256.
  vec4 digits = vec4(depth, fract(depth * BYTE_STEPS.yzw));
  digits.xyz -= digits.yzw / 256.0;
  return digits * (256.0 / 255.0);
}

// texel  of a map, as it is read
float unpackedDepth(highp vec4 texel) { return dot(texel, (255.0 / 256.0) / BYTE_STEPS); }
