import { realpath, stat } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { modelFiles } from '../view/model_files.mjs';

/** External parts of models: what a picture must not be written over. */

const beneath = (folder, file) => file.startsWith(folder.endsWith(path.sep) ? folder : folder + path.sep);

/** The file that a name leads to, by links too; undefined where there is none. */
const realFile = (name) => realpath(name).catch(() => undefined);

/** Real paths of a model's file and of its parts; none where it cannot be read, or is a pipe: drawing it tells. */
async function filesOf(model, maxBytes) {
  try {
    const found = await stat(model);
    if (!found.isFile() || found.size > maxBytes) return [];
    const { folder, files } = await modelFiles(model);
    return await Promise.all([...files].map((name) => realpath(path.join(folder, name))));
  } catch {
    return [];
  }
}

/**
 * @param {import('./jobs.mjs').Job[]} jobs
 * @param {string[]} files all that is to be written: pictures, their layers, a contact sheet
 * @param {number} maxBytes of a model
 * @throws {TelarError} E_USAGE where one would be written over a model, or over a buffer or a texture of one
 */
export async function refuseParts(jobs, files, maxBytes) {
  // A file is written where its links lead. What is not there yet is no part of a model.
  const written = new Set((await Promise.all(files.filter((file) => file !== '-').map(realFile))).filter(Boolean));
  if (written.size === 0) return;
  for (const model of new Set(jobs.filter(({ model }) => model !== '-').map(({ model }) => model))) {
    const [folder, own] = await Promise.all([realFile(path.dirname(model)), realFile(model)]);
    // Parts lie beneath their model: most models need not be read.
    if (folder === undefined || ![...written].some((file) => beneath(folder, file) || file === own)) continue;
    const part = (await filesOf(model, maxBytes)).find((file) => written.has(file));
    if (part === undefined) continue;
    if (part === own) throw new TelarError('E_USAGE', `-o would overwrite the model ${shown(model)}`);
    throw new TelarError('E_USAGE', `${shown(path.basename(part))} would be overwritten, a part of the model ${shown(model)}: name another folder`);
  }
}
