import { lightAxes, filterOf } from './shadow.mjs';
import { cornersOfBox, length, subtract } from './frame.mjs';
import { TelarError } from '../error/index.mjs';
import { copied, inOrder } from './table/resolved.mjs';
import { GROUND } from './table/stage.mjs';

/**
 * The ground: a level rectangle at the model's lowest point, or as far below it as it hangs, that shows shadows and nothing else, as wide as they fall.
 *
 * @typedef {import('./frame.mjs').Vec3} Vec3
 * @typedef {import('./frame.mjs').Bounds} Bounds
 */

/** A shadow is followed this far from the model, in diagonals of its box: light that comes in at half a degree. */
const LONGEST = 100;

/** Room around the shadows, as a part of the diagonal. */
const MARGIN = 0.02;

/** Where the ray from a light through a corner meets the ground, or how far it is followed. */
function fallen(corner, ray, height, reach) {
  const level = Math.sqrt(ray[0] ** 2 + ray[2] ** 2);
  const drop = Math.max(0, corner[1] - height);
  const sideways = ray[1] < 0 ? Math.min((drop * level) / -ray[1], reach) : reach;
  const scale = level > 0 ? sideways / level : 0;
  return [corner[0] + scale * ray[0], height, corner[2] + scale * ray[2]];
}

/** Points on the ground that hold a light's shadow between them, and how far the filter spreads it, metres. */
function shadowOf(light, corners, height, diagonal) {
  const reach = LONGEST * diagonal;
  const along = light.type === 'directional' && lightAxes(light)[2].map((x) => -x);
  const rays = corners.map((corner) => along || subtract(corner, light.position));
  const points = corners.map((corner, i) => fallen(corner, rays[i], height, reach));
  const { mapSize, radius } = filterOf(light);
  const distance = Math.max(...points.map((point) => length(subtract(point, light.position))));
  const across = 2 * (along ? diagonal : Math.min(distance, reach));
  // Seen from low above the ground, a texel covers more of it.
  const sine = Math.max(1 / LONGEST, Math.min(...rays.map((ray) => -ray[1] / length(ray))));
  return { points, blur: Math.min(((radius + 2) * across) / mapSize / sine, reach) };
}

/**
 * @param {object | 'none'} ground as the schema parsed it
 * @param {object[]} lights of the shot
 * @param {{bounds?: Bounds}} facts of the model
 * @returns {'none' | {shadow: true, opacity: number, position: Vec3, size: [number, number]}} position: its centre; size:
 *   metres along x and z
 */
export function resolveGround(ground, lights, { bounds }) {
  if (ground === 'none') return ground;
  const { position, size, gap } = ground;
  if (position && size) return copied(inOrder(GROUND, ground));
  if (!bounds) {
    throw new TelarError('E_NO_GEOMETRY', 'shot.ground: the model has nothing that could stand on it; leave the ground out', { pointer: '/ground' });
  }
  const lowest = bounds.min[1] - gap * (bounds.max[1] - bounds.min[1]);
  const fitted = fitGround(position?.[1] ?? lowest, lights, bounds);
  return copied(inOrder(GROUND, { ...ground, position: position ?? fitted.position, size: size ?? fitted.size }));
}

function fitGround(height, lights, bounds) {
  const corners = cornersOfBox(bounds);
  const diagonal = length(subtract(bounds.max, bounds.min)) || 1;
  const shadows = lights.filter(({ castShadow }) => castShadow).map((light) => shadowOf(light, corners, height, diagonal));
  const side = (axis) => {
    const ends = [{ points: corners, blur: 0 }, ...shadows].map(({ points, blur }) => {
      const values = points.map((point) => point[axis]);
      return { low: Math.min(...values) - blur, high: Math.max(...values) + blur };
    });
    const room = MARGIN * diagonal;
    return { low: Math.min(...ends.map(({ low }) => low)) - room, high: Math.max(...ends.map(({ high }) => high)) + room };
  };
  const [x, z] = [side(0), side(2)];
  return { position: [(x.low + x.high) / 2, height, (z.low + z.high) / 2], size: [x.high - x.low, z.high - z.low] };
}

/** Corners of the rectangle; none where there is no ground. */
export function cornersOfGround(ground) {
  if (ground === 'none') return [];
  const {
    position: [x, y, z],
    size: [width, depth],
  } = ground;
  return [-0.5, 0.5].flatMap((i) => [-0.5, 0.5].map((j) => [x + i * width, y, z + j * depth]));
}
