import { TelarError } from '../error/index.mjs';
import { pathText, pointerText } from '../shot/complain.mjs';
import { cornersOfBox, dot } from '../shot/frame.mjs';
import { ABOUT } from './read.mjs';

/** Where call-outs and details point: a point of the model, a part of it, or a place in a picture. */

/** The point that a part of these bounds shows to a viewer in its middle, before it is moved onto the part. */
function middleOf({ bounds, outline }, { right, up, back }) {
  const points = outline?.length > 0 ? outline : cornersOfBox(bounds);
  const range = (axis) => {
    const along = points.map((point) => dot(point, axis));
    return [Math.min(...along), Math.max(...along)];
  };
  const [x, y, z] = [right, up, back].map(range);
  const [across, high, near] = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z[1]];
  return [0, 1, 2].map((i) => across * right[i] + high * up[i] + near * back[i]);
}

/** A point of a part that can be seen: of its surface the one nearest to its middle, on the side of the viewer. */
async function visiblePoint(part, { kind, which, basis, variant, model, call }) {
  const middle = middleOf(part, basis);
  try {
    const { points } = await model.measure({ points: [middle, middle], part: { [kind]: which }, variant, ...call });
    return points[0].position;
  } catch (thrown) {
    // A part of lines or points alone has no surface.
    if (thrown.code !== 'E_MEASURE') throw thrown;
    return middle;
  }
}

/**
 * The point of the model that an item of the spec means.
 * @param {object} item with one of `point`, `node`, `material`, `picture`
 * @param {{pointer: (string | number)[], extent: import('./scale.mjs').Extent,
 *   picture: import('./scale.mjs').TrueView, variant: string,
 *   renderer: object, model: object, call: object}} context
 * @returns {Promise<import('./scale.mjs').Vec3>}
 * @throws {TelarError} E_SPEC
 */
export async function pointOf(item, { pointer, extent, picture, variant, renderer, model, call }) {
  if (item.point) return item.point;
  const { basis, centre } = extent;
  if (item.picture) {
    const [x, y] = item.picture;
    // With the white around the garment, which is as wide on paper in every scale.
    const [width, height] = [picture.paper.width, picture.paper.height].map((side) => (side * picture.ratio) / 1000);
    return centre.map((c, i) => c + (x - 0.5) * width * basis.right[i] + (0.5 - y) * height * basis.up[i]);
  }
  const kind = item.node !== undefined ? 'node' : 'material';
  const shot = { camera: { frame: { [kind]: item[kind] } }, variant };
  const { part } = await renderer.factsOf(model, shot, call);
  if (part?.bounds) return visiblePoint(part, { kind, which: item[kind], basis, variant, model, call });
  const names = part?.names?.slice(0, 8).join(', ') || 'none has a name';
  const at = [...pointer, kind];
  throw new TelarError(ABOUT.code, `${pathText(at, ABOUT)}: the model draws no ${kind} ${JSON.stringify(item[kind])}; it has ${names}`, {
    pointer: pointerText(at),
  });
}
