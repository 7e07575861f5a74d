import { readdir, stat } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { maxFileBytes } from './limits.mjs';
import { readAll } from './streams.mjs';

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

/** A file: URL as the path that it means: names of pictures and checks of folders go by paths. */
function asPath(given) {
  if (!/^file:/i.test(given)) return given;
  try {
    return fileURLToPath(given);
  } catch {
    throw usage(`${shown(given)} means no file of this machine: give its path`);
  }
}

/**
 * Tells what to do about a model that is no file: an address, a pattern that the shell left as it is.
 * @param {string} given path or file: URL, or - for stdin
 * @returns {Promise<{model: string, isFolder: boolean}>} model: its path, or -. One that is not there is told when it is read
 * @throws {TelarError} E_USAGE
 */
export async function checkModel(given) {
  if (given === '-') return { model: given, isFolder: false };
  if (ADDRESS.test(given)) {
    throw usage(
      `${shown(given)} is an address, and telar fetches nothing: copy the file to this machine, or hand it over as in \`curl -fsS ADDRESS | telar thumbnail - -o OUT\``,
    );
  }
  const model = asPath(given);
  const found = await stat(model).catch(() => undefined);
  if (!found && PATTERN.test(given)) {
    throw usage(`no file is called ${shown(given)}, and telar expands no patterns: write it without quotes, so that the shell does, or name a folder with -r`);
  }
  return { model, isFolder: found?.isDirectory() ?? false };
}

/**
 * What the API takes of a model: its path, or the bytes of stdin.
 * @param {string} model of checkModel
 * @param {object} limits of readLimits
 * @param {{stdin: AsyncIterable<Buffer>, signal?: AbortSignal}} io
 * @returns {Promise<string | Buffer>}
 * @throws {TelarError} L_FILE_BYTES
 */
export const readModel = async (model, limits, { stdin, signal }) => (model === '-' ? readAll(stdin, maxFileBytes(limits), signal) : model);

/**
 * @param {string[]} given paths or file: URLs of models and folders, or - for stdin
 * @param {{recursive?: boolean}} options recursive: folders stand for the models beneath them
 * @returns {Promise<Array<{model: string, folder: string}>>} folder: path of the model's folder beneath the one that was
 *   given; empty for a model that was given itself
 * @throws {TelarError} E_USAGE, E_FILE
 */
export async function findModels(given, { recursive = false } = {}) {
  const found = [];
  for (const each of given) {
    const { model, isFolder } = await checkModel(each);
    if (isFolder && !recursive) throw usage(`${shown(model)} is a folder; -r draws every .glb and .gltf file beneath it`);
    found.push(...(isFolder ? await beneath(model) : [{ model, folder: '' }]));
  }
  return found;
}
