import { clamp, fract, mix, mod, noiseAt, octaves, smooth, step, TAU, valueNoise } from './noise.mjs';

/** Weaves of spun yarn, which is thicker here and thinner there, of colours that are mixed in it. */

/**
 * @param {object} weave
 * @param {(i: number, j: number) => boolean} weave.over - Whether warp i lies over weft j.
 * @param {number} weave.threads - Of a repeat.
 * @param {number} [weave.crown=0.25] - How far a yarn rises over another, in threads.
 * @param {number} [weave.width=0.92] - Mean of a yarn, in threads: the rest is gap.
 * @param {number} [weave.round=0.35] - Height of a yarn above its sides.
 * @param {number} [weave.slub=0.1] - How far the width varies along a yarn.
 * @param {number} [weave.wander=0.05] - How far a yarn strays, in threads.
 * @param {(warp: 0 | 1, index: number, along: number, edge: number) => number | number[]} [weave.dye] - Colour of a yarn.
 */
export function spun({ over, threads, crown = 0.25, width = 0.92, round = 0.35, slub = 0.1, wander = 0.05, dye }) {
  const lengths = Math.max(threads >> 3, 1); // thick and thin places are some eight crossings long
  const yarn = (across, along, warp, onTop) => {
    const index = mod(Math.floor(across), threads);
    const seed = warp ? 21 : 22;
    const thick = 2 * valueNoise((along * lengths) / threads, index, lengths, seed, threads) - 1;
    const long = noiseAt(index, 0, seed + 2) - 0.5;
    const w = width * (1 + slub * (thick * Math.abs(thick) + 0.7 * long));
    const stray = wander * (2 * valueNoise((along * 2 * lengths) / threads, index, 2 * lengths, seed + 4, threads) - 1);
    const side = (2 * (fract(across) - 0.5 + stray)) / w;
    const [k, t] = [Math.floor(along - 0.5), fract(along - 0.5)];
    const [a, b] = [onTop(k) ? 1 : -1, onTop(k + 1) ? 1 : -1];
    const inside = Math.abs(side) < 1;
    const profile = inside ? round * Math.sqrt(1 - side * side) * (w / width) : -1;
    const height = profile + crown * (a + (b - a) * smooth(t));
    return { height, slope: crown * (b - a) * 6 * t * (1 - t), warp, inside, shade: dye?.(warp, index, along, Math.abs(side)) };
  };
  return (x, y) => {
    const [i, j] = [Math.floor(x), Math.floor(y)];
    const warp = yarn(x, y, 1, (row) => over(i, row));
    const weft = yarn(y, x, 0, (column) => !over(column, j));
    const { inside, ...top } = warp.height >= weft.height ? warp : weft;
    return { ...top, turn: 0, cover: warp.inside || weft.inside ? 1 : 0 };
  };
}

/** Without holes: what lies under the gaps is taken to be cloth. */
const closed = (field) => (x, y) => {
  const { cover, ...point } = field(x, y);
  return point;
};

const plain = (i, j) => mod(i + j, 2) === 0;
const rounded = (edge) => 1 - 0.35 * clamp(edge) ** 3;

/** Warp dyed from outside, its core white where it is worn; weft undyed. */
export const denim = (threads) =>
  closed(
    spun({
      over: (i, j) => mod(i + j, 4) !== 0,
      threads,
      crown: 0.2,
      slub: 0.22,
      dye(warp, index, along, edge) {
        const streak = valueNoise((along * threads) / 16, index, threads * (threads / 16), 31, threads);
        if (!warp) return 0.8 * rounded(edge);
        return (0.16 + 0.1 * noiseAt(index, 1, 32) + 0.12 * streak * streak) * rounded(edge);
      },
    }),
  );

/** 3/1 twill of combed yarn: with twice as many warps as wefts its lines climb at 63 degrees. */
export const gabardine = (threads) =>
  closed(
    spun({
      over: (i, j) => mod(i + j, 4) !== 0,
      threads,
      crown: 0.3,
      slub: 0.04,
      wander: 0.02,
      dye: (warp, index, along, edge) => (warp ? 0.95 : 0.4) * rounded(edge),
    }),
  );

export const linen = (threads) =>
  closed(
    spun({
      over: plain,
      threads,
      width: 0.82,
      slub: 0.5,
      wander: 0.1,
      dye(warp, index, along, edge) {
        const streak = valueNoise((along * 8) / threads, index, 8, warp ? 41 : 42, threads);
        return (0.62 + 0.2 * noiseAt(index, warp, 43) + 0.16 * streak) * rounded(edge) * (edge < 1 ? 1 : 0.75);
      },
    }),
  );

/** Neps of other dyes in a tweed, linear. */
const NEPS = [
  [0.95, 0.42, 0.12],
  [0.9, 0.7, 0.2],
  [0.16, 0.3, 0.55],
  [0.95, 0.93, 0.88],
];

/** Herringbone of wool: 2/2 twill that turns round every `turn` warps; light warp, dark weft, fibres of both mixed in them. */
export const herringbone = (threads, turn = 8) =>
  closed(
    spun({
      over(i, j) {
        const k = mod(i, 2 * turn);
        return mod((k < turn ? k : 2 * turn - 1 - k) + j, 4) < 2;
      },
      threads,
      slub: 0.3,
      wander: 0.12,
      dye(warp, index, along, edge) {
        const fibre = valueNoise(along * 3, index * 4 + edge * 2, threads * 3, 51, threads * 4);
        const nep = noiseAt(index, mod(Math.floor(along / 2), threads / 2), warp ? 52 : 53);
        const light = (warp ? 0.72 : 0.16) * (0.65 + 0.7 * fibre) * rounded(edge);
        return nep > 0.965 ? NEPS[Math.floor((nep - 0.965) * 114)].map((c) => c * rounded(edge)) : [light, 0.96 * light, 0.88 * light];
      },
    }),
  );

/** Flat filament, with doubled yarns every `every` threads against tears. */
export const ripstop = (every) => {
  const ground = closed(spun({ over: plain, threads: every, crown: 0.04, width: 0.99, round: 0.04, slub: 0.02, wander: 0.01 }));
  const across = (x) => step(1.6, 1, Math.abs(mod(x, every) - 1));
  return (x, y) => {
    const raised = Math.max(across(x), across(y));
    const point = ground(x, y);
    return { ...point, height: point.height + 0.55 * raised, shade: 0.86 + 0.1 * raised };
  };
};

/** Sheer plain weave; coverage of 1 - (1 - width) squared. */
export const sheer = (threads, width, wander) => spun({ over: plain, threads, width, wander, crown: 0.12, round: 0.15, slub: 0.15 });

/** Flat stripes and puckered ones of the warp's colour, `stripe` wide; lengths in millimetres. */
export const seersucker = (side, stripe) => (x, y) => {
  const [u, v] = [x / side, y / side];
  const phase = fract(x / (2 * stripe));
  const puckered = step(0, 0.07, phase) * step(0.5, 0.43, phase) + step(1, 1.01, phase);
  const bumps = octaves(u, v, [side / stripe / 1, side / 3], 2, 61);
  const crease = Math.sin(TAU * (y / 4 + 0.6 * octaves(u, v, [side / stripe, side / 8], 1, 63)));
  const thread = 0.03 * (Math.cos(TAU * 2 * x) * Math.cos(TAU * 2 * y));
  const height = puckered * (2 * bumps + 0.45 * crease) + thread;
  return { height, warp: 1, slope: 0, turn: 0, shade: mix(0.85, clamp(0.26 + 0.12 * bumps), puckered) * (0.94 + 2 * thread) };
};

/** Film of wax on a plain weave: matt where it is worn, and cracked along creases. */
export const waxed = (threads) => {
  const ground = closed(spun({ over: plain, threads, crown: 0.2, slub: 0.2 }));
  return (x, y) => {
    const [u, v] = [x / threads, y / threads];
    const worn = step(-0.1, 0.5, octaves(u, v, [3, 3], 4, 71));
    const crack = step(0.05, 0, Math.abs(octaves(u, v, [4, 4], 3, 75)));
    return { ...ground(x, y), gloss: clamp(0.68 + 0.25 * worn + 0.2 * crack), shade: clamp(0.72 + 0.1 * worn + 0.18 * crack) };
  };
};
