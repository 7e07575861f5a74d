import path from 'node:path';
import { isNamedEnvironment } from '../shot/table/environments.mjs';

/**
 * A resolved shot as the native renderer takes it: an environment's path is absolute (a relative one starts at the current
 * folder), bytes travel beside the JSON.
 * @param {object} shot resolved
 * @returns {string} JSON
 */
export function shotJson(shot) {
  const { map } = shot.environment;
  const native = map instanceof Uint8Array ? { bytes: map.byteLength } : isNamedEnvironment(map) ? map : path.resolve(map);
  return JSON.stringify({ ...shot, environment: { ...shot.environment, map: native } });
}
