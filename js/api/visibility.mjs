import { isObject, wrongOption } from './option_check.mjs';
import { sha256 } from './sha256.mjs';

/** Ambient visibility as an option of loading, and what it makes of a model's digest. */

/** Of each side of a vertex; as VisibilityRays in C++. */
export const RAYS = Object.freeze({ least: 16, most: 4096, usual: 256 });

/**
 * @param {unknown} value of the option `rays`
 * @param {string} name of it
 * @returns {number}
 * @throws {TelarError} E_OPTION
 */
export function raysOption(value = RAYS.usual, name = 'options.rays') {
  if (Number.isSafeInteger(value) && value >= RAYS.least && value <= RAYS.most) return value;
  throw wrongOption(name, `a whole number from ${RAYS.least} to ${RAYS.most}`, value);
}

/**
 * @param {unknown} value of the option `ambientVisibility`
 * @returns {number | undefined} rays of each side of a vertex; 0 = none are cast, undefined where the caller says nothing
 * @throws {TelarError} E_OPTION
 */
export function visibilityOption(value) {
  if (value === undefined) return undefined;
  if (typeof value === 'boolean') return value ? RAYS.usual : 0;
  if (!isObject(value) || Object.keys(value).some((key) => key !== 'rays'))
    throw wrongOption('options.ambientVisibility', 'true, false or an object with rays', value);
  return raysOption(value.rays, 'options.ambientVisibility.rays');
}

/** Pictures of the model are others than those of its file. */
export const digestWithVisibility = (digest, rays) => (rays ? sha256(`${digest} ambient visibility ${rays}`) : digest);
