import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { withLook } from '../shot/looks.mjs';
import { resolveShot } from '../shot/resolve.mjs';

/** Pictures that are larger than the owner of a service wants. */

/** @param {{size?: {width: number, height: number}}} shot @param {number} side most pixels @throws {TelarError} L_OUTPUT_SIZE */
export function checkSize({ size }, side) {
  for (const name of ['width', 'height']) {
    const pixels = size?.[name];
    if (!(pixels > side)) continue;
    const limit = { name: 'L_OUTPUT_SIZE', max: side, actual: pixels };
    throw new TelarError('L_OUTPUT_SIZE', `shot.size.${name}: this service draws at most ${side} pixels a side, got ${shown(pixels)}`, {
      pointer: `/size/${name}`,
      limit,
    });
  }
}

/** Whether the size of the picture is that of the model in a scale. @param {object} shot not resolved */
export function isSizedByModel(shot) {
  const { scale = 'none' } = withLook(shot);
  return scale !== 'none' && shot.size === undefined;
}

/**
 * Draws a shot whose size the model gives, where it is not too large.
 * @param {import('../pool/index.js').Pool} pool
 * @param {Uint8Array} source
 * @param {object} shot not resolved
 * @param {object} how options of Pool.render, and side: most pixels
 * @returns {Promise<import('../index.js').Image>}
 * @throws {TelarError} L_OUTPUT_SIZE, and what Pool.load, factsOf and render throw
 */
export async function drawSized(pool, source, shot, { side, onProgress, onPreview, ...loading }) {
  const { signal, timeoutMs } = loading;
  const model = await pool.load(source, loading);
  try {
    checkSize(resolveShot(shot, await pool.factsOf(model, shot, { signal, timeoutMs })), side);
    return await pool.render(model, shot, { ...loading, onProgress, onPreview });
  } finally {
    // A pool that is closed has let it go.
    await pool.release(model).catch(() => {});
  }
}
