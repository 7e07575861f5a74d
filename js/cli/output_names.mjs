import { statSync } from 'node:fs';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** Where the image of each model goes, and in which format. */

const FORMAT_OF = {
  '.png': 'png', '.jpg': 'jpeg', '.jpeg': 'jpeg', '.webp': 'webp', '.tif': 'tiff', '.tiff': 'tiff', '.exr': 'exr', '.raw': 'raw',
};
const EXTENSION_OF = { png: '.png', jpeg: '.jpg', webp: '.webp', tiff: '.tif', exr: '.exr', raw: '.raw' };
const PATTERN = /\{(name|index)\}/g;

const usage = (message) => new TelarError('E_USAGE', message);

function isFolder(file) {
  if (file.endsWith('/')) return true;
  try {
    return statSync(file).isDirectory();
  } catch {
    return false; // absent or out of reach: writing will tell
  }
}

const nameOf = (model) => (model === '-' ? 'stdin' : path.parse(model).name);

/**
 * @param {string} out of -o: a file, a folder, a pattern with {name} or {index}, or - for stdout
 * @param {string[]} models as given, - for stdin
 * @param {string | undefined} format of the shot, where it names one
 * @returns {{format: string, files: string[]}} files as long as models; "-" for stdout
 * @throws {TelarError} E_USAGE
 */
export function outputNames(out, models, format) {
  if (out === '-') {
    if (models.length > 1) throw usage('-o -: only one image fits on stdout; give a folder, or a pattern such as out/{name}.png');
    return { format: format ?? 'png', files: ['-'] };
  }
  const pattern = patternOf(out, models, format);
  const extension = FORMAT_OF[path.extname(pattern).toLowerCase()];
  if (!extension && format === undefined) {
    throw usage(`-o ${shown(out)}: expected a name that ends in ${Object.keys(FORMAT_OF).join(' ')}, or a shot with output.format`);
  }
  if (extension && format !== undefined && extension !== format) {
    throw usage(`-o ${shown(out)} means ${extension}, but the shot's output.format is ${format}; drop one of them`);
  }
  const files = models.map((model, index) => fill(pattern, nameOf(model), index + 1));
  refuseClashes(files, models);
  return { format: format ?? extension, files };
}

function patternOf(out, models, format) {
  if (out.search(PATTERN) >= 0) return out;
  if (isFolder(out) || (models.length > 1 && path.extname(out) === '')) return path.join(out, `{name}${EXTENSION_OF[format ?? 'png'] ?? ''}`);
  if (models.length > 1) throw usage(`-o ${shown(out)}: many models need a folder, or a pattern such as out/{name}.png`);
  return out;
}

const fill = (pattern, name, index) => pattern.replaceAll(PATTERN, (_, key) => (key === 'name' ? name : String(index)));

function refuseClashes(files, models) {
  const owner = new Map();
  files.forEach((file, i) => {
    const key = path.resolve(file);
    if (owner.has(key)) {
      throw usage(`${shown(owner.get(key))} and ${shown(models[i])} would both be written to ${shown(file)}; use a pattern with {index}`);
    }
    owner.set(key, models[i]);
  });
  const overwritten = models.find((model) => model !== '-' && owner.has(path.resolve(model)));
  if (overwritten) throw usage(`-o would overwrite the model ${shown(overwritten)}`);
}
