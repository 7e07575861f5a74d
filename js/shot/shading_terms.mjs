/**
 * The principled shadings as a table of terms: each slot of the shading has a few terms, and a shading is one choice for
 * every slot. The one source of the names: the schema, the C++ enums (renderer/include/telar/shading_terms.inc) and the
 * defines of the shaders (shaders/shading/terms.glsl) are written from it by js/build/docs/generate.mjs, in this order.
 * What each term is and where it comes from stands in js/build/docs/shading_page.mjs.
 */

/** slot: [term of "three-r115", term of "disney-2012", further terms ...] */
export const SLOTS = Object.freeze({
  parameters: ['three-r115', 'disney-2012'],
  diffuse: ['lambert', 'disney-2012', 'frostbite', 'eon', 'disney-2015-thin'],
  distribution: ['ggx', 'gtr2-anisotropic'],
  visibility: ['smith-correlated', 'smith-separable'],
  fresnel: ['schlick-exp2', 'schlick'],
  sheen: ['charlie-neubelt', 'disney-2012', 'ashikhmin-velvet', 'charlie-estevez-kulla', 'zeltner', 'uncharted-4'],
  clearcoat: ['three-r115', 'disney-2012'],
  layering: ['three-r115', 'disney-2012'],
  scattering: ['fdez-aguera', 'single'],
  environment: ['karis', 'three-table', 'lazarov'],
});

/** The columns of the table. */
export const BASES = Object.freeze(['three-r115', 'disney-2012']);

/** Shadings that are not made of terms. */
export const WITHOUT_TERMS = Object.freeze(['three', 'fabric']);

/** What a shading is named by, without the terms swapped in it: "fabric", "three-r115", "three@180". @param {string | object} shading */
export function shadingName(shading) {
  if (typeof shading === 'string') return shading;
  const { base, revision } = shading;
  return revision === undefined ? base : `${base}@${revision}`;
}

/** The terms that a shading names beside its base. @returns {[slot: string, term: string][]} */
export function termsBeside(shading) {
  if (typeof shading === 'string') return [];
  const { base, revision, ...terms } = shading;
  return Object.entries(terms);
}

/**
 * Every slot written out.
 * @param {string | {base: string}} shading a base, or a base with the slots that differ from it
 * @returns {{base: string} & Record<keyof typeof SLOTS, string>}
 */
export function resolveTerms(shading) {
  const { base, ...swapped } = typeof shading === 'string' ? { base: shading } : shading;
  const column = BASES.indexOf(base);
  const terms = Object.entries(SLOTS).map(([slot, names]) => [slot, swapped[slot] ?? names[column]]);
  return { base, ...Object.fromEntries(terms) };
}
