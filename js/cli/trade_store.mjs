import { createHash } from 'node:crypto';
import { appendFile, mkdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { writeFileAtomically } from '../api/atomic_file.mjs';

/** What a bench has measured, in a folder: one line of JSON a measurement, and the truths as raw RGBA. A run that was stopped goes on from there. */
export class TradeStore {
  #folder;
  #version;
  #rows = new Map();

  /** @param {string} folder @param {string} version of telar: other versions draw otherwise */
  constructor(folder, version) {
    this.#folder = folder;
    this.#version = version;
  }

  get #lines() {
    return path.join(this.#folder, 'measured.jsonl');
  }

  /** Reads what is there. A last line that was cut by the end of a process is left out. */
  async open() {
    await mkdir(path.join(this.#folder, 'truth'), { recursive: true });
    const text = await readFile(this.#lines, 'utf8').catch(() => '');
    for (const line of text.split('\n')) {
      try {
        const { key, ...row } = JSON.parse(line);
        this.#rows.set(key, row);
      } catch {
        // Measured again.
      }
    }
    if (text !== '' && !text.endsWith('\n')) await appendFile(this.#lines, '\n');
  }

  keyOf(parts) {
    return createHash('sha256')
      .update(JSON.stringify([this.#version, parts]))
      .digest('hex');
  }

  /** All that is kept. */
  rows() {
    return [...this.#rows.values()];
  }

  row(key) {
    return this.#rows.get(key);
  }

  async keep(key, row) {
    this.#rows.set(key, row);
    await appendFile(this.#lines, `${JSON.stringify({ key, ...row })}\n`);
  }

  #truthFile(key) {
    return path.join(this.#folder, 'truth', `${key}.rgba`);
  }

  truth(key) {
    return readFile(this.#truthFile(key)).catch(() => undefined);
  }

  keepTruth(key, data) {
    return writeFileAtomically(this.#truthFile(key), data);
  }
}
