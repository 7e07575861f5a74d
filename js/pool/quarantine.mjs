import { constants } from 'node:fs';
import { open } from 'node:fs/promises';
import { digestOf } from '../api/digest.mjs';
import { TelarError } from '../error/index.mjs';

/** A file may end so many workers in a row before it is refused. */
const CRASHES = 2;
/** Files that are remembered; the one that ended a worker longest ago goes first. */
const MOST = 1024;

/**
 * The bytes of a job's model.
 * @param {{path: string} | {bytes: Uint8Array}} input
 * @returns {Promise<Uint8Array | undefined>} undefined where there are none any more
 */
async function bytesOf({ path, bytes }, size) {
  if (bytes) return bytes;
  let file;
  try {
    // A pipe is not waited for.
    file = await open(path, constants.O_RDONLY | constants.O_NONBLOCK);
    const facts = await file.stat();
    if (!facts.isFile() || (size && !size(facts.size))) return undefined;
    return await file.readFile();
  } catch {
    return undefined;
  } finally {
    await file?.close();
  }
}

/** Remembers which files ended workers, and refuses those that did it twice in a row. Nothing is hashed while there is none. */
export class Quarantine {
  #ms;
  #now;
  /** By digest: {bytes, crashes, last}. */
  #files = new Map();

  /**
   * @param {number} ms for which a file is remembered after it ended a worker; 0 = not at all
   * @param {() => number} [now] milliseconds
   */
  constructor(ms, now = Date.now) {
    this.#ms = ms;
    this.#now = now;
  }

  /**
   * A worker ended while it drew this.
   * @param {{path: string} | {bytes: Uint8Array}} input
   * @returns {Promise<string | undefined>} its digest
   */
  async record(input) {
    const bytes = await bytesOf(input);
    if (!bytes) return undefined;
    const digest = await digestOf(bytes);
    this.#forgetOld();
    const crashes = (this.#files.get(digest)?.crashes ?? 0) + 1;
    this.#files.delete(digest);
    if (this.#ms > 0) this.#files.set(digest, { bytes: bytes.byteLength, crashes, last: this.#now() });
    if (this.#files.size > MOST) this.#files.delete(this.#files.keys().next().value);
    return digest;
  }

  /** A worker drew this: what ended one before was not the file, but whoever ends processes of this machine. */
  async clear(input) {
    this.#files.delete(await this.#digestOf(input, 1));
  }

  /** @throws {TelarError} X_QUARANTINE */
  async check(input) {
    const digest = await this.#digestOf(input, CRASHES);
    if (!((this.#files.get(digest)?.crashes ?? 0) >= CRASHES)) return;
    throw new TelarError('X_QUARANTINE', `the file ended ${CRASHES} workers of this pool, and is refused; report it`, { input: digest });
  }

  /** The digest of what has as many bytes as a file that ended so many workers; undefined of others, which are not read. */
  async #digestOf(input, crashes) {
    if (this.#files.size === 0) return undefined;
    this.#forgetOld();
    const isOne = (size) => [...this.#files.values()].some((file) => file.crashes >= crashes && file.bytes === size);
    if (input.bytes && !isOne(input.bytes.byteLength)) return undefined;
    const bytes = await bytesOf(input, isOne);
    return bytes && digestOf(bytes);
  }

  #forgetOld() {
    for (const [digest, { last }] of this.#files) if (this.#now() - last >= this.#ms) this.#files.delete(digest);
  }
}
