// Noise of neighbouring pixels, [0, 1): the mean over a few of them is right for every share, which leaves no bands.
// pixel  gl_FragCoord.xy
// src: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", interleaved gradient noise
float interleavedGradientNoise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

// Every bit of the result depends on every bit of x.
// src: Wellons 2018, "Prospecting for Hash Functions", lowbias32
uint mixedBits(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}
