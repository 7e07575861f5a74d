import { clamp, eachCell, fract, mix, noiseAt, octaves, step, TAU, valueNoise } from './noise.mjs';

/** Loops, pile and nap. */

const point = (height, shade, more) => ({ height, warp: 1, slope: 0, turn: 0, shade: clamp(shade), ...more });

/**
 * Rings of yarn that lie over each other, each leaning its own way: terry's loops, boucle's curls.
 * @param {object} curls
 * @param {number} curls.period - Cells of a repeat.
 * @param {number} curls.radius - Mean, in cells.
 * @param {number} curls.yarn - Half of its width, in cells.
 * @param {number} curls.lean - Rise across a ring, of 1.
 * @param {number} curls.bend - How far a ring is pulled out of its shape, in cells.
 * @param {number} curls.round - 1: rings, less: stretched in the direction of their lean.
 */
const curls =
  ({ period, radius, yarn, lean, round, bend, seed }) =>
  (x, y) => {
    const [u, v] = [x / period, y / period];
    const bent = [7, 9].map((more, k) => [x, y][k] + bend * octaves(u, v, [period, period], 2, seed + more));
    const fuzz = octaves(u, v, [4 * period, 4 * period], 2, seed + 5);
    let [height, shade] = [0, 0.36];
    eachCell(...bent, period, seed, 0.8, (dx, dy, i, j) => {
      const angle = TAU * noiseAt(i, j, seed + 2);
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const [along, across] = [(dx * c + dy * s) * round, -dx * s + dy * c];
      const r = radius * (0.7 + 0.6 * noiseAt(i, j, seed + 3));
      const d = (Math.hypot(along, across) - r) / yarn;
      if (Math.abs(d) >= 1) return;
      const body = Math.sqrt(1 - d * d);
      const base = 0.5 * noiseAt(i, j, seed + 4) + lean * along;
      const top = 0.4 + base + yarn * body;
      if (top > height) [height, shade] = [top, 0.48 + 0.18 * body + 0.3 * base];
    });
    return point(height + 0.1 * fuzz, shade + 0.12 * fuzz);
  };
export const terryLoops = (period) => curls({ period, radius: 0.27, yarn: 0.27, lean: 0.7, round: 0.6, bend: 0.25, seed: 111 });
export const boucle = (period) => curls({ period, radius: 0.52, yarn: 0.24, lean: 0.5, round: 0.75, bend: 0.6, seed: 121 });

/** Cut pile. Strokes of a hand leave it leaning: lengths in millimetres, `side` of a repeat. */
export const pile = (side) => (x, y) => {
  const [u, v] = [x / side, y / side];
  const lean = octaves(u, v, [3, 2], 2, 131);
  const stroke = octaves(u, v, [24, 6], 2, 134);
  const fibre = octaves(u, v, [3 * side, 3 * side], 1, 137);
  return point(1.7 * lean + 0.3 * stroke + 0.14 * fibre, 0.66 + 0.07 * lean + 0.08 * stroke + 0.1 * fibre);
};

/** Cords of cut pile between grooves; x runs over cords. */
export const cords = (count) => (x, y) => {
  const [u, v] = [x / count, y / count];
  const shift = 0.03 * octaves(u, v, [count, 8], 1, 141);
  const d = 2 * Math.abs(fract(x + shift) - 0.5);
  const body = Math.sqrt(Math.max(0, 1 - (d / 0.86) ** 2));
  const tuft = octaves(u, v, [count * 4, count * 6], 2, 143);
  return point(0.5 * body + 0.05 * tuft * body, 0.16 + 0.52 * body + (0.12 * tuft + 0.06 * octaves(u, v, [count, 4], 2, 147)) * body);
};

/** Short knap of suede, brushed now this way and now that. Millimetres. */
export const nap = (side) => (x, y) => {
  const [u, v] = [x / side, y / side];
  const brushed = step(-0.25, 0.25, octaves(u, v, [3, 4], 3, 151));
  const grain = octaves(u, v, [2 * side, 3 * side], 2, 155);
  const pores = octaves(u, v, [side / 2, side / 2], 2, 157);
  return point(0.16 * grain + 0.12 * pores, 0.6 + 0.06 * (brushed - 0.5) + 0.16 * grain + 0.08 * pores);
};

/** Fleece: curled fibres that have felted into balls of one to three millimetres. */
export const pilled = (side) => (x, y) => {
  const [u, v] = [x / side, y / side];
  let ball = 0;
  const warped = [x + 0.9 * octaves(u, v, [side, side], 2, 161), y + 0.9 * octaves(u, v, [side, side], 2, 163)];
  eachCell(warped[0] / 2, warped[1] / 2, side / 2, 165, 0.9, (dx, dy, i, j) => {
    const d = Math.hypot(dx, dy) / (0.35 + 0.4 * noiseAt(i, j, 168));
    if (d < 1) ball = Math.max(ball, (1 - d * d) * (0.4 + 0.6 * noiseAt(i, j, 169)));
  });
  const curl = 1 - Math.abs(octaves(u, v, [2 * side, 2 * side], 2, 171));
  return point(0.8 * ball + 0.3 * curl, 0.32 + 0.34 * ball + 0.25 * curl);
};

/** Fibres of felt: short lines every way, matted. Millimetres. */
export const matted = (side) => {
  const strands = (u, v, seed) => 1 - Math.abs(2 * valueNoise(u * 5 * side, v * side, 5 * side, seed, side) - 1) * 2;
  return (x, y) => {
    const [u, v] = [x / side, y / side];
    const across = strands(u + 0.06 * octaves(u, v, [side / 2, side / 2], 2, 181), v, 184);
    const along = strands(v + 0.06 * octaves(u, v, [side / 2, side / 2], 2, 185), u, 188);
    const clouds = octaves(u, v, [4, 4], 3, 189);
    const fibre = mix(across, along, step(-0.2, 0.2, octaves(u, v, [side, side], 1, 192)));
    return point(0.07 * fibre + 0.3 * clouds, 0.68 + 0.1 * fibre + 0.04 * clouds);
  };
};
