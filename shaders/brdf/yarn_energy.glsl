// How much light a GGX lobe of two widths sends back, in closed form. Shared text: see README.md. The missing share is the even
// lobe's of cloth_energy.glsl, read at another cosine and width and scaled; the numbers are fitted to the exact integrals, at
// most 0.005 to the bright side: `node test/fits/yarn_energy.mjs`.

// Curves of one lobe.   wide, narrow  its widths, (0, 1], wide >= narrow
StretchedCurve stretchedCurve(float wide, float narrow) {
  float even = narrow / wide;
  float stretch = 1.0 - even;
  float wide2 = pow2(wide);
  StretchedCurve curve;
  curve.wide2 = wide2;
  curve.narrow2 = pow2(narrow);
  float middle = 0.61474 - 0.41494 * wide + 0.02372 * even + 0.31942 * wide2;
  curve.middle2 = mix(curve.narrow2, wide2, clamp(middle, 0.05, 1.0));
  curve.even = glossCurve(sqrt(sqrt(curve.middle2)));
  curve.missing = vec4(-0.20882, 0.10506, 0.1608, -0.62388) + vec4(0.06917, -0.0986, 0.22012, 0.54975) * wide +
      vec4(0.76819, -1.04387, -0.82159, 0.80672) * even + vec4(0.03752, 0.03171, -0.35515, -0.08909) * wide2;
  curve.width = vec4(-0.66714, 1.75086, -1.16979, 0.39109) + vec4(-0.7103, -1.26667, 2.08477, 0.61989) * wide +
      vec4(1.68641, -7.45126, 6.01511, 0.2796) * even + vec4(0.49069, -0.4081, 0.7239, -0.56408) * wide2;
  float lift = -0.001 - 0.00089 * wide + 0.38424 * even + 0.00135 * wide2;
  curve.grazing = vec4(-0.00303, -0.0107, 0.02501, 0.08854) + vec4(0.02787, 1.12468, -1.03159, -0.94784) * wide +
      vec4(-0.08604, 0.22977, -0.14278, -0.15574) * even + vec4(-0.02801, -1.71078, 2.04711, 0.3377) * wide2;
  curve.missing *= stretch;
  curve.width *= stretch;
  curve.lift = stretch * wide2 * max(lift, 0.0);
  curve.grazing *= stretch;
  float root = sqrt(wide);
  float missing = -0.60886 - 0.4839 * wide + 0.11429 * even - 0.09258 * wide2 + root * (1.10789 - 0.05052 * even) - 0.14143 * pow2(even);
  float grazing = 0.04236 + root * (0.1241 + root * (-0.57417 + root * (0.70042 - root * 0.28206))) +
                  even * (0.01907 - 0.08152 * root + 0.04581 * wide - even * (0.01067 - 0.02036 * root));
  curve.average = vec2(glossAverage(curve.even).x * (1.0 + stretch * missing), grazing);
  return curve;
}

// Share of what an even lobe reflects that belongs to f90, [0, 1].   r  perceptual roughness, (0, 1]      cosine  [0, 1]
float grazingRatio(float r, float cosine) {
  float n1 = 2.04592 + r * (-1.62868 - r * 2.38684);
  float q0 = 0.5332 + r * (3.69795 + r * (-4.00977 + r * 1.62822));
  float q1 = 2.17487 + r * (-2.75808 + r * (-5.6708 + r * 10.7144));
  float q2 = 4.01583 + r * (-1.57675 - r * 4.76371);
  return pow2((1.0 - cosine) * (1.0 + pow2(n1) * cosine) / (1.0 + r * pow2(q0) + cosine * (pow2(q1) + cosine * pow2(q2))));
}

// glossAlbedo() of the lobe for one direction.
// cosine  [0, 1], with the lobe's normal      alongWide, alongNarrow  cosines with the axes of both widths
vec2 stretchedAlbedo(StretchedCurve curve, float cosine, float alongWide, float alongNarrow) {
  float sine2 = pow2(alongWide) + pow2(alongNarrow);
  float spread2 = curve.wide2 * pow2(alongWide) + curve.narrow2 * pow2(alongNarrow);
  float share = min(spread2 / curve.wide2, 1.0);
  float root = sqrt(share);
  // The even lobe's curve where the slope of the direction is the same in units of the lobe's width.
  float level = cosine * inversesqrt(max(pow2(cosine) + spread2 / curve.middle2, COSINE_EPSILON));
  float missing = glossMissing(curve.even, level) *
                  (1.0 + curve.missing.x + curve.missing.y * share + level * (curve.missing.z + curve.missing.w * share));
  float width2 = sine2 > HEAD_ON_EPSILON ? min(spread2 / sine2, curve.wide2) : curve.wide2;
  width2 *= max(1.0 + curve.width.x + curve.width.y * root + curve.width.z * share + curve.width.w * cosine, 0.02);
  width2 = clamp(width2 + curve.lift * cosine, 1.0e-9, 1.0);
  float grazing = max(1.0 - curve.grazing.x - curve.grazing.y * root - curve.grazing.z * share - curve.grazing.w * cosine, 0.0);
  return vec2(missing, (1.0 - missing) * grazing * grazingRatio(sqrt(sqrt(width2)), cosine));
}
