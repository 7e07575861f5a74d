import { encodePng } from '../compare/index.mjs';

/** Pictures so far, as whoever watches a job is shown them: small PNGs. */

/** Pixels of a side at most. */
const SIDE = 192;
/** Bytes of a pixel of 8 bits a channel. */
const PIXEL = 4;

/** Every nth pixel: a glance, and no work for this process. @returns {import('../compare/image.mjs').Image} */
export function shrunk({ width, height, data }, side = SIDE) {
  const step = Math.ceil(Math.max(width, height) / side);
  if (step <= 1) return { width, height, data };
  const [columns, rows] = [width, height].map((pixels) => Math.ceil(pixels / step));
  const [from, to] = [new Uint32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength)), new Uint32Array(columns * rows)];
  for (let y = 0; y < rows; ++y) for (let x = 0; x < columns; ++x) to[y * columns + x] = from[y * step * width + x * step];
  return { width: columns, height: rows, data: Buffer.from(to.buffer, 0, columns * rows * PIXEL) };
}

/**
 * @typedef {object} ShownPreview
 * @property {number} width of the picture in pixels, as height
 * @property {number} height
 * @property {number} samples that a pixel has taken so far
 * @property {Buffer} png the picture so far, shrunk
 */

/** @param {import('../index.js').Preview} preview @returns {Promise<ShownPreview>} */
async function shownOf(preview) {
  const { width, height, data } = shrunk(preview);
  return { width: preview.width, height: preview.height, samples: preview.samples, png: await encodePng({ width, height, data }) };
}

/**
 * Shows pictures so far one after the other: what comes while one is on its way is left out, and so are floats.
 * @param {(shown: ShownPreview) => unknown} show what it throws costs that picture alone
 * @returns {(preview: import('../index.js').Preview) => void}
 */
export function showing(show) {
  let isShowing = false;
  return async (preview) => {
    if (isShowing || preview.bitDepth !== 8) return;
    isShowing = true;
    try {
      await show(await shownOf(preview));
    } catch {
      // The next one is shown.
    } finally {
      isShowing = false;
    }
  };
}
