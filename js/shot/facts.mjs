import { TelarError } from '../error/index.mjs';

const AXES = ['x', 'y', 'z'];
const isFinitePoint = (point) => point.length === 3 && point.every((x) => typeof x === 'number' && Number.isFinite(x));
const asPoint = (value) => (Array.isArray(value) ? value : AXES.map((axis) => value?.[axis]));

/** A box to resolve a shot in, metres, where what is read of it does not depend on the model. */
export const ANY_MODEL = { min: [0, 0, 0], max: [1, 1, 1] };

/**
 * What resolveShot needs to know of a model.
 * @param {unknown} facts of `renderer.load`, `inspect` or `factsOf` of telar/three, or a box alone: {min, max} with [x, y, z] or {x, y, z} in metres,
 *   as THREE.Box3 has them; undefined where the shot's camera is explicit
 * @returns {{bounds?: import('./frame.mjs').Bounds, part?: import('./part.mjs').PartFact, cameras?: object[], variants?: string[], animations?: object[]}} bounds undefined = nothing to draw
 * @throws {TelarError} E_OPTION
 */
export function readFacts(facts) {
  if (facts === undefined || facts === null) return {};
  const isBox = facts.min !== undefined && facts.max !== undefined;
  return {
    bounds: readBounds(isBox ? facts : facts.bounds, facts.outline),
    part: facts.part && { ...facts.part, bounds: readBounds(facts.part.bounds, facts.part.outline) },
    cameras: facts.cameras,
    variants: facts.variants,
    animations: facts.animations,
  };
}

function readBounds(box, outline) {
  if (box === undefined || box === null) return undefined;
  const [min, max] = [asPoint(box.min), asPoint(box.max)];
  // An empty THREE.Box3 runs from +Infinity to -Infinity.
  if (min.every((x) => x === Infinity) && max.every((x) => x === -Infinity)) return undefined;
  if (!isFinitePoint(min) || !isFinitePoint(max) || min.some((low, i) => low > max[i])) {
    throw new TelarError('E_OPTION', 'facts: expected bounds {min, max} of three finite numbers each, min <= max');
  }
  if (outline !== undefined && !(Array.isArray(outline) && outline.every((point) => Array.isArray(point) && isFinitePoint(point)))) {
    throw new TelarError('E_OPTION', 'facts.outline: expected a list of points of three finite numbers');
  }
  return { min: [...min], max: [...max], ...(outline?.length > 0 && { outline }) };
}
