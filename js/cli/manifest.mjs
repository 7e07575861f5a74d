import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { checkModel } from './models.mjs';
import { withPathsFrom } from './shot_options.mjs';
import { readAll } from './streams.mjs';

/** A list of pictures as JSON lines: {"model": PATH, "shot": {...} or PATH, "output": PATH}. */

const KEYS = ['model', 'shot', 'output'];
const MAX_BYTES = 1 << 26;
const usage = (message) => new TelarError('E_USAGE', message);

async function readText(file, { stdin, signal }) {
  if (file === '-') return (await readAll(stdin, MAX_BYTES, signal)).toString('utf8');
  try {
    return await readFile(file, { encoding: 'utf8', signal });
  } catch (cause) {
    signal?.throwIfAborted();
    throw new TelarError('E_FILE', `--manifest ${shown(file)} cannot be read (${cause.code})`, { cause });
  }
}

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

function parsed(text, where) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw usage(`${where}: not JSON: ${error.message}`);
  }
}

function checkEntry(entry, where) {
  if (!isObject(entry)) throw usage(`${where}: expected an object with "model", got ${shown(entry)}`);
  for (const key of Object.keys(entry)) {
    if (KEYS.includes(key)) continue;
    const near = nearest(key, KEYS);
    throw usage(`${where}: unknown key ${shown(key)}, ${near ? `did you mean ${near}?` : `expected ${KEYS.join(', ')}`}`);
  }
  const { model, shot = {}, output } = entry;
  if (typeof model !== 'string' || model === '' || model === '-') throw usage(`${where}: model: expected a path, got ${shown(model)}`);
  if (!isObject(shot) && typeof shot !== 'string') throw usage(`${where}: shot: expected an object or the path of one, got ${shown(shot)}`);
  if (output !== undefined && (typeof output !== 'string' || output === '' || output === '-'))
    throw usage(`${where}: output: expected a path, got ${shown(output)}`);
}

/** Shots in files of their own, each read once. */
class ShotFiles {
  #shots = new Map();

  async read(file, where) {
    if (!this.#shots.has(file)) this.#shots.set(file, await this.#load(file, where));
    return this.#shots.get(file);
  }

  async #load(file, where) {
    let text;
    try {
      text = await readFile(file, 'utf8');
    } catch (cause) {
      throw new TelarError('E_FILE', `${where}: the shot ${shown(path.basename(file))} cannot be read (${cause.code})`, { cause });
    }
    const shot = parsed(text, `${where}: the shot ${shown(path.basename(file))}`);
    if (!isObject(shot)) throw usage(`${where}: the shot ${shown(path.basename(file))}: expected an object, got ${shown(shot)}`);
    return withPathsFrom(path.dirname(file), shot);
  }
}

/**
 * @param {string} file path, or - for stdin; relative paths in it start at its folder, those of stdin at the current one
 * @param {{stdin: import('node:stream').Readable, signal?: AbortSignal}} io
 * @returns {Promise<Array<{where: string, model: string, folder: string, shot: object, shotFile?: string, output?: string}>>} where: for messages
 * @throws {TelarError} E_USAGE with the line's number, E_FILE
 */
export async function readManifest(file, io) {
  const base = file === '-' ? '.' : path.dirname(file);
  const lines = (await readText(file, io)).replace(/^\ufeff/, '').split('\n');
  const shots = new ShotFiles();
  const entries = [];
  for (const [index, line] of lines.entries()) {
    if (line.trim() === '') continue;
    const where = `--manifest line ${index + 1}`;
    const entry = parsed(line, where);
    checkEntry(entry, where);
    const { model, shot = {}, output } = entry;
    entries.push({
      where,
      folder: '',
      model: await inFolder(base, model, where),
      ...(typeof shot === 'string' && { shotFile: path.join(base, shot) }),
      shot: typeof shot === 'string' ? await shots.read(path.join(base, shot), where) : withPathsFrom(base, shot),
      ...(output !== undefined && { output: path.isAbsolute(output) ? output : path.join(base, output) }),
    });
  }
  if (entries.length === 0) throw usage(`--manifest ${shown(file)} has no lines`);
  return entries;
}

async function inFolder(base, model, where) {
  try {
    const isAsItIs = path.isAbsolute(model) || /^(file:|[a-z][a-z\d+.-]*:\/\/)/i.test(model);
    const { model: file, isFolder } = await checkModel(isAsItIs ? model : path.join(base, model));
    if (isFolder) throw usage(`model: ${shown(model)} is a folder: name its files, one a line`);
    return file;
  } catch (error) {
    throw new TelarError(error.code, `${where}: ${error.message}`, error);
  }
}
