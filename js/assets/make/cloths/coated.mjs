import { clamp, eachCell, fract, mod, noiseAt, octaves, step, TAU } from './noise.mjs';

/** Skins and films. */

/** Distance to the nearest side between pebbles, 0 on it, in cells; and the pebble's number. */
function toCrease(x, y, period, seed, jitter) {
  let [first, second, own] = [9, 9, 0];
  eachCell(x, y, period, seed, jitter, (dx, dy, i, j) => {
    const d = Math.hypot(dx, dy) * (0.8 + 0.4 * noiseAt(i, j, seed + 2));
    if (d < first) [second, first, own] = [first, d, noiseAt(i, j, seed + 3)];
    else second = Math.min(second, d);
  });
  return [second - first, own];
}

/** Grain of leather: pebbles of two sizes between creases, pores, and folds; x and y in pebbles. */
export const grain = (period) => (x, y) => {
  const [u, v] = [x / period, y / period];
  const bent = [x + 0.5 * octaves(u, v, [period / 2, period / 2], 2, 201), y + 0.5 * octaves(u, v, [period / 2, period / 2], 2, 203)];
  const [coarse, own] = toCrease(...bent, period, 205, 0.9);
  const [fine] = toCrease(2.2 * x, 2.2 * y, Math.round(2.2 * period), 211, 0.9);
  const pebble = step(0, 0.34, coarse);
  const small = step(0, 0.3, fine);
  const fold = step(0.1, 0, Math.abs(octaves(u, v, [2, 3], 3, 215)));
  const height = 0.26 * pebble + 0.05 * small + 0.1 * own - 0.12 * fold;
  const shade = 0.5 + 0.26 * pebble + 0.06 * small - 0.1 * fold + 0.06 * own;
  return { height, warp: 1, slope: 0, turn: 0, shade: clamp(shade), gloss: clamp(1 - 0.28 * pebble * small + 0.1 * fold) };
};

/** Lacquer that flows over a grain: waves alone are left of it. Millimetres. */
export const lacquer = (side) => (x, y) => {
  const [u, v] = [x / side, y / side];
  return { height: 0.25 * octaves(u, v, [4, 4], 2, 221) + 0.012 * octaves(u, v, [side / 2, side / 2], 2, 223), warp: 1, slope: 0, turn: 0 };
};

/** Diamonds of padding between seams; x and y in diamonds, `stitches` along the side of one. */
export const quilt = (period, stitches) => (x, y) => {
  const [u, v] = [x / period, y / period];
  const [p, q] = [fract(x + y) - 0.5, fract(x - y) - 0.5]; // seams where one of them is +-0.5
  const [a, b] = [0.5 - Math.abs(p), 0.5 - Math.abs(q)];
  const seam = Math.min(a, b);
  const puff = (4 * a * (1 - a) * 4 * b * (1 - b)) ** 0.42;
  const along = a < b ? x - y : x + y;
  const stitch = seam < 0.018 && mod(along * stitches, 1) < 0.7 ? 1 : 0;
  const gather = Math.cos(TAU * (along * stitches * 0.35 + 0.4 * octaves(u, v, [4 * period, 4 * period], 1, 231)));
  const wrinkle = 0.012 * gather * Math.exp(-seam * 9) + 0.022 * octaves(u, v, [5 * period, 5 * period], 2, 233) * step(0, 0.15, seam);
  const shade = stitch ? 0.95 : 0.8 - 0.3 * Math.exp(-seam * 40);
  return { height: 0.16 * puff + wrinkle + 0.012 * stitch, warp: 1, slope: 0, turn: 0, shade: clamp(shade) };
};
