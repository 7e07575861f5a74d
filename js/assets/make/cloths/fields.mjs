import { eachCell, fract, mod, noiseAt, smooth, TAU, valueNoise } from './noise.mjs';

/**
 * The surface of one repeat of a cloth. A field is a function of x and y, which run with u and v (down), both in threads; it repeats after
 * a whole number of them.
 *
 * @typedef {object} SurfacePoint
 * @property {number} height - In threads.
 * @property {0 | 1} warp - 1 where the warp lies on top.
 * @property {number} slope - Rise of that yarn a thread, along x (weft) or y (warp).
 * @property {number} turn - Angle by which it is turned out of its axis, radians, counter-clockwise.
 * @property {0 | 1} [cover] - Of a net: whether there is thread.
 * @property {number | number[]} [shade] - Linear colour about that of the cloth, 0..1: dyed yarns, and the light that hollows keep.
 * @property {number} [gloss] - Factor on the roughness.
 */

/**
 * A weave.
 * @param {(i: number, j: number) => boolean} over - Whether warp i lies over weft j.
 * @param {number} [crown=0.25] - How far a yarn rises over another, in threads.
 * @param {number} [width=0.96] - Of a yarn, in threads: the rest is gap.
 * @param {number} [round=0.35] - Height of a yarn above its sides: spun yarn is round, filament lies flat.
 */
export const woven =
  (over, crown = 0.25, width = 0.96, round = 0.35) =>
  (x, y) => {
    const yarn = (across, along, onTop) => {
      const side = (2 * (fract(across) - 0.5)) / width;
      const [k, t] = [Math.floor(along - 0.5), fract(along - 0.5)];
      const [a, b] = [onTop(k) ? 1 : -1, onTop(k + 1) ? 1 : -1];
      const profile = Math.abs(side) < 1 ? round * Math.sqrt(1 - side * side) : -1;
      return { height: profile + crown * (a + (b - a) * smooth(t)), slope: crown * (b - a) * 6 * t * (1 - t) };
    };
    const [i, j] = [Math.floor(x), Math.floor(y)];
    const warp = yarn(x, y, (row) => over(i, row));
    const weft = yarn(y, x, (column) => !over(column, j));
    return warp.height >= weft.height ? { ...warp, warp: 1, turn: 0 } : { ...weft, warp: 0, turn: 0 };
  };

export const plainWeave = woven((i, j) => mod(i + j, 2) === 0);
export const calendered = woven((i, j) => mod(i + j, 2) === 0, 0.04, 0.99, 0.04);
export const habotai = woven((i, j) => mod(i + j, 2) === 0, 0.08, 0.97, 0.08);
export const twill = woven((i, j) => mod(i + j, 4) !== 0, 0.2); // 3/1: the warp goes over three
export const satinWeave = woven((i, j) => mod(i + 3 * j, 8) !== 0, 0.06, 0.99, 0.04); // the warp goes over seven

/** Plain knit: in every wale two legs of a loop lean against each other. */
export function jersey(x, y) {
  const leg = (side) => {
    const across = fract(x) - 0.5 - side * (0.24 + 0.07 * Math.cos(TAU * y));
    const lean = side * 0.45 * (fract(y) - 0.5);
    const d = (across + lean * 0.5) / 0.27;
    return Math.abs(d) < 1 ? 0.5 * Math.sqrt(1 - d * d) * (0.8 + 0.2 * Math.cos(TAU * (y - 0.25))) : 0;
  };
  return { height: Math.max(leg(-1), leg(1)), warp: 1, slope: 0, turn: 0 };
}

/** Bumps at jittered places: loops of terry, pebbles of leather. */
const cells = (period, radius, seed, shape) => (x, y) => {
  let best = 9;
  eachCell(x, y, period, seed, 0.7, (dx, dy) => {
    best = Math.min(best, Math.hypot(dx, dy));
  });
  return { height: shape(Math.min(best / radius, 1)), warp: 1, slope: 0, turn: 0 };
};
export const terry = (period) => cells(period, 0.72, 3, (d) => 0.7 * Math.sqrt(1 - d * d));
export const pebbles = (period) => cells(period, 0.8, 11, (d) => 0.35 * Math.cos((d * Math.PI) / 2) ** 0.5);

/** Matted or standing fibres: noise of three octaves. */
export const fibres = (period, strength) => (x, y) => {
  const height = strength * (valueNoise(x, y, period, 1) + 0.5 * valueNoise(2 * x, 2 * y, 2 * period, 2) + 0.25 * valueNoise(4 * x, 4 * y, 4 * period, 3));
  return { height, warp: 1, slope: 0, turn: 0 };
};

/** Discs that hang over each other, where rows lie 1/2 apart and discs of a row 1: radius, width and depth of the groove along an edge. */
const DISC = { radius: 0.53, groove: 0.035, depth: 0.1 };

/** Round discs in offset rows, each over the upper half of two of the row below, turned a little another way; x and y in discs, two rows each. */
export const sequins =
  (period, tilt = 0.12) =>
  (x, y) => {
    const { radius, groove, depth } = DISC;
    // The uppermost of those that reach the place: its row is the first.
    for (let row = Math.ceil(2 * (y - radius)); ; row++) {
      const offset = 0.5 * mod(row, 2);
      const column = Math.floor(x - offset);
      const [u, v] = [x - offset - column - 0.5, y - row / 2];
      const distance = Math.hypot(u, v);
      if (distance > radius) continue;
      const angle = TAU * noiseAt(mod(column, period), mod(row, 2 * period), 5);
      return { height: tilt * (u * Math.cos(angle) + v * Math.sin(angle)) - (distance > radius - groove ? depth : 0), warp: 1, slope: 0, turn: 0 };
    }
  };

/** Hexagonal net of threads `width` wide about the sides of its holes; a repeat holds two rows of holes. */
export const net = (width) => (x, y) => {
  const depth = 1 - (2 * toHexagonSide(x, y)) / width;
  return { height: depth > 0 ? 0.5 * width * Math.sqrt(1 - (1 - depth) ** 2) : -1, warp: 1, slope: 0, turn: 0, cover: depth > 0 ? 1 : 0 };
};

/** Distance to the nearest side of a honeycomb whose cells are 1 apart; it repeats after 1 in x and, squeezed, in y. */
function toHexagonSide(x, y) {
  const row = Math.floor(2 * y);
  let [best, bx, by] = [Infinity, 0, 0];
  const each = (visit) => {
    for (let r = row - 1; r <= row + 2; r++) {
      const first = Math.floor(x) - 1 + 0.5 * mod(r, 2);
      for (let cx = first; cx < first + 4; cx++) visit(cx, (r / 2) * ROOT3, (x - cx) ** 2 + ((y - r / 2) * ROOT3) ** 2);
    }
  };
  each((cx, cy, d2) => {
    if (d2 < best) [best, bx, by] = [d2, cx, cy];
  });
  let side = Infinity;
  each((cx, cy, d2) => {
    const apart = Math.hypot(cx - bx, cy - by);
    if (apart > 0) side = Math.min(side, (d2 - best) / (2 * apart));
  });
  return side;
}
const ROOT3 = Math.sqrt(3);

/** Flowers on a net. */
export const laceFlowers = (period) => {
  const ground = net(0.22);
  return (x, y) => {
    const under = ground(x, y);
    const [u, v] = [(fract(x / period) - 0.5) * 2, (fract(y / period) - 0.5) * 2];
    const radius = Math.hypot(u, v);
    const petal = 0.62 + 0.22 * Math.cos(6 * Math.atan2(v, u));
    const inside = radius < petal && (radius > 0.16 || radius < 0.08) && Math.abs(radius - 0.42) > 0.03;
    return inside ? { height: 0.4 + 0.05 * Math.sin(40 * radius), warp: 1, slope: 0, turn: 0, cover: 1 } : under;
  };
};
