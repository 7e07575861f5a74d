import { SLOTS } from '../../shot/shading_terms.mjs';

/** Define that chooses the term of a slot in shaders/shading/principled.glsl. */
export const termDefine = (slot) => `${slot.toUpperCase()}_TERM`;

/** Define that chooses the term of a slot in which releases of three.js differ. */
export const threeDefine = (slot) => `THREE_${slot.replaceAll(/(?<=[a-z\d])(?=[A-Z])/g, '_').toUpperCase()}_TERM`;

/** Features as defines of 0 or 1. */
export const featureDefines = (features) => Object.fromEntries(Object.entries(features).map(([name, on]) => [name, Number(on)]));

/**
 * @param {Record<string, string>} shading - Resolved: a term for every slot.
 * @returns {Record<string, number>} Position of each term among those of its slot, as C++ counts them.
 */
export function definesOfTerms(shading) {
  return Object.fromEntries(Object.entries(SLOTS).map(([slot, terms]) => [termDefine(slot), terms.indexOf(shading[slot])]));
}
