import { LOOKS } from './table/looks.mjs';
import { FORMATS } from './table/output.mjs';

/** Keys of a camera that say where it stands: one of them takes the place of all that a look says of that. */
const PLACES = ['view', 'azimuth', 'elevation'];

/** Keys of a camera that say what lens it has. */
const LENS = ['projection', 'fovY'];

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
const without = (object, keys) => Object.fromEntries(Object.entries(object).filter(([key]) => !keys.includes(key)));

/** What a camera leaves out, by the look's; one that stands somewhere by itself takes nothing. */
function withCamera(own = {}, camera) {
  if (!isObject(own) || own.position !== undefined || own.gltf !== undefined) return own;
  const isPlaced = PLACES.some((key) => own[key] !== undefined);
  // Another projection has another lens.
  const left = [...(isPlaced ? PLACES : []), ...(own.projection === undefined ? [] : LENS)];
  return { ...without(camera, left), ...own };
}

/** What a look says for a shot: a true scale has no lens, and what is transparent needs a format that holds it. */
function lookFor({ scale = 'none', output }, { camera, background, ...look }) {
  const format = isObject(output) && Object.hasOwn(FORMATS, output.format) ? output.format : 'png';
  const isHeld = background !== 'transparent' || FORMATS[format].alpha;
  return { ...look, ...(isHeld && { background }), camera: scale === 'none' ? camera : without(camera, LENS) };
}

/**
 * A shot with what its look says beside it. What a caller has written stays.
 * @param {unknown} shot not yet checked
 * @returns {unknown}
 */
export function withLook(shot) {
  if (!isObject(shot) || !Object.hasOwn(LOOKS, shot.look)) return shot;
  const given = Object.fromEntries(Object.entries(shot).filter(([, value]) => value !== undefined));
  const look = lookFor(given, structuredClone(LOOKS[shot.look].shot));
  return { ...look, ...given, camera: withCamera(given.camera, look.camera) };
}
