import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { resolveShot } from '../shot/index.mjs';
import { REVISION, termsOfRevision } from '../shot/three_terms.mjs';

/**
 * Two shadings, and the ways from one to the other where they are made of named terms.
 *
 * @typedef {object} Term - A slot in which the two differ.
 * @property {string} slot
 * @property {string} from - Term of the first shading.
 * @property {string} to - Term of the second.
 *
 * @typedef {object} Swaps
 * @property {Term[]} terms
 * @property {Record<string, object>} shadings - As a shot takes them: "from", "to", for each slot `alone:<slot>` (the first
 *   shading with this term swapped) and `rest:<slot>` (the second with this term put back). One that stands twice under
 *   different names is drawn once.
 */

/** Linear light is the one tone mapping that every release of three.js has. */
const toneMapping = 'linear';

/** The shading with every slot, or the name of one that is not made of terms. @throws {TelarError} E_SHOT where there is none such */
const resolved = (shading) => resolveShot({ shading, toneMapping }, ANY_MODEL).shading;

/** "three" alone, beside another release, is the slots of its own. */
const besideRelease = (shading, other) =>
  shading === 'three' && other.base === 'three' ? { base: 'three', revision: REVISION, ...termsOfRevision(REVISION) } : shading;

/** Keys of a shading that are no slots. */
const NO_SLOTS = ['base', 'revision'];

/** Slots of the two lists of terms stand for other things: only within one of them can a term be swapped. */
const haveSameSlots = (first, second) => typeof first === 'object' && typeof second === 'object' && (first.base === 'three') === (second.base === 'three');

/** @throws {TelarError} E_USAGE */
function checkDiffer(first, second, slots) {
  const bothOfTerms = haveSameSlots(first, second);
  if (bothOfTerms ? slots.length > 0 : first !== second) return;
  throw new TelarError(
    'E_USAGE',
    bothOfTerms
      ? '--to: expected a shading that differs from --from in one term at least'
      : `--to: expected another shading than --from, got ${shown(second)} twice`,
  );
}

/**
 * @param {string | object} first as the shot's shading
 * @param {string | object} second
 * @returns {Swaps} without terms where either shading is not made of them: the whole difference is all there is
 * @throws {TelarError} E_USAGE where they are the same
 */
export function swapsBetween(first, second) {
  const [one, other] = [resolved(first), resolved(second)];
  const [from, to] = [besideRelease(one, other), besideRelease(other, one)];
  const shadings = { from, to };
  const slots = haveSameSlots(from, to) ? Object.keys(from).filter((slot) => !NO_SLOTS.includes(slot) && from[slot] !== to[slot]) : [];
  checkDiffer(from, to, slots);
  for (const slot of slots) {
    shadings[`alone:${slot}`] = { ...from, [slot]: to[slot] };
    shadings[`rest:${slot}`] = { ...to, [slot]: from[slot] };
  }
  return { terms: slots.map((slot) => ({ slot, from: from[slot], to: to[slot] })), shadings };
}
