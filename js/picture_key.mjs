import { keyOptions } from './api/options.mjs';
import { keyOfSource } from './api/picture_key.mjs';
import { readShot, readSource } from './api/source.mjs';
import { loadNative } from './native.mjs';
import { versions } from './versions.mjs';

/**
 * The key that a picture will have as `info.key`, without drawing it or decoding the model.
 * @param {string | URL | Uint8Array | ArrayBuffer} source - Path, file: URL or bytes.
 * @param {object} [shot]
 * @param {object} [options]
 * @param {Record<string, number>} [options.limits] - By the L_* names.
 * @param {(uri: string) => unknown} [options.resolve] - As createRenderer has it.
 * @param {AbortSignal} [options.signal]
 * @returns {Promise<string>} 64 hex digits
 * @throws {TelarError} E_OPTION, E_SHOT; E_FILE, E_NOT_GLTF, E_JSON, ... for a file that is no glTF document
 */
export async function pictureKey(source, shot = {}, options = {}) {
  const native = loadNative();
  const { limits, resolve, signal } = keyOptions(options, Object.keys(native.limits));
  const maxBytes = limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
  const request = { input: readSource(native, source, maxBytes), ...readShot(native, shot, maxBytes) };
  return keyOfSource(native, request, { version: versions.telar, limits, resolve, signal });
}
