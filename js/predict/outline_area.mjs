import { cross, dot, sub, unit } from './vectors.mjs';

/** What part of a picture the hull of a model's farthest points fills: what it covers at most. */

/** Twice the area of a triangle, positive where it turns left. */
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

/** Half of the convex hull, from left to right (Andrew 1979, monotone chain). */
function chain(sorted) {
  const found = [];
  for (const point of sorted) {
    while (found.length > 1 && turn(found.at(-2), found.at(-1), point) <= 0) found.pop();
    found.push(point);
  }
  return found;
}

/** @param {[number, number][]} points @returns {number} area of their convex hull */
export function hullArea(points) {
  const sorted = points.toSorted(([ax, ay], [bx, by]) => ax - bx || ay - by);
  const hull = [...chain(sorted).slice(0, -1), ...chain(sorted.toReversed()).slice(0, -1)];
  return hull.reduce((sum, [x, y], i) => sum + x * hull[(i + 1) % hull.length][1] - hull[(i + 1) % hull.length][0] * y, 0) / 2;
}

/**
 * @param {number[][]} outline points of the model, metres
 * @param {object} camera of a resolved shot
 * @param {{width: number, height: number}} size pixels
 * @returns {number} pixels, also those beside the picture; Infinity where a point is not before the camera
 */
export function outlinePixels(outline, { position, target, up, ...camera }, { height }) {
  const forward = unit(sub(target, position));
  const right = unit(cross(forward, up));
  const above = cross(right, forward);
  const halfOf = (depth) => (camera.projection === 'orthographic' ? camera.height / 2 : depth * Math.tan((camera.fovY * Math.PI) / 360));
  const seen = outline.map((point) => {
    const to = sub(point, position);
    const half = halfOf(dot(to, forward));
    return [dot(to, right) / half, dot(to, above) / half, half];
  });
  return seen.some(([, , half]) => !(half > 0)) ? Infinity : (hullArea(seen) * height * height) / 4;
}
