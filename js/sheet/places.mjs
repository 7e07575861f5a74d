import { TelarError } from '../error/index.mjs';
import { pointerText } from '../shot/complain.mjs';
import { dot } from '../shot/frame.mjs';
import { ABOUT } from './read.mjs';

/** Where call-outs and details point: a point of the model, a part of it, or a place in a picture. */

/** How much more it counts that a point is near to the viewer than that it is in the middle of its part. */
const NEARNESS = 2;

/** A point of a part that can be seen: in its middle, on the side of the viewer. */
function visiblePoint({ bounds, outline }, { right, up, back }) {
  const points = outline?.length > 0 ? outline : [bounds.min.map((low, i) => (low + bounds.max[i]) / 2)];
  const range = (axis) => {
    const along = points.map((point) => dot(point, axis));
    return [Math.min(...along), Math.max(...along)];
  };
  const [x, y] = [right, up].map(range).map(([low, high]) => (low + high) / 2);
  const front = range(back)[1];
  const off = (point) => Math.hypot(dot(point, right) - x, dot(point, up) - y) + NEARNESS * (front - dot(point, back));
  return points.reduce((best, point) => (off(point) < off(best) ? point : best));
}

/**
 * The point of the model that an item of the spec means.
 * @param {object} item with one of `point`, `node`, `material`, `picture`
 * @param {{pointer: (string | number)[], basis: import('./scale.mjs').Basis, extent: import('./scale.mjs').Extent, variant: string,
 *   renderer: object, model: object, signal?: AbortSignal}} context
 * @returns {Promise<import('./scale.mjs').Vec3>}
 * @throws {TelarError} E_SPEC
 */
export async function pointOf(item, { pointer, extent, variant, renderer, model, signal }) {
  if (item.point) return item.point;
  const { basis, centre, width, height } = extent;
  if (item.picture) {
    const [x, y] = item.picture;
    return centre.map((c, i) => c + (x - 0.5) * width * basis.right[i] + (0.5 - y) * height * basis.up[i]);
  }
  const kind = item.node !== undefined ? 'node' : 'material';
  const shot = { camera: { frame: { [kind]: item[kind] } }, variant };
  const { part } = await renderer.factsOf(model, shot, { signal });
  if (part?.bounds) return visiblePoint(part, basis);
  const names = part?.names?.slice(0, 8).join(', ') || 'none has a name';
  const at = [...pointer, kind];
  throw new TelarError(ABOUT.code, `spec.${at.join('.')}: the model draws no ${kind} ${JSON.stringify(item[kind])}; it has ${names}`, {
    pointer: pointerText(at),
  });
}
