import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** The files of a picture's layers: "shirt.png" has "shirt.depth.png" beside it. */

const EXTENSION_OF = { png: '.png', exr: '.exr', raw: '.raw' };

/** Layers that a shot writes to files of their own. */
function ownLayers({ layers, output }) {
  if (!Array.isArray(layers) || output?.layers?.together === true) return [];
  return layers.filter((name) => name !== 'beauty');
}

/** @param {string} file of the picture @param {object} shot not resolved @returns {Record<string, string>} layer: file */
export function layerFiles(file, shot) {
  const { dir, name } = path.parse(file);
  const extension = EXTENSION_OF[shot.output?.layers?.format ?? 'png'] ?? '';
  return Object.fromEntries(ownLayers(shot).map((layer) => [layer, path.join(dir, `${name}.${layer}${extension}`)]));
}

/**
 * Layers need a file that they can stand beside, and no picture's or model's name.
 * @param {import('./jobs.mjs').Job[]} jobs
 * @param {Array<{file: string}>} outputs
 * @throws {TelarError} E_USAGE
 */
export function checkLayerFiles(jobs, outputs) {
  const taken = new Set([...outputs.map(({ file }) => path.resolve(file)), ...jobs.map(({ model }) => path.resolve(model))]);
  jobs.forEach(({ shot }, i) => {
    const layers = ownLayers(shot);
    if (layers.length > 0 && outputs[i].file === '-') {
      throw new TelarError('E_USAGE', '-o -: layers go to files beside the picture; give a file to -o, or one EXR file by output.layers.together');
    }
    for (const file of Object.values(layerFiles(outputs[i].file, shot))) {
      if (taken.has(path.resolve(file))) throw new TelarError('E_USAGE', `a layer would be written to ${shown(file)}, which is a picture's or a model's`);
      taken.add(path.resolve(file));
    }
  });
}
