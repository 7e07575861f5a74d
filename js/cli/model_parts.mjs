import { realpath, stat } from 'node:fs/promises';
import path from 'node:path';
import { modelFiles } from '../view/model_files.mjs';

/** External parts of models: what nothing must be written over. */

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
 * @param {string[]} models paths, or - for stdin
 * @param {Set<string>} written real paths of files that are there and are to be written over
 * @param {number} maxBytes of a model
 * @returns {Promise<{model: string, part: string, isModel: boolean} | undefined>} a part that would be written over, or a model itself: its real path
 */
export async function partOver(models, written, maxBytes) {
  if (written.size === 0) return undefined;
  for (const model of new Set(models.filter((name) => name !== '-'))) {
    const [folder, own] = await Promise.all([realFile(path.dirname(model)), realFile(model)]);
    if (own !== undefined && written.has(own) && (await stat(own)).isFile()) return { model, part: own, isModel: true };
    // Parts lie beneath their model: most models need not be read.
    if (folder === undefined || ![...written].some((file) => beneath(folder, file))) continue;
    const part = (await filesOf(model, maxBytes)).find((file) => written.has(file));
    if (part !== undefined) return { model, part, isModel: false };
  }
  return undefined;
}
