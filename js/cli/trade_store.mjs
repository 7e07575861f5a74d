import { createHash } from 'node:crypto';
import { appendFile, readFile } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { makeOutputFolder, unwritable, writeFileAtomically } from '../api/atomic_file.mjs';

/** A file of an earlier run; undefined where there is none. @throws {TelarError} E_FILE */
async function kept(file, encoding) {
  try {
    return await readFile(file, encoding);
  } catch (cause) {
    if (cause.code === 'ENOENT') return undefined;
    throw new TelarError('E_FILE', `${shown(file)} of an earlier run cannot be read (${cause.code}): name another folder, or move it away`, { cause });
  }
}

/** @throws {TelarError} X_OUTPUT */
async function append(file, text) {
  try {
    await appendFile(file, text);
  } catch (cause) {
    throw unwritable(file, cause);
  }
}

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

  /**
   * Makes the folder, and reads what is there. A last line that was cut by the end of a process is left out.
   * @throws {TelarError} X_OUTPUT, E_FILE
   */
  async open() {
    await makeOutputFolder(path.join(this.#folder, 'truth'));
    const text = (await kept(this.#lines, 'utf8')) ?? '';
    for (const line of text.split('\n')) {
      try {
        const { key, ...row } = JSON.parse(line);
        this.#rows.set(key, row);
      } catch {
        // Measured again.
      }
    }
    if (text !== '' && !text.endsWith('\n')) await append(this.#lines, '\n');
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
    await append(this.#lines, `${JSON.stringify({ key, ...row })}\n`);
  }

  #truthFile(key) {
    return path.join(this.#folder, 'truth', `${key}.rgba`);
  }

  truth(key) {
    return kept(this.#truthFile(key));
  }

  keepTruth(key, data) {
    return writeFileAtomically(this.#truthFile(key), data);
  }
}
