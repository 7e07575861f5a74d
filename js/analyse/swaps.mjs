import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { resolveShot } from '../shot/index.mjs';

/**
 * Two shadings made of named terms, and the ways from one to the other.
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

/** A box to resolve shots in: only the shading is read. */
const ANY_MODEL = { min: [0, 0, 0], max: [1, 1, 1] };

/** @throws {TelarError} E_USAGE where the shading is not made of terms, E_SHOT where there is no such shading */
function termsOf(option, shading) {
  const resolved = resolveShot({ shading }, ANY_MODEL).shading;
  if (typeof resolved === 'object') return resolved;
  throw new TelarError('E_USAGE', `--${option}: expected a shading that is made of terms (telar analyse --terms lists them), got ${shown(shading)}`);
}

/**
 * @param {string | object} first as the shot's shading
 * @param {string | object} second
 * @returns {Swaps}
 * @throws {TelarError} E_USAGE where they are the same
 */
export function swapsBetween(first, second) {
  const [from, to] = [termsOf('from', first), termsOf('to', second)];
  const slots = Object.keys(from).filter((slot) => slot !== 'base' && from[slot] !== to[slot]);
  if (slots.length === 0) throw new TelarError('E_USAGE', '--to: expected a shading that differs from --from in one term at least');
  const shadings = { from, to };
  for (const slot of slots) {
    shadings[`alone:${slot}`] = { ...from, [slot]: to[slot] };
    shadings[`rest:${slot}`] = { ...to, [slot]: from[slot] };
  }
  return { terms: slots.map((slot) => ({ slot, from: from[slot], to: to[slot] })), shadings };
}
