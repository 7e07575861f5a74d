import { constants } from 'node:fs';
import { open, stat } from 'node:fs/promises';
import { digestOf } from '../api/digest.mjs';
import { TelarError } from '../error/index.mjs';

/** A file may end so many workers in a row before it is refused. */
const CRASHES = 2;
/** Files that are remembered; the one that ended a worker longest ago goes first. */
const MOST = 1024;

/** @typedef {{path: string} | {bytes: Uint8Array}} Input a file of a job */

/** @param {Input} input @returns {Promise<Uint8Array | undefined>} undefined where there are none any more */
async function bytesOf({ path, bytes }) {
  if (bytes) return bytes;
  let file;
  try {
    // A pipe is not waited for.
    file = await open(path, constants.O_RDONLY | constants.O_NONBLOCK);
    const facts = await file.stat();
    return facts.isFile() ? await file.readFile() : undefined;
  } catch {
    return undefined;
  } finally {
    await file?.close();
  }
}

/** Without reading it. @param {Input} input @returns {Promise<number | undefined>} */
async function sizeOf({ path, bytes }) {
  if (bytes) return bytes.byteLength;
  const facts = await stat(path).catch(() => undefined);
  return facts?.isFile() ? facts.size : undefined;
}

/** Sum of bytes; undefined where one of them is. */
const sum = (sizes) => (sizes.includes(undefined) ? undefined : sizes.reduce((all, size) => all + size, 0));

/**
 * Digest of the files of a job: of one, its own.
 * @param {Input[]} inputs
 * @returns {Promise<{digest: string, bytes: number} | undefined>} undefined where one is not there any more
 */
async function digestOfAll(inputs) {
  const files = await Promise.all(inputs.map((input) => bytesOf(input)));
  if (files.includes(undefined)) return undefined;
  const digests = await Promise.all(files.map((bytes) => digestOf(bytes)));
  return { digest: digests.length === 1 ? digests[0] : await digestOf(Buffer.from(digests.join())), bytes: sum(files.map(({ byteLength }) => byteLength)) };
}

/** All files of a job together, and each alone: what is known of one holds wherever it is. @param {Input[]} inputs */
const groupsOf = (inputs) => (inputs.length > 1 ? [inputs, ...inputs.map((input) => [input])] : [inputs]);

/**
 * Remembers which files ended workers, and refuses those that did it twice in a row. Of a job that has several (an environment, fonts, a second picture)
 * any may have done it: they are remembered together. Nothing is hashed while there is none.
 */
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
   * @param {Input[]} inputs
   * @returns {Promise<string | undefined>} their digest
   */
  async record(inputs) {
    const all = await digestOfAll(inputs);
    if (!all) return undefined;
    const { digest, bytes } = all;
    this.#forgetOld();
    const crashes = (this.#files.get(digest)?.crashes ?? 0) + 1;
    this.#files.delete(digest);
    if (this.#ms > 0) this.#files.set(digest, { bytes, crashes, last: this.#now() });
    if (this.#files.size > MOST) this.#files.delete(this.#files.keys().next().value);
    return digest;
  }

  /** A worker drew this: what ended one before was not the file, but whoever ends processes of this machine. */
  async clear(inputs) {
    for (const group of groupsOf(inputs)) this.#files.delete(await this.#digestOf(group, 1));
  }

  /** @throws {TelarError} X_QUARANTINE */
  async check(inputs) {
    for (const group of groupsOf(inputs)) await this.#checkGroup(group);
  }

  async #checkGroup(inputs) {
    const digest = await this.#digestOf(inputs, CRASHES);
    if (!((this.#files.get(digest)?.crashes ?? 0) >= CRASHES)) return;
    throw new TelarError('X_QUARANTINE', `the ${inputs.length > 1 ? 'files of this job' : 'file'} ended ${CRASHES} workers of this pool: refused; report it`, {
      input: digest,
    });
  }

  /** The digest of what has as many bytes as files that ended so many workers; undefined of others, which are not read. */
  async #digestOf(inputs, crashes) {
    if (this.#files.size === 0) return undefined;
    this.#forgetOld();
    const size = sum(await Promise.all(inputs.map((input) => sizeOf(input))));
    if (![...this.#files.values()].some((file) => file.crashes >= crashes && file.bytes === size)) return undefined;
    return (await digestOfAll(inputs))?.digest;
  }

  #forgetOld() {
    for (const [digest, { last }] of this.#files) if (this.#now() - last >= this.#ms) this.#files.delete(digest);
  }
}
