import { sinCosDegrees, tanDegrees } from './trig.mjs';

/**
 * Places a camera so that a model fills the frame. Metres, +Y up, the front faces +Z; doubles, no engine-dependent functions.
 *
 * @typedef {[number, number, number]} Vec3
 * @typedef {{min: Vec3, max: Vec3, outline?: Vec3[]}} Bounds outline: the model's farthest points, where they are known
 * @typedef {{right: Vec3, up: Vec3, back: Vec3}} Basis orthonormal; back points from the target to the camera
 */

/** Azimuth and elevation in degrees of each named view. "right" is the picture's right: the camera stands at +X. */
export const VIEWS = Object.freeze({
  front: { azimuth: 0, elevation: 0 },
  back: { azimuth: 180, elevation: 0 },
  left: { azimuth: -90, elevation: 0 },
  right: { azimuth: 90, elevation: 0 },
  top: { azimuth: 0, elevation: 90 },
  bottom: { azimuth: 0, elevation: -90 },
  'three-quarter': { azimuth: 45, elevation: 15 },
});

/** A camera nearer to the box than this part of its diagonal would cut it with the near plane. */
const CLEARANCE = 1e-3;

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const length = (a) => Math.sqrt(dot(a, a));
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaleAdd = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
/** -0 becomes 0: JSON does not keep its sign. */
const plain = (v) => v.map((x) => x + 0);

/**
 * View basis of a camera that looks at the origin from an azimuth (0 = +Z, 90 = +X) and an elevation (90 = +Y), degrees.
 * `up` is the derivative by elevation, so that it is sound at the poles too: from the top, the front (+Z) lies below.
 * @returns {Basis}
 */
export function viewBasis(azimuth, elevation) {
  const a = sinCosDegrees(azimuth);
  const e = sinCosDegrees(elevation);
  return {
    right: [a.cos, 0, -a.sin],
    up: [-e.sin * a.sin, e.cos, -e.sin * a.cos],
    back: [e.cos * a.sin, e.sin, e.cos * a.cos],
  };
}

/** Centre and half extents; a box that is a single point counts as 1 m on a side. */
function centreAndHalf({ min, max }) {
  const centre = min.map((low, i) => low + (max[i] - low) / 2);
  const half = min.map((low, i) => (max[i] - low) / 2);
  return { centre, half: length(half) > 0 ? half : [0.5, 0.5, 0.5] };
}

/** The eight corners of a box. @param {Bounds} bounds */
export const cornersOfBox = ({ min, max }) => Array.from({ length: 8 }, (_, i) => min.map((low, axis) => (i & (1 << axis) ? max[axis] : low)));

/** The eight corners of a box relative to its centre. */
const cornersOf = (half) => Array.from({ length: 8 }, (_, i) => half.map((h, axis) => (i & (1 << axis) ? h : -h)));

/**
 * What must be in the frame, relative to the box's centre, in the axes of a basis: [[x right, y up, z towards the
 * camera], ...]. The model's outline where it is known, since most models are smaller than their box; else its corners.
 */
function cornersIn({ right, up, back }, { centre, half, outline }) {
  const points = outline?.length > 1 ? outline.map((point) => subtract(point, centre)) : cornersOf(half);
  return points.map((point) => [dot(point, right), dot(point, up), dot(point, back)]);
}

const largest = (list, f) => list.reduce((most, item) => Math.max(most, f(item)), -Infinity);

/**
 * Smallest distance from the box's centre at which the corners fit between two planes of slope +-`slope` through the
 * camera, the camera free to shift along `axis`: both planes then touch a corner.
 */
function fittingDistance(corners, axis, slope) {
  const high = largest(corners, (c) => c[axis] + slope * c[2]);
  const low = largest(corners, (c) => slope * c[2] - c[axis]);
  return (high + low) / (2 * slope);
}

/**
 * Shift along `axis` that centres the projection seen from `distance`: the root of max_i a_i + min_j a_j, where
 * a_i(s) = (corner_i - s) / depth_i. Each a_i falls with s, so the root is max over i of min over j of the pairs' roots.
 */
function centringShift(corners, axis, distance) {
  const root = (p, q) => {
    const [depthP, depthQ] = [distance - p[2], distance - q[2]];
    return (p[axis] * depthQ + q[axis] * depthP) / (depthP + depthQ);
  };
  return largest(corners, (p) => -largest(corners, (q) => -root(p, q)));
}

/**
 * Frames a model from a direction: its projection is centred and takes `fit` of the frame in the tighter dimension.
 * @param {Bounds} bounds
 * @param {{azimuth: number, elevation: number, projection: 'perspective' | 'orthographic', fovY?: number, fit: number}} view
 *   degrees; fit (0, 1]
 * @param {number} aspect width / height
 * @returns {{position: Vec3, target: Vec3, up: Vec3, height?: number, near: number, far: number}}
 */
export function frameBounds(bounds, { azimuth, elevation, projection, fovY, fit }, aspect) {
  const basis = viewBasis(azimuth, elevation);
  const { centre, half } = centreAndHalf(bounds);
  const corners = cornersIn(basis, { centre, half, outline: bounds.outline });
  const diagonal = 2 * length(half);
  // Depth goes by the box, which holds every vertex.
  const front = largest(cornersOf(half), (c) => dot(c, basis.back));
  const camera = projection === 'perspective'
    ? framePerspective(corners, fit * tanDegrees(fovY / 2), aspect, front + CLEARANCE * diagonal)
    : frameOrthographic(corners, fit, aspect, diagonal);
  const target = scaleAdd(scaleAdd(centre, camera.x, basis.right), camera.y, basis.up);
  const position = scaleAdd(target, camera.distance, basis.back);
  return {
    position: plain(position),
    target: plain(target),
    up: plain(basis.up),
    ...(camera.height !== undefined && { height: camera.height }),
    ...depthRange(camera.distance - front, camera.distance + front, bounds),
  };
}

function framePerspective(corners, slopeY, aspect, leastDistance) {
  const distance = Math.max(
    fittingDistance(corners, 0, slopeY * aspect), fittingDistance(corners, 1, slopeY), leastDistance);
  return { distance, x: centringShift(corners, 0, distance), y: centringShift(corners, 1, distance) };
}

function frameOrthographic(corners, fit, aspect, diagonal) {
  const [width, height] = [0, 1].map((axis) => {
    const [low, high] = [-largest(corners, (c) => -c[axis]), largest(corners, (c) => c[axis])];
    return { extent: high - low, middle: (low + high) / 2 };
  });
  const seen = Math.max(height.extent, width.extent / aspect);
  return { distance: diagonal, x: width.middle, y: height.middle, height: (seen > 1e-9 * diagonal ? seen : diagonal) / fit };
}

/**
 * Near and far distances that hold the box between them: tight, for the precision of the depth buffer, with room for the
 * rounding of 32-bit vertex positions.
 * @param {number} nearest distance of the box's nearest corner along the view axis; may be negative (camera inside)
 * @param {number} farthest
 * @param {Bounds} bounds
 */
function depthRange(nearest, farthest, bounds) {
  const coordinate = Math.max(...bounds.min.map(Math.abs), ...bounds.max.map(Math.abs));
  // 32-bit floats have a relative step of 1.2e-7; a few steps are lost on the way to clip space.
  const pad = 0.01 * (farthest - nearest) + 1e-3 * Math.abs(farthest) + 5e-7 * coordinate;
  const far = farthest + pad;
  if (far <= 0) return { near: 1e-3 * pad, far: pad };
  return { near: nearest > 0 ? Math.max(nearest - pad, nearest / 2) : 1e-3 * far, far };
}

/**
 * Near and far for a camera that stands where the caller put it.
 * @param {Bounds} bounds
 * @param {Vec3} position
 * @param {Vec3} target
 */
export function depthRangeOf(bounds, position, target) {
  const view = subtract(target, position);
  const axis = view.map((x) => x / length(view));
  const { centre, half } = centreAndHalf(bounds);
  const middle = dot(subtract(centre, position), axis);
  const reach = Math.abs(axis[0]) * half[0] + Math.abs(axis[1]) * half[1] + Math.abs(axis[2]) * half[2];
  return depthRange(middle - reach, middle + reach, bounds);
}
