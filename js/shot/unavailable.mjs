import { TelarError } from '../error/index.mjs';

/** What the shot's format reserves and this version does not draw is refused by name, so that it is not taken for a typing error. */
const QUALITIES = ['maxError', 'budgetMs'];
const SAMPLES = 'use {samples, environmentSamples}';

function refuse(path, what, instead) {
  const pointer = `/${path.join('/')}`;
  const name = path.reduce((text, key) => (typeof key === 'number' ? `${text}[${key}]` : `${text}.${key}`), 'shot');
  throw new TelarError('E_SHOT_UNAVAILABLE', `${name}: ${what} is not available in this version of telar; ${instead}`, { pointer });
}

const isObject = (value) => typeof value === 'object' && value !== null;

/**
 * @param {unknown} shot as given by the caller
 * @throws {TelarError} E_SHOT_UNAVAILABLE
 */
export function refuseUnavailable(shot) {
  if (!isObject(shot)) return;
  if (isObject(shot.quality)) {
    for (const key of QUALITIES) {
      if (shot.quality[key] !== undefined) refuse(['quality', key], `a quality by ${key}`, SAMPLES);
    }
  }
}
