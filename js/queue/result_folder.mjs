import { readFile, readdir, rm, stat, utimes } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { sweepStale, writeFileAtomically } from '../api/atomic_file.mjs';
import { makeFolder } from '../api/make_folder.mjs';

const ENDING = '.result';
/** As answerKey() makes them. */
const NAME = /^[0-9a-f]{64}(?:-[a-z\d]+)*\.result$/;
/** After a sweep, so much of the bound is used: it is not swept again for each result. */
const SWEPT = 0.9;

/**
 * Results as files of a folder, written whole or not at all. Beyond its bound the files that were read longest ago go. Several services may share one.
 * @implements {import('./result_store.mjs').Place}
 */
export class ResultFolder {
  #folder;
  #maxBytes;
  #bytes = 0;
  /** By this process, since it looked last. */
  #written = 0;
  #sweeping;

  /** @throws {TelarError} E_OPTION */
  static async open(folder, maxBytes) {
    try {
      makeFolder(folder);
    } catch (cause) {
      throw new TelarError('E_OPTION', `options.store: the folder cannot be made (${cause.code})`, { cause });
    }
    try {
      await readdir(folder);
    } catch (cause) {
      throw new TelarError('E_OPTION', `options.store: the folder cannot be read (${cause.code})`, { cause });
    }
    await sweepStale(folder);
    const place = new ResultFolder(folder, maxBytes);
    // What cannot be removed, as in a folder that is read alone, keeps no service from starting.
    await place.#sweep().catch(() => {});
    return place;
  }

  constructor(folder, maxBytes) {
    this.#folder = folder;
    this.#maxBytes = maxBytes;
  }

  #file(name) {
    return path.join(this.#folder, `${name}${ENDING}`);
  }

  async get(name) {
    try {
      const bytes = await readFile(this.#file(name));
      const now = new Date();
      await utimes(this.#file(name), now, now).catch(() => {});
      return bytes;
    } catch (error) {
      if (error.code === 'ENOENT') return undefined;
      throw error;
    }
  }

  async put(name, bytes) {
    if (bytes.byteLength > this.#maxBytes) return;
    await writeFileAtomically(this.#file(name), bytes);
    this.#written += bytes.byteLength;
    // Others may have written as much.
    if (this.#bytes + this.#written <= this.#maxBytes && this.#written <= (1 - SWEPT) * this.#maxBytes) return;
    this.#sweeping ??= this.#sweep().finally(() => {
      this.#sweeping = undefined;
    });
    await this.#sweeping;
  }

  async drop(name) {
    await rm(this.#file(name), { force: true });
  }

  /** Looks at the folder itself, which others may write to. */
  async #sweep() {
    this.#written = 0;
    const names = (await readdir(this.#folder)).filter((name) => NAME.test(name));
    const found = await Promise.all(
      names.map(async (name) => {
        const { size = 0, mtimeMs = 0 } = await stat(path.join(this.#folder, name)).catch(() => ({}));
        return { name, size, mtimeMs };
      }),
    );
    let bytes = found.reduce((sum, { size }) => sum + size, 0);
    const isOver = bytes > this.#maxBytes;
    for (const { name, size } of found.sort((a, b) => a.mtimeMs - b.mtimeMs)) {
      if (!isOver || bytes <= SWEPT * this.#maxBytes) break;
      await rm(path.join(this.#folder, name), { force: true });
      bytes -= size;
    }
    this.#bytes = bytes;
  }
}
