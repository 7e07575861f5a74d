import { between, crosses, distance, grown, isWithin, linesCross, overlaps, passes, segmentsOf } from './geometry.mjs';

/**
 * Dimension lines: each is parallel to what it measures, off the garment where there is room, with lines from its ends to the points
 * that it measures between (witness lines). What runs along the cloth, or finds no room outside, is drawn on the garment. No two
 * dimension lines cross, and no label lies on a line, another label or, outside, on the garment. Lengths are millimetres, y down.
 *
 * @typedef {import('./geometry.mjs').Point} Point
 * @typedef {import('./geometry.mjs').Box} Box
 * @typedef {{id: string | number, points: Point[], width: number, height: number, isPath?: boolean}} Dimension points: in the picture, the
 *   first and last are its ends; width, height: of its label; isPath: it runs along its points
 * @typedef {{covers: (x: number, y: number) => boolean}} Garment whether a place is on the garment
 * @typedef {{id: string | number, line: Point[], witness: [Point, Point][], label: Box, outside: boolean}} Drawn
 */

/** Steps outwards, and the white between garment, lines and labels. */
const STEP = 1.5;
const CLEAR = 2;
/** Farthest from what it measures: up to the first on its own account, up to the second where there is no room on the garment. */
const NEAR = 50;
const REACH = 80;
/** A witness line begins off its point and ends behind the dimension line. */
const OFF = 1;
const BEHIND = 1.2;
/** Where along its line a label may stand. */
const PLACES = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.12, 0.88];

/** Whether a line, or its neighbourhood, lies on the garment. */
function touches(garment, [a, b]) {
  const steps = Math.max(1, Math.ceil(distance(a, b)));
  for (let i = 0; i <= steps; ++i) {
    const [x, y] = between(a, b, i / steps);
    for (const [dx, dy] of [
      [0, 0],
      [CLEAR, 0],
      [-CLEAR, 0],
      [0, CLEAR],
      [0, -CLEAR],
    ])
      if (garment.covers(x + dx, y + dy)) return true;
  }
  return false;
}

function isCovered(garment, { x, y, width, height }) {
  for (let i = 0; i <= 4; ++i) for (let j = 0; j <= 2; ++j) if (garment.covers(x + (i * width) / 4, y + (j * height) / 2)) return true;
  return false;
}

/** Point at a part of a line's length. */
function along(line, part) {
  const lengths = segmentsOf(line).map(([a, b]) => distance(a, b));
  let left = part * lengths.reduce((sum, length) => sum + length, 0);
  for (const [i, length] of lengths.entries()) {
    if (left <= length || i === lengths.length - 1) return between(line[i], line[i + 1], length > 0 ? Math.min(1, left / length) : 0);
    left -= length;
  }
  return line[0];
}

const boxAt = ([x, y], { width, height }) => ({ x: x - width / 2, y: y - height / 2, width, height });

/** The label of a line, clear of everything that is drawn already; undefined where there is no room. */
function labelOf(dimension, line, area, garment, drawn) {
  for (const part of PLACES) {
    const box = boxAt(along(line, part), dimension);
    const near = grown(box, 0.6);
    if (!isWithin(box, area) || (garment && isCovered(garment, box))) continue;
    const isFree = drawn.every(
      (other) =>
        !overlaps(near, other.label) &&
        segmentsOf(other.line).every((segment) => !passes(segment, near)) &&
        other.witness.every((segment) => !passes(segment, near)),
    );
    if (isFree) return box;
  }
  return undefined;
}

/** Whether a new line keeps clear of those that are drawn: its witness lines may cross others', dimension lines nothing. */
function isClear(line, witness, drawn) {
  const strokes = [...segmentsOf(line), ...witness];
  return drawn.every((other) => {
    if (linesCross(line, other.line)) return false;
    if (strokes.some((segment) => passes(segment, grown(other.label, 0.6)))) return false;
    if (isBeside(line, other.line)) return false;
    return (
      !segmentsOf(line).some((segment) => other.witness.some((w) => crosses(segment, w))) &&
      !witness.some((w) => segmentsOf(other.line).some((s) => crosses(w, s)))
    );
  });
}

/** Whether two lines run so close along each other that one reads them as one. */
function isBeside(a, b) {
  const near = (line, other) =>
    [0, 0.25, 0.5, 0.75, 1].some((part) => {
      const point = along(line, part);
      return segmentsOf(other).some((segment) => toSegment(point, segment) < 1.2);
    });
  return near(a, b) || near(b, a);
}

function toSegment([px, py], [[ax, ay], [bx, by]]) {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / square)) : 0;
  return Math.hypot(px - ax - t * dx, py - ay - t * dy);
}

const withinArea = (line, { x, y, width, height }) => line.every(([px, py]) => px >= x && py >= y && px <= x + width && py <= y + height);

/** Off the garment, as near as there is room. */
function outside(dimension, { area, garment, drawn, from = CLEAR, to }) {
  const [a, b] = [dimension.points[0], dimension.points.at(-1)];
  const length = distance(a, b);
  if (length < 1) return undefined;
  const normal = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
  for (let off = from; off <= to; off += STEP) {
    for (const sign of [1, -1]) {
      const move = ([x, y], by) => [x + sign * by * normal[0], y + sign * by * normal[1]];
      const line = [move(a, off), move(b, off)];
      if (!withinArea(line, area) || touches(garment, line)) continue;
      const witness = [a, b].map((point) => [move(point, OFF), move(point, off + BEHIND)]);
      if (!witness.every((each) => withinArea(each, area)) || !isClear(line, witness, drawn)) continue;
      const label = labelOf(dimension, line, area, garment, drawn);
      if (label) return { id: dimension.id, line, witness, label, outside: true };
    }
  }
  return undefined;
}

/** On the garment, where it is. */
function inside(dimension, area, drawn) {
  const line = dimension.points;
  if (!withinArea(line, area) || !isClear(line, [], drawn)) return undefined;
  const label = labelOf(dimension, line, area, undefined, drawn);
  return label && { id: dimension.id, line, witness: [], label, outside: false };
}

const lengthOf = ({ points }) => segmentsOf(points).reduce((sum, [a, b]) => sum + distance(a, b), 0);

/**
 * Draws as many dimensions as keep clear of each other. Short ones come first: they lie nearest to the garment, so that the witness
 * lines of long ones pass them by.
 * @param {Dimension[]} dimensions
 * @param {{area: Box, garment: Garment}} place
 * @returns {{drawn: Drawn[], rest: Dimension[]}} rest: those that need another picture, in the order given; `drawn` is empty only
 *   where there are none or one alone does not fit into the area
 */
export function placeDimensions(dimensions, { area, garment }) {
  const drawn = [];
  const order = [...dimensions].sort((a, b) => lengthOf(a) - lengthOf(b));
  for (const dimension of order) {
    const off = (reach) => (dimension.isPath ? undefined : outside(dimension, { area, garment, drawn, ...reach }));
    const placed = off({ to: NEAR }) ?? inside(dimension, area, drawn) ?? off({ from: NEAR, to: REACH });
    if (placed) drawn.push(placed);
  }
  const ids = new Set(drawn.map(({ id }) => id));
  return { drawn, rest: dimensions.filter(({ id }) => !ids.has(id)) };
}
