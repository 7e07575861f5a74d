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

/** Part of the far distance at which a view with perspective begins whose camera stands in what it shows. */
const INSIDE = 1e-3;

/**
 * Least part of the far distance at which a view with perspective begins. At a distance d a step of 24 bits of depth is
 * d^2 / (near 2^24) long: with this part at most far / 1,700. A camera a hair outside of a box would leave no depth at all.
 */
const LEAST = 1e-4;

/** Where a view with perspective begins that has nothing nearer than `nearest`, which is not above 0 for a camera that stands inside. */
export const nearPlane = (nearest, far) => (nearest > 0 ? Math.max(nearest, LEAST * far) : INSIDE * far);

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

const largest = (list, f) => list.reduce((most, item) => Math.max(most, f(item)), -Infinity);

/** What must be in the frame, relative to the box's centre: the outline where it is known, since most models are smaller than their box. */
const pointsOf = ({ centre, half, outline }) => (outline?.length > 1 ? outline.map((point) => subtract(point, centre)) : cornersOf(half));

/**
 * What a camera sees of points as far as framing goes. The camera looks at the origin along -back.
 * @typedef {object} Seen
 * @property {(axis: 0 | 1, slope: number) => number} high - Where a plane of that slope towards the camera, which rises along the
 *   axis (0 right, 1 up), touches the points: the largest of (along the axis + slope * towards the camera). Slope 0 = no perspective.
 * @property {(axis: 0 | 1, slope: number) => number} low - The same to the other side.
 * @property {(axis: 0 | 1, distance: number, slope: number) => number} middle - How far along the axis the points' middle lies.
 */

/** @returns {Seen} from one direction */
function seenFrom(points, { right, up, back }) {
  const corners = points.map((point) => [dot(point, right), dot(point, up), dot(point, back)]);
  const high = (axis, slope) => largest(corners, (c) => c[axis] + slope * c[2]);
  const low = (axis, slope) => largest(corners, (c) => slope * c[2] - c[axis]);
  const middle = (axis, distance, slope) => (slope === 0 ? (high(axis, 0) - low(axis, 0)) / 2 : centringShift(corners, axis, distance));
  return { high, low, middle };
}

/** @returns {Seen} from every azimuth at one elevation: each point is a circle about the vertical axis */
function seenAllRound(points, { up, back }) {
  const [cos, sin] = [up[1], back[1]];
  const circles = points.map(([x, y, z]) => ({ radius: Math.sqrt(x * x + z * z), y }));
  const level = (slope) => largest(circles, ({ radius, y }) => slope * sin * y + radius * Math.sqrt(1 + (slope * cos) ** 2));
  const high = (axis, slope) =>
    axis === 0 ? level(slope) : largest(circles, ({ radius, y }) => (cos + slope * sin) * y + radius * Math.abs(slope * cos - sin));
  const low = (axis, slope) =>
    axis === 0 ? level(slope) : largest(circles, ({ radius, y }) => (slope * sin - cos) * y + radius * Math.abs(slope * cos + sin));
  return { high, low, middle: (axis, _, slope) => (high(axis, slope) - low(axis, slope)) / 2 };
}

/** @returns {Seen} from every direction: each point is a sphere */
function seenFromAnywhere(points) {
  const radius = largest(points, length);
  const reach = (_, slope) => radius * Math.sqrt(1 + slope * slope);
  return { high: reach, low: reach, middle: () => 0 };
}

/** Directions that share one scale with a camera's own, by `fitTo`; and how far points reach towards their cameras. */
const FIT_TO = {
  view: { see: seenFrom, front: (points, { back }) => largest(points, (p) => dot(p, back)) },
  turntable: {
    see: seenAllRound,
    front: (points, { up, back }) => largest(points, ([x, y, z]) => Math.sqrt(x * x + z * z) * Math.abs(up[1]) + y * back[1]),
  },
  all: { see: seenFromAnywhere, front: (points) => largest(points, length) },
};

/** What `camera.fitTo` may be. */
export const FITS = Object.freeze(Object.keys(FIT_TO));

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
 * How far a camera without perspective stands from the middle: any distance will do at which all of it stands before the camera, and the
 * ground too, which a parallel view shows wherever it reaches.
 */
function parallelDistance({ whole, shadow, ground, centre }, { fitTo }, basis) {
  const size = 2 * length(centreAndHalf(whole).half);
  const distance = Math.max(
    size,
    largest(shadow, (point) => length(subtract(point, centre))),
  );
  // From beneath there is no ground to be seen.
  const isSeen = fitTo === 'all' || basis.back[1] > 0;
  const corners = isSeen ? ground.map((point) => subtract(point, centre)) : [];
  const reach = FIT_TO[fitTo].front(corners, basis);
  return reach > distance ? reach + size : distance;
}

/** A shadow stays this far inside the frame, as a part of its half: the outline of a round model misses it by 3 % of its radius. */
const SHADOW_PART = 0.96;

/**
 * Frames a model from a direction: its projection is centred and takes `fit` of the frame in the tighter dimension. Where the
 * shadow would leave the frame, the camera moves away and aside as far as that needs.
 * @param {Bounds} bounds of what is framed
 * @param {{azimuth: number, elevation: number, projection: 'perspective' | 'orthographic', fovY?: number, fit: number, fitTo: string}} view
 *   degrees; fit above 0, more than 1 cuts the model; fitTo: one of FITS
 * @param {number} aspect width / height
 * @param {{shadow?: Vec3[], ground?: Vec3[], whole?: Bounds, trueHeight?: number}} [scene] shadow: points that stay in the frame too, unless `fit` is above 1;
 *   ground: its corners, which stand before the camera where there is no perspective; whole: the model's box where `bounds` are a part of it;
 *   trueHeight: metres that an orthographic frame will have, whatever `fit` asks for
 * @returns {{position: Vec3, target: Vec3, up: Vec3, height?: number, near: number, far: number}}
 */
export function frameBounds(bounds, view, aspect, { shadow = [], ground = [], whole = bounds, trueHeight = Infinity } = {}) {
  const { azimuth, elevation, projection, fovY, fitTo } = view;
  // A given height cuts what it cuts.
  const fit = trueHeight < Infinity ? Math.min(view.fit, 1) : view.fit;
  const basis = viewBasis(azimuth, elevation);
  const { centre, half } = centreAndHalf(bounds);
  const { see, front } = FIT_TO[fitTo];
  const seen = [{ ...see(pointsOf({ centre, half, outline: bounds.outline }), basis), part: fit }];
  if (shadow.length > 0)
    seen.push({
      ...see(
        shadow.map((point) => subtract(point, centre)),
        basis,
      ),
      part: Math.max(fit, SHADOW_PART),
    });
  const diagonal = 2 * length(half);
  const camera =
    projection === 'perspective'
      ? framePerspective(seen, tanDegrees(fovY / 2), aspect, front(cornersOf(half), basis) + CLEARANCE * diagonal)
      : frameOrthographic(seen, aspect, { diagonal, distance: parallelDistance({ whole, shadow, ground, centre }, view, basis), trueHeight });
  const target = scaleAdd(scaleAdd(centre, camera.x, basis.right), camera.y, basis.up);
  const position = plain(scaleAdd(target, camera.distance, basis.back));
  // Depth goes by the box, which holds every vertex.
  const nearest = FIT_TO.view.front(cornersOf(half), basis);
  return {
    position,
    target: plain(target),
    up: plain(basis.up),
    ...(camera.height !== undefined && { height: camera.height }),
    ...(whole === bounds
      ? depthRange([camera.distance - nearest, camera.distance + nearest], bounds, projection)
      : depthRangeOf(whole, { position, target, projection }, [bounds])),
  };
}

/** The largest of f over pairs, the same twice among them. */
const largestOfPairs = (list, f) => largest(list, (a) => largest(list, (b) => f(a, b)));

/**
 * The shift along an axis nearest to the model's own middle at which the shadow is in the frame too.
 * @param {(seen: Seen) => {slope: number, room: number}} planeOf what bounds it: room at the origin, and how much that falls towards the camera
 */
function shiftFor([model, ...shadows], axis, distance, planeOf) {
  return shadows.reduce(
    (shift, shadow) => {
      const { slope, room } = planeOf(shadow);
      return Math.max(shadow.high(axis, slope) - room, Math.min(shift, room - shadow.low(axis, slope)));
    },
    model.middle(axis, distance, planeOf(model).slope),
  );
}

/**
 * The smallest distance at which everything lies between its two planes of slope +-`part` of the frame's through the camera,
 * the camera free to shift: both planes then touch a point.
 */
function framePerspective(seen, slopeY, aspect, leastDistance) {
  const slopes = [({ part }) => part * slopeY * aspect, ({ part }) => part * slopeY];
  const [byWidth, byHeight] = slopes.map((slopeOf, axis) =>
    largestOfPairs(seen, (a, b) => (a.high(axis, slopeOf(a)) + b.low(axis, slopeOf(b))) / (slopeOf(a) + slopeOf(b))),
  );
  const distance = Math.max(byWidth, byHeight, leastDistance);
  const [x, y] = slopes.map((slopeOf, axis) => shiftFor(seen, axis, distance, (one) => ({ slope: slopeOf(one), room: slopeOf(one) * distance })));
  return { distance, x, y };
}

/** Whether all of it lies in the frame with its middle there; roomOf: half of the frame, or a part of that. */
const holds = (seen, axis, middle, roomOf) =>
  seen.every((one) => Math.max(one.high(axis, 0) - middle, one.low(axis, 0) + middle) <= roomOf(Math.max(one.part, SHADOW_PART) + 1e-9));

function frameOrthographic(seen, aspect, { diagonal, distance, trueHeight }) {
  const halfOf = (a, b) => Math.max(a.high(1, 0) + b.low(1, 0), (a.high(0, 0) + b.low(0, 0)) / aspect) / (a.part + b.part);
  const height = 2 * largestOfPairs(seen, halfOf);
  const isFlat = !(height * seen[0].part > 1e-9 * diagonal);
  const framed = isFlat ? diagonal / seen[0].part : height;
  const shown = Math.min(framed, trueHeight);
  const [x, y] = [aspect, 1].map((side, axis) => {
    const roomOf = (part) => (part * shown * side) / 2;
    const shift = shiftFor(seen, axis, distance, ({ part }) => ({ slope: 0, room: roomOf(part) }));
    // A frame in true scale may be too small for model and shadow: it shows the model then.
    return shown === framed || holds(seen, axis, shift, roomOf) ? shift : seen[0].middle(axis, distance, 0);
  });
  return { distance, x, y, height: framed };
}

/**
 * Near and far distances that hold the box between them: tight, for the precision of the depth buffer, with room for the
 * rounding of 32-bit vertex positions.
 * @param {[number, number]} distances of the box's nearest and farthest corner along the view axis; may be negative (camera inside)
 * @param {Bounds} bounds
 * @param {'perspective' | 'orthographic'} projection depth of an orthographic one has the same step everywhere
 */
function depthRange([nearest, farthest], bounds, projection) {
  const coordinate = Math.max(...bounds.min.map(Math.abs), ...bounds.max.map(Math.abs));
  // 32-bit floats have a relative step of 1.2e-7; a few steps are lost on the way to clip space.
  const pad = 0.01 * (farthest - nearest) + 1e-3 * Math.abs(farthest) + 5e-7 * coordinate;
  const far = farthest + pad;
  if (far <= 0) return { near: INSIDE * pad, far: pad };
  const before = Math.max(nearest - pad, nearest / 2);
  return { near: projection === 'orthographic' && before > 0 ? before : nearPlane(before, far), far };
}

/** Distances of a box's nearest and farthest corner along the view axis. */
function distancesTo(bounds, { position, target }) {
  const view = subtract(target, position);
  const axis = view.map((x) => x / length(view));
  const { centre, half } = centreAndHalf(bounds);
  const middle = dot(subtract(centre, position), axis);
  const reach = Math.abs(axis[0]) * half[0] + Math.abs(axis[1]) * half[1] + Math.abs(axis[2]) * half[2];
  return [middle - reach, middle + reach];
}

/**
 * Near and far for a camera that stands somewhere.
 * @param {Bounds} bounds of all that is shown
 * @param {{position: Vec3, target: Vec3, projection: 'perspective' | 'orthographic'}} camera
 * @param {Bounds[]} [parts] of it that near must not cut: in a view from inside near grows with the farthest of what is shown
 */
export function depthRangeOf(bounds, camera, parts = []) {
  const range = (box) => depthRange(distancesTo(box, camera), box, camera.projection);
  const before = parts.filter((part) => distancesTo(part, camera)[1] > 0);
  const { near, far } = range(bounds);
  return { near: Math.min(near, ...before.map((part) => range(part).near)), far };
}
