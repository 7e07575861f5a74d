import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { wrongOption } from './options.mjs';
import { bytesOf } from './source.mjs';

/**
 * Runs a native call that may ask for the files that a model names.
 * @param {object} native the addon's exports
 * @param {{resolve?: Function, signal?: AbortSignal}} options without resolve, nothing is asked
 * @param {(parts: object | undefined) => Promise<T>} use makes the native call with these parts
 * @returns {Promise<T>}
 * @throws {TelarError} X_RESOLVE, E_OPTION
 * @template T
 */
export async function withParts(native, { resolve, signal }, use) {
  if (!resolve) return use(undefined);
  const parts = new Parts(native, resolve, signal);
  try {
    return await use(parts.native);
  } catch (error) {
    throw parts.errorOf(error);
  } finally {
    parts.close();
  }
}

/**
 * What the caller's `resolve` gave for a file that is there.
 * @returns {Uint8Array}
 * @throws {TelarError} E_OPTION where it is no bytes
 */
export function partBytes(given, uri) {
  const bytes = bytesOf(given);
  if (!bytes) throw wrongOption('options.resolve', `bytes (Buffer, Uint8Array, ArrayBuffer) or null for ${shown(uri)}`, given);
  return bytes;
}

/**
 * The files that a model names, as a caller hands them over: native code asks for one after the other while it loads, on a
 * thread that waits, and takes a copy of what it is given.
 */
class Parts {
  #resolve;
  #signal;
  #native;
  #failure;

  /**
   * @param {object} native the addon's exports
   * @param {(uri: string, options: {signal?: AbortSignal}) => unknown} resolve bytes, or a promise of them; null for what is not there
   * @param {AbortSignal} [signal]
   */
  constructor(native, resolve, signal) {
    this.#resolve = resolve;
    this.#signal = signal;
    this.#native = new native.Parts((id, uri) => void this.#answer(id, uri));
  }

  /** What native load() takes. */
  get native() {
    return this.#native;
  }

  /** Nothing is asked any more. */
  close() {
    this.#native.close();
  }

  /** What load() rejected with: the failure of `resolve` where that was the cause. */
  errorOf(error) {
    if (error?.code !== 'X_RESOLVE' || !this.#failure) return error;
    const { uri, cause } = this.#failure;
    if (cause instanceof TelarError && cause.code === 'E_OPTION') return cause;
    return new TelarError('X_RESOLVE', `options.resolve failed for ${shown(uri)}; its error is the cause of this one`, { pointer: error.pointer, cause });
  }

  async #answer(id, uri) {
    try {
      const given = await this.#resolve(uri, { signal: this.#signal });
      this.#native.answer(id, given === null || given === undefined ? undefined : partBytes(given, uri));
    } catch (cause) {
      this.#failure ??= { uri, cause };
      this.#native.fail(id);
    }
  }
}
