import { encodePng } from '../compare/files.mjs';
import { heatMap } from '../compare/heat_map.mjs';
import { strongestIn } from './ranking.mjs';

/**
 * The pictures of a cell that the report shows, as PNG files.
 * @param {object} cell of cellsOf
 * @param {{signal?: AbortSignal}} [options]
 * @returns {Promise<Record<string, Buffer>>} from, to, map (FLIP), and each of strongestIn
 */
export async function picturesOf(cell, { signal } = {}) {
  const { width, height } = cell.cloth;
  const images = {
    from: cell.images.from,
    to: cell.images.to,
    map: heatMap({ width, height, flipMap: cell.map }),
    ...Object.fromEntries(strongestIn(cell).map((slot) => [slot, cell.images[`alone:${slot}`]])),
  };
  const files = {};
  for (const [name, { data }] of Object.entries(images)) files[name] = await encodePng({ width, height, data }, { signal });
  return files;
}

/** The same as URLs that need no file. */
export const dataUrls = (files) => Object.fromEntries(Object.entries(files).map(([name, file]) => [name, `data:image/png;base64,${file.toString('base64')}`]));
