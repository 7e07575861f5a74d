// Point set and axes of the samples of a GGX lobe. SAMPLES = 2^SAMPLE_BITS
#define SAMPLES (1 << SAMPLE_BITS)

// Point i of Hammersley's set, [0, 1)^2. Its y has the bits of i in reverse order behind the point; every step is exact.
vec2 hammersley(int i) {
  float y = 0.0;
  for (int bit = SAMPLE_BITS - 1; bit >= 0; --bit) y = 0.5 * (y + float((i >> bit) & 1));
  return vec2(float(i) / float(SAMPLES), y);
}

// Two axes across n.
mat2x3 axesAcross(vec3 n) {
  vec3 pole = abs(n.z) < 0.999 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 x = normalize(cross(pole, n));
  return mat2x3(x, cross(n, x));
}
