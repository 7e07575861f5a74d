import { encodePng } from '../compare/index.mjs';

/** Pictures so far, as events of jobs tell them: small PNGs. */

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
 * @param {import('../index.js').Preview} preview
 * @returns {Promise<{width: number, height: number, samples: number, data: string} | undefined>} a PNG in base64; undefined of floats
 */
export async function previewJson(preview) {
  if (preview.bitDepth !== 8) return undefined;
  const { width, height, data } = shrunk(preview);
  return { width: preview.width, height: preview.height, samples: preview.samples, data: (await encodePng({ width, height, data })).toString('base64') };
}
