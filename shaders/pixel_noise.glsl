// Noise of neighbouring pixels, [0, 1): the mean over a few of them is right for every share, which leaves no bands.
// pixel  gl_FragCoord.xy
// src: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", interleaved gradient noise
float interleavedGradientNoise(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}
