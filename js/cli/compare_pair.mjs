import { compareImages, explainDifference, judge, readEmbeddedShot, readImage, shrinkImage, sizeFactor } from '../compare/index.mjs';
import { readFileBytes } from '../compare/files.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';

/** One comparison of `telar compare`: two pictures, read, made one size where that is asked for, compared and judged. */

/** The error with the file's name in front. */
export function named(file, thrown) {
  const error = toTelarError(thrown);
  return new TelarError(error.code, error.code === 'E_FILE' ? error.message : `${file}: ${error.message}`, error);
}

/**
 * A picture, its bytes, and the shot inside it, null where it holds none.
 * @param {string} file path
 * @param {{limits: object, signal?: AbortSignal}} options
 * @returns {Promise<{bytes: Buffer, image: import('../compare/image.mjs').Image, shot: object | null}>}
 * @throws {TelarError} that names the file
 */
export async function readPicture(file, { limits, signal }) {
  try {
    const bytes = await readFileBytes(file, { limits, signal });
    return { bytes, image: await readImage(bytes, { limits, signal }), shot: readEmbeddedShot(bytes) };
  } catch (thrown) {
    throw named(file, thrown);
  }
}

const factorText = (factor) => String(Number(factor.toPrecision(3)));

/** The larger of two pictures in the size of the smaller. @throws {TelarError} E_IMAGE_SIZE */
export function atOneSize(expected, actual, resize) {
  const difference = sizeFactor(expected, actual);
  if (!difference || !resize) return [expected, actual];
  return difference.larger === 'actual' ? [expected, shrinkImage(actual, expected)] : [shrinkImage(expected, actual), actual];
}

/** What to do about pictures of two sizes. */
function checkSizes(expected, actual) {
  if (expected.width === actual.width && expected.height === actual.height) return;
  const difference = sizeFactor(expected, actual);
  const cure = difference
    ? `the ${difference.larger} one is ${factorText(difference.factor)} times as large, as screenshots of dense screens are: --resize shrinks it`
    : 'their shapes differ: draw both at one size';
  throw new TelarError(
    'E_IMAGE_SIZE',
    `the images differ in size: ${expected.width}x${expected.height} expected, ${actual.width}x${actual.height} given; ${cure}`,
  );
}

/**
 * @param {{expected: import('../compare/image.mjs').Image, actual: import('../compare/image.mjs').Image}} images
 * @param {object} settings
 * @param {string} settings.gate
 * @param {Record<string, number>} settings.limits of the gate
 * @param {boolean} settings.resize
 * @param {(size: {width: number, height: number}) => Promise<{mask?: Uint8Array, ignore?: Uint8Array}>} settings.masksOf
 * @returns {Promise<{images: object[], comparison: object, verdict: object, hints: object[]}>}
 * @throws {TelarError} E_IMAGE_SIZE, and what masks throw
 */
export async function comparePair({ expected, actual }, { gate, limits, resize, masksOf }) {
  const images = atOneSize(expected, actual, resize);
  checkSizes(...images);
  const masks = await masksOf(images[0]);
  const comparison = compareImages(...images, masks);
  const verdict = judge(comparison, gate, limits);
  const hints = verdict.pass ? [] : explainDifference(...images);
  return { images, comparison, verdict, hints };
}
