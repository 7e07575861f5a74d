/**
 * Rectangles of pixels, so that what is equal needs no work.
 * @typedef {object} Box
 * @property {number} left
 * @property {number} top
 * @property {number} right exclusive
 * @property {number} bottom exclusive
 */

/**
 * The smallest box that holds every pixel whose colour differs.
 * @param {Uint8Array} a RGBA8; alpha is not looked at
 * @param {Uint8Array} b
 * @returns {Box | null} null where the colours are the same
 */
export function differingBox(a, b, width, height) {
  const box = { left: width, top: height, right: 0, bottom: 0 };
  for (let y = 0, i = 0; y < height; y++) {
    for (let x = 0; x < width; x++, i += 4) {
      if (a[i] === b[i] && a[i + 1] === b[i + 1] && a[i + 2] === b[i + 2]) continue;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x + 1);
      box.top = Math.min(box.top, y);
      box.bottom = y + 1;
    }
  }
  return box.bottom === 0 ? null : box;
}

/** A box with a margin all around, cut at the frame. */
export const grown = (box, margin, width, height) => ({
  left: Math.max(0, box.left - margin),
  top: Math.max(0, box.top - margin),
  right: Math.min(width, box.right + margin),
  bottom: Math.min(height, box.bottom + margin),
});

/** @param {Box} box @returns {{width: number, height: number}} */
export const sizeOf = (box) => ({ width: box.right - box.left, height: box.bottom - box.top });

/**
 * The pixels of a box.
 * @param {Uint8Array} pixels RGBA8
 * @param {number} width of the whole picture
 * @param {Box} box
 * @returns {Uint8Array}
 */
export function cut(pixels, width, box) {
  const size = sizeOf(box);
  const result = new Uint8Array(size.width * size.height * 4);
  for (let y = 0; y < size.height; y++) {
    const from = ((box.top + y) * width + box.left) * 4;
    result.set(pixels.subarray(from, from + size.width * 4), y * size.width * 4);
  }
  return result;
}
