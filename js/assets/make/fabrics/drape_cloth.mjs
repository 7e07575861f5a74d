import { Drape } from '../cloth/drape.mjs';

/** A square cloth that fell over a ball: a rounded top that shows every angle to the eye, and folds below it. */

const GRAVITY = 9.81;

/** Metres, but `step` in seconds; `turn` in radians sets the cloth's corners off the axes. */
export const CLOTH = { edge: 0.66, intervals: 76, ball: 0.17, step: 1e-3, steps: 2200, turn: 0.3 };

/** The flat cloth as a panel of the garment's solver (cloth/constraints.mjs). Diagonals alternate: folds lean to no side. */
function panelOf({ edge, intervals }) {
  const stride = intervals + 1;
  const points = [];
  for (let row = 0; row <= intervals; row++) {
    for (let i = 0; i <= intervals; i++) points.push([(i / intervals) * edge, (row / intervals) * edge]);
  }
  const triangles = [];
  for (let row = 0; row < intervals; row++) {
    for (let i = 0; i < intervals; i++) {
      const [a, b, c, d] = [row * stride + i, row * stride + i + 1, (row + 1) * stride + i, (row + 1) * stride + i + 1];
      triangles.push(...((i + row) % 2 === 0 ? [a, b, d, a, d, c] : [a, b, c, b, d, c]));
    }
  }
  return { name: 'cloth', points, triangles: Uint32Array.from(triangles), particle: Uint32Array.from(points.keys()), ranges: {} };
}

/** Flat above the ball, with a ripple of a millimetre: what is perfectly symmetric would not fold. */
function placed({ points }, { edge, ball, turn }) {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const positions = new Float64Array(points.length * 3);
  points.forEach(([u, v], i) => {
    const [x, z] = [u - edge / 2, edge / 2 - v];
    const ripple = 0.001 * Math.sin(x * 31 + 0.7) * Math.cos(z * 27 + 0.2);
    positions.set([x * cos + z * sin, ball + 0.006 + ripple, z * cos - x * sin], i * 3);
  });
  return positions;
}

/** Signed distance to the ball, as the solver asks for it. */
const ballOf = (radius) => (x, y, z, normal) => {
  const length = Math.hypot(x, y, z);
  normal.set([x / length, y / length, z / length]);
  return length - radius;
};

/**
 * @param {typeof CLOTH} [cloth]
 * @returns {{garment: object, positions: Float64Array, uv: Float64Array, indices: Uint32Array, residual: number}} metres, the lowest point at
 *   y = 0; uv in metres on the flat cloth, v down; `residual`: root mean square velocity that is left, m/s
 */
export function drapeCloth(cloth = CLOTH) {
  const panel = panelOf(cloth);
  const garment = { panels: [panel], particleCount: panel.points.length };
  const positions = placed(panel, cloth);
  const drape = new Drape(garment, positions, { size: {}, body: ballOf(cloth.ball), spacing: cloth.edge / cloth.intervals, step: cloth.step });
  drape.run(cloth.steps, (progress) => ({ damping: 1.5 + 14 * progress ** 2, pull: [0, -GRAVITY, 0] }));
  const low = positions.reduce((least, value, i) => (i % 3 === 1 ? Math.min(least, value) : least), Infinity);
  return {
    garment,
    positions: positions.map((value, i) => (i % 3 === 1 ? value - low : value)),
    uv: Float64Array.from(panel.points.flatMap(([u, v]) => [u, cloth.edge - v])),
    indices: panel.triangles,
    residual: Math.sqrt(drape.velocity.reduce((sum, v) => sum + v * v, 0) / panel.points.length),
  };
}
