import { TEXTS } from '../../dist/shading/index.mjs';
import { shadingMaterialClass } from './material.mjs';
import { definesOfTerms } from './terms.mjs';

/** Classes by family, for each three.js module. */
const classes = new WeakMap();

/**
 * Class of the materials of one family of shadings.
 * @param {typeof import('three')} THREE
 * @param {string} family - three, principled, fabric; `three` is stock three.js by telar's own text, for tests.
 * @returns {Promise<new (parameters?: object) => import('three').MeshPhysicalMaterial>}
 */
export async function loadShading(THREE, family) {
  const text = await TEXTS[family]();
  if (!classes.has(THREE)) classes.set(THREE, {});
  const own = classes.get(THREE);
  own[family] ??= shadingMaterialClass(THREE, text, family);
  return own[family];
}

/** Family of a resolved shot's shading. */
export const familyOf = (shading) => (typeof shading === 'string' ? shading : 'principled');

/** Integers that the text of a resolved shot's shading is compiled with. */
export const definesOf = (shading) => (typeof shading === 'string' ? {} : definesOfTerms(shading));
