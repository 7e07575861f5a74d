import { LOOKS } from './table/looks.mjs';

/** Keys of a camera that say where it stands: one of them takes the place of all that a look says of that. */
const PLACES = ['view', 'azimuth', 'elevation'];

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
const without = (object, keys) => Object.fromEntries(Object.entries(object).filter(([key]) => !keys.includes(key)));

/** What a camera leaves out, by the look's; one that stands somewhere by itself takes nothing. */
function withCamera(own, { camera }) {
  if (own === undefined) return camera;
  if (!isObject(own) || own.position !== undefined || own.gltf !== undefined) return own;
  const isPlaced = PLACES.some((key) => own[key] !== undefined);
  // Another projection has another lens.
  const left = [...(isPlaced ? PLACES : []), ...(own.projection === undefined ? [] : ['projection', 'fovY'])];
  return { ...without(camera, left), ...own };
}

/**
 * A shot with what its look says beside it. What a caller has written stays.
 * @param {unknown} shot not yet checked
 * @returns {unknown}
 */
export function withLook(shot) {
  if (!isObject(shot) || !Object.hasOwn(LOOKS, shot.look)) return shot;
  const { shot: look } = LOOKS[shot.look];
  const given = Object.fromEntries(Object.entries(shot).filter(([, value]) => value !== undefined));
  return { ...structuredClone(look), ...given, camera: withCamera(given.camera, structuredClone(look)) };
}
