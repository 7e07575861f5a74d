import { cut, differingBox, grown, sizeOf } from './box.mjs';
import { kernel, total } from './convolve.mjs';

/** Structural similarity as Wang, Bovik, Sheikh and Simoncelli (2004) define it: 11 x 11 Gaussian, sigma 1.5. */

const SIZE = 11;
const SIGMA = 1.5;
const C1 = (0.01 * 255) ** 2;
const C2 = (0.03 * 255) ** 2;

const unscaled = kernel((SIZE - 1) / 2, (x) => Math.exp(-(x * x) / (2 * SIGMA * SIGMA)));
const WEIGHTS = unscaled.map((weight) => weight / total(unscaled));

/** Luma of Rec.601, 0..255. */
const lumaOf = (pixels) =>
  Float64Array.from({ length: pixels.length / 4 }, (_, p) => 0.299 * pixels[p * 4] + 0.587 * pixels[p * 4 + 1] + 0.114 * pixels[p * 4 + 2]);

/** Weighted mean of f over each window that lies whole within the picture. */
function windowMeans(width, height, f) {
  const columns = width - SIZE + 1;
  const half = new Float64Array(columns * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < columns; x++) {
      for (let k = 0; k < SIZE; k++) half[y * columns + x] += WEIGHTS[k] * f(y * width + x + k);
    }
  }
  const means = new Float64Array(columns * (height - SIZE + 1));
  for (let i = 0; i < means.length; i++) {
    for (let k = 0; k < SIZE; k++) means[i] += WEIGHTS[k] * half[i + k * columns];
  }
  return means;
}

/**
 * @param {Uint8Array} expected RGBA8, encoded; alpha is not looked at
 * @param {Uint8Array} actual
 * @returns {number | null} mean over all windows, -1..1, 1 = equal; null for a picture smaller than one window
 */
export function ssim(expected, actual, width, height) {
  if (width < SIZE || height < SIZE) return null;
  const differing = differingBox(expected, actual, width, height);
  if (!differing) return 1;
  // A window over equal pixels has 1, so only those that touch a difference are looked at.
  const box = grown(differing, SIZE - 1, width, height);
  const { values, windows } = windowsOf(cut(expected, width, box), cut(actual, width, box), sizeOf(box));
  const all = (width - SIZE + 1) * (height - SIZE + 1);
  return (values + all - windows) / all;
}

/** Sum of the similarities of all windows, and their number. */
function windowsOf(expected, actual, { width, height }) {
  const [a, b] = [lumaOf(expected), lumaOf(actual)];
  const [meanA, meanB] = [windowMeans(width, height, (i) => a[i]), windowMeans(width, height, (i) => b[i])];
  const squareA = windowMeans(width, height, (i) => a[i] * a[i]);
  const squareB = windowMeans(width, height, (i) => b[i] * b[i]);
  const product = windowMeans(width, height, (i) => a[i] * b[i]);
  let values = 0;
  for (let i = 0; i < meanA.length; i++) {
    const [mean2A, mean2B, means] = [meanA[i] * meanA[i], meanB[i] * meanB[i], meanA[i] * meanB[i]];
    const spread = squareA[i] - mean2A + squareB[i] - mean2B;
    values += ((2 * means + C1) * (2 * (product[i] - means) + C2)) / ((mean2A + mean2B + C1) * (spread + C2));
  }
  return { values, windows: meanA.length };
}
