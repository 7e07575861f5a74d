/**
 * Boxes and lines on paper, millimetres, y down.
 *
 * @typedef {[number, number]} Point
 * @typedef {{x: number, y: number, width: number, height: number}} Box
 */

/** Lengths below this are none: a thousandth of a line's width. */
export const EPSILON = 1e-6;

const side = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
const isOpposite = (p, q) => (p > EPSILON && q < -EPSILON) || (p < -EPSILON && q > EPSILON);

/** Whether two segments cross in their insides. @param {[Point, Point]} a @param {[Point, Point]} b */
export function crosses([a, b], [c, d]) {
  return isOpposite(side(a, b, c), side(a, b, d)) && isOpposite(side(c, d, a), side(c, d, b));
}

/** The segments of a line. @param {Point[]} line @returns {[Point, Point][]} */
export const segmentsOf = (line) => line.slice(1).map((point, i) => [line[i], point]);

/** Whether two lines of segments cross. */
export const linesCross = (a, b) => segmentsOf(a).some((s) => segmentsOf(b).some((t) => crosses(s, t)));

/** Whether two boxes share more than an edge. @param {Box} a @param {Box} b */
export const overlaps = (a, b) =>
  a.x < b.x + b.width - EPSILON && b.x < a.x + a.width - EPSILON && a.y < b.y + b.height - EPSILON && b.y < a.y + a.height - EPSILON;

/** Whether a box lies within another. */
export const isWithin = (a, b) =>
  a.x >= b.x - EPSILON && a.y >= b.y - EPSILON && a.x + a.width <= b.x + b.width + EPSILON && a.y + a.height <= b.y + b.height + EPSILON;

/** A box with a rim on all sides. */
export const grown = ({ x, y, width, height }, by) => ({ x: x - by, y: y - by, width: width + 2 * by, height: height + 2 * by });

const corners = ({ x, y, width, height }) => [
  [x, y],
  [x + width, y],
  [x + width, y + height],
  [x, y + height],
];

const isInside = ([px, py], { x, y, width, height }) => px > x + EPSILON && px < x + width - EPSILON && py > y + EPSILON && py < y + height - EPSILON;

/** Whether a segment passes through the inside of a box. */
export function passes([a, b], box) {
  if (isInside(a, box) || isInside(b, box)) return true;
  const [p, q, r, s] = corners(box);
  return crosses([a, b], [p, r]) || crosses([a, b], [q, s]);
}

export const distance = ([ax, ay], [bx, by]) => Math.hypot(bx - ax, by - ay);
export const between = ([ax, ay], [bx, by], t) => [ax + t * (bx - ax), ay + t * (by - ay)];
