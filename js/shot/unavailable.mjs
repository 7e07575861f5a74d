import { TelarError } from '../error/index.mjs';

/**
 * Values that the shot's format reserves and this version does not draw: refused by name, so that they are neither taken
 * for typing errors nor left out in silence.
 */
const KEYS = { lens: 'a lens', ground: 'a ground', pose: 'a pose' };
const VALUES = {
  shading: ['fabric', 'three-r115', 'disney-2012'],
  quality: ['high', 'reference'],
  layers: ['depth', 'normal', 'partId', 'ao', 'albedo', 'line', 'shadow'],
  lightType: ['rect', 'disk'],
};

function refuse(path, what) {
  const pointer = `/${path.join('/')}`;
  const name = path.reduce((text, key) => (typeof key === 'number' ? `${text}[${key}]` : `${text}.${key}`), 'shot');
  throw new TelarError('E_SHOT_UNAVAILABLE', `${name}: ${what} is not available in this version of telar`, { pointer });
}

function refuseValue(path, value, reserved) {
  if (reserved.includes(value)) refuse(path, JSON.stringify(value));
}

const isObject = (value) => typeof value === 'object' && value !== null;

/**
 * @param {unknown} shot as given by the caller
 * @throws {TelarError} E_SHOT_UNAVAILABLE
 */
export function refuseUnavailable(shot) {
  if (!isObject(shot)) return;
  for (const [key, what] of Object.entries(KEYS)) {
    if (shot[key] !== undefined) refuse([key], what);
  }
  refuseValue(['shading'], shot.shading, VALUES.shading);
  refuseValue(['quality'], shot.quality, VALUES.quality);
  if (isObject(shot.quality)) {
    for (const key of ['maxError', 'budgetMs']) {
      if (shot.quality[key] !== undefined) refuse(['quality', key], `a quality by ${key}`);
    }
  }
  if (Array.isArray(shot.layers)) shot.layers.forEach((layer, i) => refuseValue(['layers', i], layer, VALUES.layers));
  if (!Array.isArray(shot.lights)) return;
  shot.lights.forEach((light, i) => {
    refuseValue(['lights', i, 'type'], light?.type, VALUES.lightType);
    if (light?.castShadow !== undefined) refuse(['lights', i, 'castShadow'], 'a shadow');
  });
}
