import { TelarError } from '../error/index.mjs';

/**
 * Values that the shot's format reserves and this version does not draw: refused by name, so that they are neither taken
 * for typing errors nor left out in silence. [values, what to use instead] by key.
 */
const VALUES = {
  layers: [['depth', 'normal', 'partId', 'ao', 'albedo', 'line', 'shadow'], 'use "beauty"'],
};
const QUALITIES = ['maxError', 'budgetMs'];
const SAMPLES = 'use {samples, environmentSamples}';

function refuse(path, what, instead) {
  const pointer = `/${path.join('/')}`;
  const name = path.reduce((text, key) => (typeof key === 'number' ? `${text}[${key}]` : `${text}.${key}`), 'shot');
  throw new TelarError('E_SHOT_UNAVAILABLE', `${name}: ${what} is not available in this version of telar; ${instead}`, { pointer });
}

function refuseValue(path, value, [reserved, instead]) {
  if (reserved.includes(value)) refuse(path, JSON.stringify(value), instead);
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
  if (Array.isArray(shot.layers)) shot.layers.forEach((layer, i) => refuseValue(['layers', i], layer, VALUES.layers));
}
