import { NEW_BORDERS } from './slots_new.mjs';
import { OLD_BORDERS } from './slots_old.mjs';

/**
 * Where a family ends and the next one begins.
 * @typedef {object} Border
 * @property {string} older - A release of the family before.
 * @property {string} newer - A release of the family after.
 * @property {boolean} [everyCase] - What is drawn depends on what was drawn before: all cases are drawn, in their order.
 * @property {Slot[]} slots - What changed between them, all of it.
 *
 * @typedef {object} Slot
 * @property {string} slot - As in slot_terms.mjs.
 * @property {import('./edits.mjs').Edit[]} edits - Put the older term into the newer release's sources.
 * @property {string[]} cases - That show the term.
 */

/** @type {Border[]} Oldest first. */
export const BORDERS = [...OLD_BORDERS, ...NEW_BORDERS];
