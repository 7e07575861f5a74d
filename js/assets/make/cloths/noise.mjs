/** Noise of whole numbers alone, so that a cloth is the same wherever it is made. */

export const TAU = 2 * Math.PI;
export const smooth = (t) => t * t * (3 - 2 * t);
export const fract = (t) => t - Math.floor(t);
export const mod = (i, n) => ((i % n) + n) % n;
export const clamp = (t, low = 0, high = 1) => Math.min(Math.max(t, low), high);
export const mix = (a, b, t) => a + (b - a) * t;
export const step = (low, high, t) => smooth(clamp((t - low) / (high - low)));

/** Uniform in [0, 1) from two whole numbers. */
export function noiseAt(i, j, seed = 0) {
  let h = Math.imul(i + 0x9e3779b9, 0x85ebca6b) ^ Math.imul(j + seed * 7919 + 0x165667b1, 0xc2b2ae35);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return ((h ^ (h >>> 15)) >>> 0) / 4294967296;
}

/** Smooth noise in [0, 1] that repeats after `period` cells along x, and as many or `periodY` along y. */
export function valueNoise(x, y, period, seed, periodY = period) {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [smooth(x - i), smooth(y - j)];
  const at = (a, b) => noiseAt(mod(i + a, period), mod(j + b, periodY), seed);
  return (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v;
}

/** Noise about 0, within [-1, 1], of so many octaves: the first has `cells` (along x and y) in a repeat, u and v run over 0..1. */
export function octaves(u, v, [cx, cy], count, seed) {
  let [sum, weight, total] = [0, 1, 0];
  for (let k = 0; k < count; k++) {
    const [px, py] = [cx << k, cy << k];
    sum += weight * (2 * valueNoise(u * px, v * py, px, seed + k, py) - 1);
    total += weight;
    weight *= 0.5;
  }
  return sum / total;
}

/** The cells about a point, each with its number in the repeat and a jittered place: visit(dx, dy, i, j), where d runs from that place. */
export function eachCell(x, y, period, seed, jitter, visit) {
  for (let dj = -1; dj <= 1; dj++) {
    for (let di = -1; di <= 1; di++) {
      const [i, j] = [Math.floor(x) + di, Math.floor(y) + dj];
      const [ci, cj] = [mod(i, period), mod(j, period)];
      const px = i + 0.5 + jitter * (noiseAt(ci, cj, seed) - 0.5);
      const py = j + 0.5 + jitter * (noiseAt(ci, cj, seed + 1) - 0.5);
      visit(x - px, y - py, ci, cj);
    }
  }
}
