import { TelarError } from '../error/index.mjs';
import { checkImage } from './image.mjs';

/**
 * Which source pixels make each target pixel of one axis, and how much each counts: the share of the target's width that it
 * covers.
 * @returns {Array<{first: number, weights: number[]}>}
 */
function coverages(from, to) {
  return Array.from({ length: to }, (_, target) => {
    const [begin, end] = [(target * from) / to, ((target + 1) * from) / to];
    const first = Math.floor(begin);
    const weights = [];
    for (let i = first; i < end; i++) weights.push(((Math.min(i + 1, end) - Math.max(i, begin)) * to) / from);
    return { first, weights };
  });
}

/** Rows of `width` RGBA pixels each resampled to `to` pixels; colours as they are. */
function shrunkRows(pixels, width, rows, to) {
  const result = new Float32Array(rows * to * 4);
  const columns = coverages(width, to);
  for (let y = 0; y < rows; y++) {
    for (let x = 0; x < to; x++) {
      const { first, weights } = columns[x];
      const out = (y * to + x) * 4;
      for (let i = 0; i < weights.length; i++) {
        const at = (y * width + first + i) * 4;
        for (let c = 0; c < 4; c++) result[out + c] += weights[i] * pixels[at + c];
      }
    }
  }
  return result;
}

/** Columns and rows of RGBA pixels swapped. */
function transposed(pixels, width, height) {
  const result = new Float32Array(pixels.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      for (let c = 0; c < 4; c++) result[(x * height + y) * 4 + c] = pixels[(y * width + x) * 4 + c];
    }
  }
  return result;
}

function premultiplied(data) {
  // A plain loop: Float32Array.from with a function takes ten times as long.
  const result = new Float32Array(data.length);
  for (let i = 0; i < data.length; i += 4) {
    for (let c = 0; c < 3; c++) result[i + c] = (data[i + c] * data[i + 3]) / 255;
    result[i + 3] = data[i + 3];
  }
  return result;
}

function straight(pixels) {
  const data = new Uint8Array(pixels.length);
  for (let i = 0; i < data.length; i += 4) {
    const alpha = pixels[i + 3];
    for (let c = 0; c < 3; c++) data[i + c] = alpha > 0 ? Math.min(255, Math.round((pixels[i + c] / alpha) * 255)) : 0;
    data[i + 3] = Math.round(alpha);
  }
  return data;
}

/**
 * A smaller picture, each pixel the mean of what it covers: of premultiplied and sRGB-encoded values, as browsers resolve
 * several samples of a pixel and shrink what they show.
 * @param {import('./image.mjs').Image} image
 * @param {{width: number, height: number}} size no larger than the image's
 * @returns {import('./image.mjs').Image}
 * @throws {TelarError} E_OPTION
 */
export function shrinkImage(image, { width, height }) {
  checkImage('image', image);
  const fits = (to, from) => Number.isSafeInteger(to) && to >= 1 && to <= from;
  if (!fits(width, image.width) || !fits(height, image.height)) {
    throw new TelarError('E_OPTION', `size: expected whole numbers from 1x1 to ${image.width}x${image.height}, got ${width}x${height}`);
  }
  if (width === image.width && height === image.height) return image;
  const rows = shrunkRows(premultiplied(image.data), image.width, image.height, width);
  const columns = shrunkRows(transposed(rows, width, image.height), image.height, width, height);
  return { width, height, data: straight(transposed(columns, height, width)) };
}
