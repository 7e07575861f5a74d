import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/**
 * @typedef {object} Image
 * @property {number} width pixels
 * @property {number} height pixels
 * @property {Uint8Array | Uint8ClampedArray} data RGBA8, sRGB-encoded, straight alpha, top row first: width * height * 4 bytes
 */

const isBytes = (value) => value instanceof Uint8Array || value instanceof Uint8ClampedArray;
const isSide = (value) => Number.isSafeInteger(value) && value >= 1;

/** @throws {TelarError} E_OPTION that names the argument */
export function checkImage(name, image) {
  const { width, height, data } = image ?? {};
  if (isSide(width) && isSide(height) && isBytes(data) && data.length === width * height * 4) return;
  throw new TelarError(
    'E_OPTION',
    `${name}: expected {width, height, data} with width * height * 4 bytes of RGBA, got ${
      isBytes(data) ? `${shown(width)} x ${shown(height)} with ${data.length} bytes` : shown(image)
    }`,
  );
}

/**
 * @param {Image} expected
 * @param {Image} actual
 * @throws {TelarError} E_OPTION for what is no image, E_IMAGE_SIZE where the sizes differ
 */
export function checkPair(expected, actual) {
  checkImage('expected', expected);
  checkImage('actual', actual);
  if (expected.width === actual.width && expected.height === actual.height) return;
  throw new TelarError(
    'E_IMAGE_SIZE',
    `the images differ in size: ${expected.width}x${expected.height} expected, ${actual.width}x${actual.height} given; draw both at one size`,
  );
}

/** Straight to premultiplied alpha of one channel, 8 bit, rounded. */
const premultiplied = (colour, alpha) => Math.round((colour * alpha) / 255);

/**
 * Straight to premultiplied alpha, 8 bit. Undoes the division exactly: the quotient's rounding error shrinks by alpha.
 * @param {Uint8Array | Uint8ClampedArray} pixels RGBA
 * @returns {Uint8Array}
 */
export function premultiply(pixels) {
  const result = new Uint8Array(pixels.length);
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3];
    for (let c = 0; c < 3; c++) result[i + c] = premultiplied(pixels[i + c], alpha);
    result[i + 3] = alpha;
  }
  return result;
}

/**
 * Composites over a grey background in encoded values, as a web page does.
 * @param {Uint8Array} pixels RGBA, premultiplied
 * @param {number} background 0..255
 * @returns {Uint8Array} RGBA, opaque
 */
export function over(pixels, background) {
  const result = new Uint8Array(pixels.length);
  for (let i = 0; i < pixels.length; i += 4) {
    const behind = premultiplied(background, 255 - pixels[i + 3]);
    for (let c = 0; c < 3; c++) result[i + c] = Math.min(255, pixels[i + c] + behind);
    result[i + 3] = 255;
  }
  return result;
}

/** @param {Uint8Array | Uint8ClampedArray} pixels RGBA */
export function isOpaque(pixels) {
  for (let i = 3; i < pixels.length; i += 4) if (pixels[i] !== 255) return false;
  return true;
}
