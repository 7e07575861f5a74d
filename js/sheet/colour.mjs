import { WHITE, labOf, relativeXyz } from '../compare/colour.mjs';
import { ciede2000 } from '../compare/index.mjs';

/** Colours of cloth: CIE Lab of linear Rec.709 under two lights, and the nearest names of a list. */

/** White of D50, XYZ: ICC.1:2022, 7.2.16. */
const D50 = [0.9642, 1, 0.8249];

/** XYZ to the responses of the cones: Lam (1985), "Metamerism and colour constancy" (Bradford). */
const CONES = [
  [0.8951, 0.2664, -0.1614],
  [-0.7502, 1.7135, 0.0367],
  [0.0389, -0.0685, 1.0296],
];

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, value, i) => sum + value * vector[i], 0));

/** Solves a system of three equations by Cramer's rule. */
function solved(matrix, right) {
  const determinant = ([a, b, c]) => a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  const whole = determinant(matrix);
  return [0, 1, 2].map((column) => determinant(matrix.map((row, i) => row.map((value, k) => (k === column ? right[i] : value)))) / whole);
}

/** XYZ under D65 as it looks under D50: each kind of cone adapts by the ratio of the whites (von Kries). */
function adapted(xyz) {
  const [from, to] = [times(CONES, WHITE), times(CONES, D50)];
  return solved(
    CONES,
    times(CONES, xyz).map((value, i) => (value * to[i]) / from[i]),
  );
}

const DELTA = 6 / 29;
const curve = (t) => (t > DELTA ** 3 ? Math.cbrt(t) : t / (3 * DELTA * DELTA) + 4 / 29);

function labD50(linear) {
  const xyz = adapted(relativeXyz(...linear, [0, 0, 0]).map((value, i) => value * WHITE[i]));
  const [x, y, z] = xyz.map((value, i) => curve(value / D50[i]));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** Lights that a list of colours may be of. */
export const LIGHTS = Object.freeze({ D50: labD50, D65: (linear) => labOf(...linear, [0, 0, 0]) });

/**
 * The names of a list that are nearest to a colour.
 * @param {number[]} linear Rec.709
 * @param {{light: keyof LIGHTS, colours: {name: string, lab: number[]}[]}} list
 * @param {number} [count]
 * @returns {{name: string, difference: number}[]} nearest first; difference: CIEDE2000
 */
export function nearestColours(linear, { light, colours }, count = 3) {
  const lab = LIGHTS[light](linear);
  const found = colours.map(({ name, lab: other }) => ({ name, difference: ciede2000(lab, other) }));
  return found.sort((a, b) => a.difference - b.difference).slice(0, count);
}
