/** Separable convolution of one plane, borders repeated. */

/**
 * @param {Float32Array} plane width * height
 * @param {Float64Array} across weights along x, an odd number
 * @param {Float64Array} down weights along y, as many
 * @returns {Float32Array}
 */
export function convolve(plane, width, height, across, down) {
  const radius = (across.length - 1) / 2;
  const half = new Float32Array(plane.length);
  const result = new Float32Array(plane.length);
  // A row with its borders, and the sums of one: in double precision, which the inner loop then reads without conversion.
  const line = new Float64Array(width + 2 * radius);
  const sums = new Float64Array(width);
  const starts = Int32Array.from(across, (_, k) => k);
  for (let y = 0; y < height; y++) {
    const row = plane.subarray(y * width, (y + 1) * width);
    line.fill(row[0], 0, radius).fill(row[width - 1], radius + width);
    line.set(row, radius);
    addUp(sums, across, line, starts);
    half.set(sums, y * width);
  }
  const halves = new Float64Array(half);
  for (let y = 0; y < height; y++) {
    for (let k = 0; k < down.length; k++) starts[k] = width * Math.min(height - 1, Math.max(0, y + k - radius));
    addUp(sums, down, halves, starts);
    result.set(sums, y * width);
  }
  return result;
}

/** sums[x] = the sum over k, in its order, of weights[k] * source[starts[k] + x]. Four at once: each sum is read and written a fourth as often. */
function addUp(sums, weights, source, starts) {
  const width = sums.length;
  sums.fill(0);
  let k = 0;
  for (; k + 4 <= weights.length; k += 4) {
    const [w0, w1, w2, w3] = [weights[k], weights[k + 1], weights[k + 2], weights[k + 3]];
    const [s0, s1, s2, s3] = [starts[k], starts[k + 1], starts[k + 2], starts[k + 3]];
    for (let x = 0; x < width; x++) sums[x] = sums[x] + w0 * source[s0 + x] + w1 * source[s1 + x] + w2 * source[s2 + x] + w3 * source[s3 + x];
  }
  for (; k < weights.length; k++) {
    const [w, s] = [weights[k], starts[k]];
    for (let x = 0; x < width; x++) sums[x] += w * source[s + x];
  }
}

/** Weights f(-radius) .. f(radius). */
export const kernel = (radius, f) => Float64Array.from({ length: 2 * radius + 1 }, (_, i) => f(i - radius));

/** Sum of weights. */
export const total = (weights) => weights.reduce((sum, weight) => sum + weight, 0);
