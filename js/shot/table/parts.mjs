import { indexOrName, object, union } from './rows.mjs';

/** Rows that name a part of the model. */

const named = { named: true };
export const node = indexOrName('Index or name of a node', 'the index or the name of a node in the model', named);
export const material = indexOrName('Index or name of a material', 'the index or the name of a material in the model', named);

const PART = '{node} or {material}';

/** A part of the garment, by node or material. */
export const garmentPart = (doc, rest = {}) => union(doc, [object('', { node }, { expected: PART }), object('', { material }, { expected: PART })], PART, rest);
