/** The Pareto front of settings: those that no other one beats in time and error at once. */

/**
 * @typedef {{setting: string, cpuMs: number, flip: number}} Point
 * @param {Point[]} points
 * @returns {Point[]} cheapest first; each is more accurate than all that are cheaper
 */
export function frontOf(points) {
  const sorted = points.toSorted((a, b) => a.cpuMs - b.cpuMs || a.flip - b.flip);
  return sorted.filter((point, i) => sorted.slice(0, i).every(({ flip }) => flip > point.flip));
}

/**
 * How many times the time a setting takes of the cheapest that errs no more: 1 = on the front.
 * @param {Point} point
 * @param {Point[]} points
 */
export const aboveFront = (point, points) => point.cpuMs / Math.min(point.cpuMs, ...points.filter(({ flip }) => flip <= point.flip).map(({ cpuMs }) => cpuMs));

/**
 * The cheapest setting with at most so much error; undefined where there is none.
 * @param {Point[]} points
 * @param {number} maxError FLIP
 */
export const cheapestWithin = (points, maxError) =>
  points.filter(({ flip }) => flip <= maxError).reduce((best, point) => (best === undefined || point.cpuMs < best.cpuMs ? point : best), undefined);
