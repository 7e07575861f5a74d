import { TelarError } from '../error/index.mjs';
import { bytesOf } from '../api/source.mjs';

/** Pictures and shots on their way between processes: what is bytes goes beside the header. */

/** A shot or resolved shot with these bytes as its environment. */
export function withMap(shot, map) {
  const whole = bytesOf(shot.environment) !== undefined;
  return { ...shot, environment: whole ? map : { ...shot.environment, map } };
}

/** @returns {object} a resolved shot whose environment's bytes are left out */
const withoutMap = (shot) => (bytesOf(shot.environment?.map) ? { ...shot, environment: { ...shot.environment, map: null } } : shot);

/** Resolved shot of a worker, with the caller's own bytes. */
const restored = (shot, map) => (map && shot.environment?.map === null ? withMap(shot, map) : shot);

/**
 * @param {{data: Buffer, layers?: Record<string, Buffer>, info: object}} image
 * @param {Buffer[]} parts takes its bytes
 */
export function packPicture({ data, layers, info }, parts) {
  parts.push(data, ...Object.values(layers ?? {}));
  return { info: { ...info, shot: withoutMap(info.shot) }, ...(layers && { layers: Object.keys(layers) }) };
}

/** The next byte string of an answer. */
function bytesFrom(parts) {
  const bytes = parts.shift();
  if (!bytes) throw new TelarError('X_INTERNAL', 'a worker answered without its picture');
  return bytes;
}

/**
 * @param {{info: object, layers?: string[]}} packed
 * @param {Buffer[]} parts from which it takes its own
 * @param {Uint8Array | undefined} map bytes of the caller's environment
 */
export function unpackPicture({ info, layers }, parts, map) {
  const data = bytesFrom(parts);
  const files = layers && { layers: Object.fromEntries(layers.map((name) => [name, bytesFrom(parts)])) };
  return { data, ...files, info: { ...info, shot: restored(info.shot, map) } };
}

/** What Model.flat() gives. */
export const packFlat = (flat) => ({ ...flat, shot: withoutMap(flat.shot) });
export const unpackFlat = (flat, map) => ({ ...flat, shot: restored(flat.shot, map) });
