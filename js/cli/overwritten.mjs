import { realpath, stat } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { isNamedEnvironment } from '../shot/table/environments.mjs';
import { partOver } from './model_parts.mjs';

/** What a command reads is not what it writes, and two things that it writes are not one file. */

/**
 * @typedef {object} Named a file of a command line
 * @property {string | undefined} file path; - is a stream, and undefined none
 * @property {string} what it is: "the shot", "--heatmap"
 */

/**
 * The file that a name leads to, by links too; of one that is not there yet, its name in the folder that is. Files are replaced and not written in
 * (js/api/atomic_file.mjs): what a hard link of them names stays.
 */
async function placeOf(file) {
  try {
    return { place: await realpath(file), isThere: true };
  } catch {
    const whole = path.resolve(file);
    const folder = path.dirname(whole);
    return { place: folder === whole ? whole : path.join((await placeOf(folder)).place, path.basename(whole)), isThere: false };
  }
}

/** Devices and pipes keep nothing that could be lost. */
const keepsBytes = (place) =>
  stat(place).then(
    (found) => found.isFile() || found.isDirectory(),
    () => true,
  );

const isFile = ({ file }) => file !== undefined && file !== '-';

const placed = (named) => Promise.all(named.filter(isFile).map(async (one) => ({ ...one, ...(await placeOf(one.file)) })));

const usage = (message) => new TelarError('E_USAGE', message);

/**
 * To be called before anything is drawn or written.
 * @param {object} files
 * @param {Named[]} [files.inputs]
 * @param {string[]} [files.models] their parts count too; - is stdin
 * @param {Named[]} files.outputs
 * @param {number} files.maxBytes of a model
 * @throws {TelarError} E_USAGE
 */
export async function refuseOverwriting({ inputs = [], models = [], outputs, maxBytes }) {
  const written = new Map();
  for (const output of await placed(outputs)) {
    const other = written.get(output.place);
    if (other && (await keepsBytes(output.place)))
      throw usage(`${other.what} and ${output.what} would both be written to ${shown(output.file)}: name two files`);
    written.set(output.place, output);
  }
  if (written.size === 0) return;
  // Thousands of pictures may have one environment.
  const read = [...new Map(inputs.map((input) => [input.file, input])).values()];
  for (const { file, what, place } of await placed(read)) {
    const output = written.get(place);
    if (output && (await keepsBytes(place))) throw usage(`${output.what} would overwrite ${what} ${shown(file)}: name another file`);
  }
  // What is not there yet is no part of a model.
  const there = [...written.values()].filter(({ isThere }) => isThere).map(({ place }) => place);
  const over = await partOver(models, new Set(there), maxBytes);
  if (over === undefined) return;
  const { model, part, isModel } = over;
  if (isModel) throw usage(`${written.get(part).what} would overwrite the model ${shown(model)}`);
  throw usage(`${shown(path.basename(part))} would be overwritten, a part of the model ${shown(model)}: name another folder`);
}

/** The file of a shot's environment. @param {object} [shot] not resolved @returns {Named} */
export function environmentOf({ environment } = {}) {
  const map = environment?.map ?? environment;
  return { file: typeof map === 'string' && !isNamedEnvironment(map) ? map : undefined, what: 'the environment' };
}
