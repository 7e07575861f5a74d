import { isObject } from '../api/option_check.mjs';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { withLook } from '../shot/looks.mjs';
import { resolveShot } from '../shot/resolve.mjs';
import { SHOT } from '../shot/table/index.mjs';

/** Pictures that are larger than the owner of a service wants. */

const PIXELS = SHOT.shape.size.shape.width;
const USUAL = Object.fromEntries(Object.entries(SHOT.shape.size.shape).map(([name, row]) => [name, row.default]));

const isPixels = (value) => Number.isInteger(value) && value >= PIXELS.min && value <= PIXELS.max;

/**
 * What is no number of pixels at all is left to the shot's own check, whose message says what is.
 * @param {{size?: {width: number, height: number}}} shot
 * @param {number} side most pixels
 * @throws {TelarError} L_OUTPUT_SIZE
 */
export function checkSize({ size }, side) {
  for (const name of ['width', 'height']) {
    const pixels = size?.[name];
    if (!(isPixels(pixels) && pixels > side)) continue;
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

/** Of a shot that is not resolved, as far as the model does not decide. @throws {TelarError} L_OUTPUT_SIZE */
export function checkGivenSize(shot, side) {
  const { size = {} } = shot;
  if (isObject(size) && !isSizedByModel(shot)) checkSize({ size: { ...USUAL, ...size } }, side);
}

/**
 * A result that was stored may be one of a service that draws larger pictures.
 * @param {import('./job_queue.mjs').Task} task
 * @param {import('./perform.mjs').Result} result
 * @throws {TelarError} L_OUTPUT_SIZE
 */
export function checkStored({ asked: { side } }, { info }) {
  if (side !== undefined) checkSize({ size: info }, side);
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
