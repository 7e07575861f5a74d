import { cornersOfBox, cross, dot, length, subtract } from './frame.mjs';
import { lightAxes, spreadOf } from './shadow.mjs';

/**
 * Where the model's shadows lie on the ground, for a camera that holds them in its frame.
 *
 * @typedef {import('./frame.mjs').Vec3} Vec3
 * @typedef {[number, number]} Vec2 x and z on the ground, metres
 */

/** A light whose shadow is longer than this, in diagonals of the model's box, leaves the frame as it is: the model would be tiny. */
const LONGEST = 3;

/**
 * Corners of a convex polygon on the ground that holds the shadows that can be seen there: what the lights throw, as wide
 * as their filters spread it. Shadows longer than three diagonals of the model are left out.
 * @param {object} ground resolved, or 'none'
 * @param {object[]} lights resolved, with their shadows
 * @param {{bounds?: import('./frame.mjs').Bounds}} facts of the model
 * @returns {Vec3[]} world space; empty where no shadow is to be seen
 */
export function fallenShadow(ground, lights, { bounds }) {
  if (ground === 'none' || !bounds || !(ground.opacity > 0)) return [];
  const casters = bounds.outline?.length > 1 ? bounds.outline : cornersOfBox(bounds);
  const height = ground.position[1];
  const reach = LONGEST * length(subtract(bounds.max, bounds.min));
  const fallen = lights.filter(({ castShadow, shadow }) => castShadow && shadow.intensity > 0).flatMap((light) => shadowOf(light, casters, height, reach));
  return clipped(hullOf(fallen), ground).map(([x, z]) => [x, height, z]);
}

/** Around the circle of radius 1. */
const [ACROSS, ASIDE] = [1, Math.SQRT2 - 1];
const OCTAGON = [ACROSS, -ACROSS].flatMap((i) =>
  [ASIDE, -ASIDE].flatMap((j) => [
    [i, j],
    [j, i],
  ]),
);

/** Points on the ground that hold a light's shadow between them; none where it has no end within reach. */
function shadowOf(light, casters, height, reach) {
  const points = casters.flatMap((caster) => spread(light, caster).map(({ point, ray }) => fallOf(point, ray, height)));
  const isNear = ({ sideways }) => sideways <= reach;
  return points.every(isNear) ? points.map(({ place }) => place) : [];
}

/** Where rays go that pass a caster as far off as the filter looks. */
function spread(light, caster) {
  const axes = lightAxes(light.type === 'point' ? { position: light.position, target: caster } : light);
  const [right, up, back] = axes;
  const towards = subtract(caster, light.position);
  const isPoint = light.type === 'point';
  const [width, height] = spreadOf(light, isPoint ? Math.max(...towards.map(Math.abs)) : -dot(towards, back));
  return OCTAGON.map(([i, j]) => {
    const point = caster.map((x, axis) => x + i * width * right[axis] + j * height * up[axis]);
    return { point, ray: light.type === 'directional' ? back.map((x) => -x) : subtract(point, light.position) };
  });
}

/** Where a ray through a point meets the ground: x and z, and how far from beneath the point. */
function fallOf([x, y, z], [dx, dy, dz], height) {
  if (!(dy < 0)) return { sideways: Infinity };
  const time = (y - height) / -dy;
  return { place: [x + time * dx, z + time * dz], sideways: Math.abs(time) * Math.sqrt(dx * dx + dz * dz) };
}

/** Twice the area of a triangle on the ground, above 0 where it turns left. */
const turn = (a, b, c) => cross([b[0] - a[0], b[1] - a[1], 0], [c[0] - a[0], c[1] - a[1], 0])[2];

/** Convex hull, in order. src: Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions" */
function hullOf(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (sorted.length < 3) return sorted;
  const half = (list) =>
    list
      .reduce((chain, point) => {
        while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), point) <= 0) chain.pop();
        chain.push(point);
        return chain;
      }, [])
      .slice(0, -1);
  return [...half(sorted), ...half(sorted.reverse())];
}

/** What of a convex polygon lies on the ground's rectangle. src: Sutherland & Hodgman 1974, "Reentrant polygon clipping" */
function clipped(polygon, { position: [x, , z], size: [width, depth] }) {
  const sides = [
    { axis: 0, sign: 1, limit: x + width / 2 },
    { axis: 0, sign: -1, limit: -(x - width / 2) },
    { axis: 1, sign: 1, limit: z + depth / 2 },
    { axis: 1, sign: -1, limit: -(z - depth / 2) },
  ];
  return sides.reduce(
    (corners, { axis, sign, limit }) =>
      corners.flatMap((to, i) => {
        const from = corners.at(i - 1);
        const [before, after] = [limit - sign * from[axis], limit - sign * to[axis]];
        const part = before / (before - after);
        const border = before * after < 0 ? [from.map((value, k) => value + part * (to[k] - value))] : [];
        return after >= 0 ? [...border, to] : border;
      }),
    polygon,
  );
}
