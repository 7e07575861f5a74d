import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { TelarError, fromNative } from '../error/index.mjs';
import { wrongOption } from './options.mjs';

const EXPECTED = 'a path, a file: URL, bytes (Buffer, Uint8Array, ArrayBuffer) or a loaded model';

/** A view of the same bytes, or undefined when the value holds none, or none any more (a transferred buffer). */
export function bytesOf(value) {
  try {
    if (ArrayBuffer.isView(value)) return new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
    if (value instanceof ArrayBuffer || value instanceof SharedArrayBuffer) return new Uint8Array(value);
  } catch {
    return undefined;
  }
  return undefined;
}

function copied(native, bytes, maxBytes) {
  try {
    return new native.Bytes(bytes, maxBytes);
  } catch (error) {
    throw fromNative(error);
  }
}

function pathOf(url) {
  try {
    return fileURLToPath(url);
  } catch {
    throw wrongOption('source', EXPECTED, String(url));
  }
}

/**
 * What native load() takes. Bytes are copied here and now: the caller may write to them as soon as the call returns.
 * @param {object} native the addon's exports
 * @param {string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer} source a path is relative to the current folder
 * @param {number} maxBytes
 * @returns {string | object} absolute path, or native bytes
 * @throws {TelarError} E_OPTION, L_FILE_BYTES
 */
export function readSource(native, source, maxBytes) {
  const bytes = bytesOf(source);
  if (bytes) return copied(native, bytes, maxBytes);
  const isUrl = source instanceof URL || (typeof source === 'string' && source.startsWith('file:'));
  const file = isUrl ? pathOf(source) : source;
  if (typeof file !== 'string' || file === '' || file.includes('\0')) throw wrongOption('source', EXPECTED, source);
  return path.resolve(file);
}

const environmentOf = (shot) => (bytesOf(shot.environment) ? shot.environment : shot.environment?.map);

/**
 * The caller's shot as it is now, with the bytes of its environment copied: later writes to either change nothing.
 * @param {object} native
 * @param {object} shot
 * @param {number} maxBytes
 * @returns {{shot: object, environment?: object, map?: Uint8Array}} `shot` with empty bytes in place of the environment's,
 *   `environment` their native copy, `map` the caller's own
 * @throws {TelarError} E_SHOT, L_FILE_BYTES
 */
export function readShot(native, shot, maxBytes) {
  if (typeof shot !== 'object' || shot === null) throw new TelarError('E_SHOT', 'shot: expected an object', { pointer: '' });
  const map = bytesOf(environmentOf(shot));
  const light = map ? { ...shot, environment: withoutBytes(shot.environment) } : shot;
  try {
    return { shot: structuredClone(light), ...(map && { environment: copied(native, map, maxBytes), map }) };
  } catch (error) {
    if (error instanceof TelarError) throw error;
    throw new TelarError('E_SHOT', `shot: expected plain data as in JSON (${error.message})`, { pointer: '' });
  }
}

const withoutBytes = (environment) => (bytesOf(environment) ? new Uint8Array(0) : { ...environment, map: new Uint8Array(0) });
