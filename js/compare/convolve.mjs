/** Separable convolution of one plane, borders repeated. */

function indices(length, radius) {
  return Int32Array.from({ length: length + 2 * radius }, (_, i) => Math.min(length - 1, Math.max(0, i - radius)));
}

/**
 * @param {Float32Array} plane width * height
 * @param {Float64Array} across weights along x, an odd number
 * @param {Float64Array} down weights along y, as many
 * @returns {Float32Array}
 */
export function convolve(plane, width, height, across, down) {
  const radius = (across.length - 1) / 2;
  const [columns, rows] = [indices(width, radius), indices(height, radius)];
  const half = new Float32Array(plane.length);
  const result = new Float32Array(plane.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let k = 0; k < across.length; k++) sum += across[k] * plane[y * width + columns[x + k]];
      half[y * width + x] = sum;
    }
  }
  // Row by row, so that memory is read in its order.
  const sums = new Float64Array(width);
  for (let y = 0; y < height; y++) {
    sums.fill(0);
    for (let k = 0; k < down.length; k++) {
      const row = rows[y + k] * width;
      for (let x = 0; x < width; x++) sums[x] += down[k] * half[row + x];
    }
    result.set(sums, y * width);
  }
  return result;
}

/** Weights f(-radius) .. f(radius). */
export const kernel = (radius, f) => Float64Array.from({ length: 2 * radius + 1 }, (_, i) => f(i - radius));

/** Sum of weights. */
export const total = (weights) => weights.reduce((sum, weight) => sum + weight, 0);
