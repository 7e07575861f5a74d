import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { modelFiles } from '../view/model_files.mjs';

/** External parts of models: what a picture must not be written over. */

const beneath = (folder, file) => file.startsWith(folder.endsWith(path.sep) ? folder : folder + path.sep);

/** Paths of a model's parts; none where it cannot be read: drawing it tells. */
async function partsOf(model) {
  try {
    const { folder, files } = await modelFiles(model);
    return [...files].map((name) => path.join(folder, name));
  } catch {
    return [];
  }
}

/**
 * @param {import('./jobs.mjs').Job[]} jobs
 * @param {string[]} files all that is to be written: pictures, their layers, a contact sheet
 * @throws {TelarError} E_USAGE where one would be written over a buffer or a texture of a model
 */
export async function refuseParts(jobs, files) {
  const written = new Set(files.map((file) => path.resolve(file)));
  const models = [...new Set(jobs.map(({ model }) => model))].filter((model) => /\.gltf$/i.test(model));
  for (const model of models) {
    // Parts lie beneath their model: most models need not be read.
    const folder = path.dirname(path.resolve(model));
    if (![...written].some((file) => beneath(folder, file))) continue;
    const part = (await partsOf(model)).find((file) => written.has(file));
    if (part) throw new TelarError('E_USAGE', `${shown(path.basename(part))} would be overwritten, a part of the model ${shown(model)}: name another folder`);
  }
}
