import { readdir, stat } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** The models that a command line names: files, folders, standard input. */

const MODEL = /\.(glb|gltf)$/i;
const ADDRESS = /^(?!file:)[a-z][a-z\d+.-]*:\/\//i;
const PATTERN = /[*?[{]/;

const usage = (message) => new TelarError('E_USAGE', message);

/** Paths of the models beneath a folder, in order; hidden ones and links to folders are left out. */
async function modelsBeneath(folder) {
  const found = [];
  for (const entry of await readdir(folder, { withFileTypes: true })) {
    if (entry.name.startsWith('.')) continue;
    const file = path.join(folder, entry.name);
    if (entry.isDirectory()) found.push(...(await modelsBeneath(file)));
    else if (MODEL.test(entry.name)) found.push(file);
  }
  return found.sort();
}

async function beneath(folder) {
  let files;
  try {
    files = await modelsBeneath(folder);
  } catch (cause) {
    throw new TelarError('E_FILE', `the folder ${shown(folder)} cannot be read (${cause.code}); check its permissions`, { cause });
  }
  if (files.length === 0) throw usage(`the folder ${shown(folder)} holds no .glb or .gltf file`);
  return files.map((model) => ({ model, folder: path.relative(folder, path.dirname(model)) }));
}

/**
 * Tells what to do about a model that is no file: an address, a pattern that the shell left as it is.
 * @param {string} given path, or - for stdin
 * @returns {Promise<import('node:fs').Stats | undefined>} undefined where there is none: reading it will tell
 * @throws {TelarError} E_USAGE
 */
export async function checkModel(given) {
  if (given === '-') return undefined;
  if (ADDRESS.test(given)) {
    throw usage(
      `${shown(given)} is an address, and telar fetches nothing: copy the file to this machine, or hand it over as in \`curl -fsS ADDRESS | telar thumbnail - -o OUT\``,
    );
  }
  const found = await stat(given).catch(() => undefined);
  if (!found && PATTERN.test(given)) {
    throw usage(`no file is called ${shown(given)}, and telar expands no patterns: write it without quotes, so that the shell does, or name a folder with -r`);
  }
  return found;
}

/**
 * @param {string[]} given paths of models and folders, or - for stdin
 * @param {{recursive?: boolean}} options recursive: folders stand for the models beneath them
 * @returns {Promise<Array<{model: string, folder: string}>>} folder: path of the model's folder beneath the one that was
 *   given; empty for a model that was given itself
 * @throws {TelarError} E_USAGE, E_FILE
 */
export async function findModels(given, { recursive = false } = {}) {
  const found = [];
  for (const model of given) {
    const isFolder = (await checkModel(model))?.isDirectory();
    if (isFolder && !recursive) throw usage(`${shown(model)} is a folder; -r draws every .glb and .gltf file beneath it`);
    found.push(...(isFolder ? await beneath(model) : [{ model, folder: '' }]));
  }
  return found;
}
