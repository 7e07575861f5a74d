import { TelarError } from '../error/index.mjs';
import { nearest, pointerText, shown } from './complain.mjs';
import { matchesName } from './name_pattern.mjs';

/**
 * What a model's parts are called, of the file, as `namesOf` of telar/three and the renderer give it.
 * @typedef {object} Names
 * @property {string[]} materials - By index.
 * @property {{node: number, name: string, parent: number}[]} nodes - Of the drawn scene, parents first. node: index in the file;
 *   parent: place in this list, -1 = none.
 *
 * A cloth on parts of a model.
 * @typedef {object} Dressing
 * @property {number[]} materials - Indices of the file.
 * @property {number[]} nodes - Indices of the file, with all beneath them.
 * @property {string | null} preset
 * @property {[number, number, number] | null} color - Linear Rec.709.
 * @property {number} scale
 * @property {[number, number] | null} metresPerUv - Along u and v; null = to be measured.
 * @property {number} rotation - Degrees, counter-clockwise.
 */

/**
 * Which parts of a model wear which cloth, in the order in which they are put on.
 * @param {object} materials - Of a resolved shot.
 * @param {Names} names
 * @returns {Dressing[]}
 * @throws {TelarError} E_CLOTH
 */
export const dressingsOf = (materials, names) =>
  // JavaScript puts keys of digits first, wherever they are written: as the most exact selectors they hold before names.
  Object.entries(materials)
    .sort(([a], [b]) => Number(isIndex(a)) - Number(isIndex(b)))
    .map(([selector, cloth]) => ({ ...partsOf(selector, names), ...cloth, metresPerUv: bothWays(cloth.metresPerUv) }));

const bothWays = (metres) => (typeof metres === 'number' ? [metres, metres] : metres);

const isIndex = (selector) => /^\d+$/.test(selector);

function partsOf(selector, { materials, nodes }) {
  const isMeant = (name) => matchesName(selector, name);
  const worn = materials.flatMap((name, i) => (isMeant(name) ? [i] : []));
  if (worn.length === 0 && isIndex(selector) && Number(selector) < materials.length) worn.push(Number(selector));
  const named = withAllBeneath(nodes, isMeant);
  if (worn.length === 0 && named.length === 0)
    throw new TelarError('E_CLOTH', missing(selector, materials, nodes), { pointer: pointerText(['materials', selector]) });
  return { materials: worn, nodes: named };
}

/** The named nodes and all beneath them. */
function withAllBeneath(nodes, isMeant) {
  const meant = [];
  for (const { name, parent } of nodes) meant.push(isMeant(name) || (parent >= 0 && meant[parent]));
  return nodes.filter((_, i) => meant[i]).map(({ node }) => node);
}

const MOST_LISTED = 8;

function missing(selector, materials, nodes) {
  const names = [...new Set([...materials, ...nodes.map(({ name }) => name)])].filter((name) => name);
  const near = nearest(selector, names);
  const listed = `${names.slice(0, MOST_LISTED).map(shown).join(', ')}${names.length > MOST_LISTED ? ' and others' : ''}`;
  const has = near ? `did you mean ${shown(near)}?` : `it has ${names.length > 0 ? listed : 'none with a name'}`;
  return `shot.materials: the model has no material or node ${shown(selector)}; ${has}`;
}
