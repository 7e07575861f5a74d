import { open } from 'node:fs/promises';
import path from 'node:path';
import { nativeCall } from '../api/native_call.mjs';
import { callOptions, fileOptions } from '../api/options.mjs';
import { readSource } from '../api/source.mjs';
import { TelarError } from '../error/index.mjs';
import { loadNative } from '../api/native.mjs';
import { checkImage } from './image.mjs';

/** Image files in and out, through the same decoders that read textures. */

/**
 * The bytes of a file that is no larger than L_FILE_BYTES.
 * @internal
 * @param {string} file
 * @param {{limits?: Record<string, number>, signal?: AbortSignal}} [options]
 * @returns {Promise<Buffer>}
 * @throws {TelarError} E_FILE, L_FILE_BYTES
 */
export async function readFileBytes(file, { limits = {}, signal } = {}) {
  const maxBytes = limits.L_FILE_BYTES ?? loadNative().limits.L_FILE_BYTES;
  try {
    const handle = await open(file);
    try {
      const { size } = await handle.stat();
      if (size <= maxBytes) return await handle.readFile({ signal });
      throw new TelarError('L_FILE_BYTES', `the file has ${size} bytes, more than the limit of ${maxBytes}`, {
        limit: { name: 'L_FILE_BYTES', max: maxBytes, actual: size },
      });
    } finally {
      await handle.close();
    }
  } catch (cause) {
    signal?.throwIfAborted();
    if (cause instanceof TelarError) throw cause;
    throw new TelarError('E_FILE', `${path.basename(file)} cannot be read (${cause.code ?? cause.message})`, { cause });
  }
}

/**
 * Decodes a PNG, JPEG or WebP, told apart by its bytes. Embedded colour profiles are not applied; EXIF orientation is, but
 * in WebP.
 * @param {string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer} source path, file: URL or bytes
 * @param {{limits?: Record<string, number>, signal?: AbortSignal}} [options]
 * @returns {Promise<import('./image.mjs').Image>}
 * @throws {TelarError} E_OPTION, E_FILE, E_IMAGE_FORMAT, E_IMAGE_CORRUPT, L_FILE_BYTES, L_IMAGE_*
 */
export async function readImage(source, options = {}) {
  const native = loadNative();
  const { limits, signal } = fileOptions(options, Object.keys(native.limits));
  const maxBytes = limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
  const given = readSource(native, source, maxBytes);
  const bytes = typeof given === 'string' ? readSource(native, await readFileBytes(given, { limits, signal }), maxBytes) : given;
  return nativeCall(native, { signal }, (token) => native.decodeImage(bytes, limits, token));
}

/**
 * @param {import('./image.mjs').Image} image
 * @param {{signal?: AbortSignal}} [options]
 * @returns {Promise<Buffer>} a PNG file
 * @throws {TelarError} E_OPTION
 */
export async function encodePng(image, options = {}) {
  checkImage('image', image);
  const { signal } = callOptions(options);
  const native = loadNative();
  const { width, height, data } = image;
  const bytes = readSource(native, data, data.byteLength);
  return nativeCall(native, { signal }, (token) => native.encodePng(bytes, width, height, token));
}
