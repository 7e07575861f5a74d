import { isObject, wrongOption } from '../api/option_check.mjs';
import { ResultAddresses } from './result_addresses.mjs';
import { ResultFolder } from './result_folder.mjs';
import { packResult, unpackResult } from './stored_result.mjs';

/**
 * Results by their content key, so that nothing is drawn twice. A store that fails costs time, and no answer: it is counted.
 * @typedef {object} Place
 * @property {(name: string, signal: AbortSignal) => Promise<Buffer | undefined>} get
 * @property {(name: string, bytes: Buffer) => Promise<void>} put whole or not at all
 * @property {(name: string) => Promise<void>} drop
 */

const isFunctionOr = (value) => value === undefined || typeof value === 'function';

/** The option `store`: a folder, or callbacks that give addresses. @throws {import('../error/index.mjs').TelarError} E_OPTION */
export function storeOption(given) {
  if (given === undefined || (typeof given === 'string' && given !== '')) return given;
  if (isObject(given) && isFunctionOr(given.get) && isFunctionOr(given.put) && (given.get || given.put)) return given;
  throw wrongOption('options.store', 'a folder, or {get, put} that give addresses', given);
}

/** Writings at once; what is drawn meanwhile is not stored. */
const MOST_WRITING = 16;

export class ResultStore {
  #place;
  #count;
  #writing = new Set();

  /**
   * @param {string | object | undefined} store as of the options
   * @param {number} maxBytes of a folder; of one result at an address
   * @param {(outcome: 'hit' | 'miss' | 'damaged' | 'stored' | 'skipped' | 'failed', error?: Error) => void} count
   * @throws {import('../error/index.mjs').TelarError} E_OPTION
   */
  static async open(store, maxBytes, count) {
    if (store === undefined) return undefined;
    return new ResultStore(typeof store === 'string' ? await ResultFolder.open(store, maxBytes) : new ResultAddresses(store, maxBytes), count);
  }

  /** @param {Place} place */
  constructor(place, count) {
    this.#place = place;
    this.#count = count;
  }

  /** @param {string} key @param {AbortSignal} signal @returns {Promise<import('./perform.mjs').Result | undefined>} */
  async get(key, signal) {
    try {
      const bytes = await this.#place.get(key, signal);
      const result = bytes && unpackResult(bytes, key);
      this.#count(result ? 'hit' : bytes ? 'damaged' : 'miss');
      if (bytes && !result) await this.#place.drop(key);
      return result;
    } catch (error) {
      signal.throwIfAborted();
      this.#count('failed', error);
      return undefined;
    }
  }

  /** Begins to write; the answer does not wait for it. @param {import('./perform.mjs').Result} result with a key */
  put(result) {
    if (this.#writing.size >= MOST_WRITING) return this.#count('skipped');
    const writing = this.#write(result).finally(() => this.#writing.delete(writing));
    this.#writing.add(writing);
  }

  async #write(result) {
    try {
      await this.#place.put(result.key, packResult(result));
      this.#count('stored');
    } catch (error) {
      this.#count('failed', error);
    }
  }

  /** Resolves when what is being written is there. */
  async idle() {
    await Promise.all(this.#writing);
  }
}
