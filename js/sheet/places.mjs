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

/** Of the surface of a part the point that is nearest to its middle, on the side of the viewer. */
async function nearestPoint(part, { kind, which, basis, variant, model, call }) {
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
 * @param {{pointer: (string | number)[], basis: import('./scale.mjs').Basis,
 *   picture: import('./scale.mjs').TrueView, variant: string,
 *   middleOf: (part: object) => Promise<import('./scale.mjs').Vec3 | undefined>,
 *   renderer: object, model: object, call: object}} context middleOf: of Pictures
 * @returns {Promise<import('./scale.mjs').Vec3>}
 * @throws {TelarError} E_SPEC
 */
export async function pointOf(item, { pointer, basis, picture, variant, middleOf, renderer, model, call }) {
  if (item.point) return item.point;
  if (item.picture) {
    const [x, y] = item.picture;
    // With the white around the garment, which is as wide on paper in every scale.
    return picture.pointAt([x * picture.paper.width, y * picture.paper.height]);
  }
  const kind = item.node !== undefined ? 'node' : 'material';
  const shot = { camera: { frame: { [kind]: item[kind] } }, variant };
  const { part } = await renderer.factsOf(model, shot, call);
  if (part?.bounds) {
    const seen = await middleOf({ [kind]: item[kind] });
    // What is hidden, translucent, or too small for a pixel is where it would be seen.
    return seen ?? nearestPoint(part, { kind, which: item[kind], basis, variant, model, call });
  }
  const names = part?.names?.slice(0, 8).join(', ') || 'none has a name';
  const at = [...pointer, kind];
  throw new TelarError(ABOUT.code, `${pathText(at, ABOUT)}: the model draws no ${kind} ${JSON.stringify(item[kind])}; it has ${names}`, {
    pointer: pointerText(at),
  });
}
