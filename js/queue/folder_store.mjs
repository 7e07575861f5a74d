import { chmod, readFile, readdir, rm, stat } from 'node:fs/promises';
import path from 'node:path';
import { sweepStale, writeFileAtomically } from '../api/atomic_file.mjs';
import { makeFolder } from '../api/make_folder.mjs';
import { TelarError } from '../error/index.mjs';

/** How old something has to be, beyond its time, to be swept: clocks of machines differ. */
const LEEWAY_MS = 3_600_000;

/**
 * Bytes of jobs, apart from what is known about them.
 * @typedef {object} Store
 * @property {(ref: string, data: Uint8Array, ms: number) => Promise<void>} put whole or not at all; kept for at least so long
 * @property {(ref: string) => Promise<Buffer | undefined>} get
 * @property {(refs: string[]) => Promise<void>} drop
 * @property {(ms: number) => Promise<void>} sweep removes what is older
 */

/**
 * Bytes as files of a folder.
 * @implements {Store}
 */
export class FolderStore {
  #folder;

  /** @throws {TelarError} X_QUEUE */
  static async open(folder) {
    const store = new FolderStore(folder);
    try {
      makeFolder(folder, 0o700);
      await chmod(folder, 0o700).catch(() => {}); // another user's shared volume has its own
    } catch (cause) {
      throw new TelarError('X_QUEUE', `the folder of the queue cannot be made (${cause.code})`, { cause });
    }
    return store;
  }

  constructor(folder) {
    this.#folder = folder;
  }

  async put(ref, data) {
    try {
      await writeFileAtomically(path.join(this.#folder, ref), data);
    } catch (error) {
      // A disk that is full now may have room for the next try.
      const { cause = error } = error;
      throw new TelarError('X_QUEUE', `a file of the queue cannot be written (${cause.code ?? cause.message})`, { cause });
    }
  }

  async get(ref) {
    try {
      return await readFile(path.join(this.#folder, ref));
    } catch (cause) {
      if (cause.code === 'ENOENT') return undefined;
      throw new TelarError('X_QUEUE', `a file of the queue cannot be read (${cause.code})`, { cause });
    }
  }

  async drop(refs) {
    await Promise.all(refs.map((ref) => rm(path.join(this.#folder, ref), { force: true })));
  }

  async sweep(ms) {
    await sweepStale(this.#folder);
    for (const name of await readdir(this.#folder).catch(() => [])) {
      const { mtimeMs = Infinity } = await stat(path.join(this.#folder, name)).catch(() => ({}));
      if (Date.now() - mtimeMs > ms + LEEWAY_MS) await this.drop([name]);
    }
  }
}
