import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { writeFileAtomically } from '../api/atomic_file.mjs';
import { sha256 } from '../api/sha256.mjs';

/**
 * Which pictures are as they would be drawn again. A file in each output folder keeps the key of every picture, the --fail-on that it was drawn with, and the
 * digest of the picture's own file: one that was edited, cut or replaced is drawn again.
 */

/** In each output folder. */
export const KEYS_FILE = '.telar-keys.json';

const VERSION = 1;

const isEntry = (entry) => typeof entry?.key === 'string' && typeof entry.sha256 === 'string';

/** Entries by file name; none where the file is absent or damaged: the pictures are drawn then. */
async function readEntries(folder) {
  try {
    const { version, pictures } = JSON.parse(await readFile(path.join(folder, KEYS_FILE), 'utf8'));
    return version === VERSION ? new Map(Object.entries(pictures).filter(([, entry]) => isEntry(entry))) : new Map();
  } catch {
    return new Map();
  }
}

export class KnownPictures {
  #folders = new Map();
  #drawn = new Map();
  #failOn;

  /** @param {string} failOn - Value of --fail-on: a picture that was drawn in spite of a fault is not what a run wants that refuses faults. */
  constructor(failOn) {
    this.#failOn = failOn;
  }

  #entriesOf(folder) {
    if (!this.#folders.has(folder)) this.#folders.set(folder, readEntries(folder));
    return this.#folders.get(folder);
  }

  /**
   * @param {string} file of the picture
   * @param {string} key that it would have
   * @returns {Promise<boolean>} whether the file is that picture
   */
  async has(file, key) {
    const entry = (await this.#entriesOf(path.dirname(file))).get(path.basename(file));
    if (entry?.key !== key || entry.failOn !== this.#failOn) return false;
    const bytes = await readFile(file).catch(() => undefined);
    return bytes !== undefined && sha256(bytes) === entry.sha256;
  }

  /** Notes a picture that was written. */
  add(file, key, data) {
    const folder = path.dirname(file);
    if (!this.#drawn.has(folder)) this.#drawn.set(folder, new Map());
    this.#drawn.get(folder).set(path.basename(file), { key, failOn: this.#failOn, sha256: sha256(data) });
  }

  /** Writes what was noted, beside what other runs have written meanwhile. @throws {TelarError} X_OUTPUT */
  async save() {
    for (const [folder, drawn] of this.#drawn) {
      const pictures = new Map([...(await readEntries(folder)), ...drawn]);
      const sorted = Object.fromEntries([...pictures].sort(([a], [b]) => (a < b ? -1 : 1)));
      await writeFileAtomically(path.join(folder, KEYS_FILE), Buffer.from(`${JSON.stringify({ version: VERSION, pictures: sorted }, null, 1)}\n`));
    }
    this.#drawn.clear();
  }
}
