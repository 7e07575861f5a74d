import { indexOrName, list, number, object, union } from './rows.mjs';

/** Rows that name a part of the model. */

const named = { named: true };
export const node = indexOrName('Index or name of a node', 'the index or the name of a node in the model', named);
export const material = indexOrName('Index or name of a material', 'the index or the name of a material in the model', named);

const PART = '{node} or {material}';

/** A part of the garment, by node or material. */
export const garmentPart = (doc, rest = {}) => union(doc, [object('', { node }, { expected: PART }), object('', { material }, { expected: PART })], PART, rest);

const GHOST = '{node, opacity} or {material, opacity}';
/** Most ghosts of a shot. */
export const GHOSTS_MAX = 64;
const opacity = number('Factor on its alpha; 0 = left out', { unit: 'part', min: 0, max: 1, default: 0.25 });

/** Parts that are seen through. */
export const ghost = list(
  'Parts that are drawn translucent, so that lining, pockets and the back neck show through them, or left out, as a mannequin: opacity 0. ' +
    'In names * stands for any characters. What is less opaque than 0.5 is not there for layers, but for line; what is left out is not framed',
  union('A part', [object('', { node, opacity }, { expected: GHOST }), object('', { material, opacity }, { expected: GHOST })], GHOST),
  `a list of at most ${GHOSTS_MAX} parts, ${GHOST}`,
  { max: GHOSTS_MAX, default: [], drawn: false },
);
