/**
 * RGBA8 of a drawing buffer (premultiplied, bottom row first) with straight alpha, top row first. Premultiplied again it
 * is the same bytes: the rounding error shrinks by alpha.
 * @param {Uint8Array} buffer
 * @param {number} width
 * @param {number} height
 * @returns {Uint8ClampedArray}
 */
export function straightPixels(buffer, width, height) {
  const result = new Uint8ClampedArray(buffer.length);
  const stride = width * 4;
  for (let y = 0; y < height; y++) {
    const row = buffer.subarray((height - 1 - y) * stride, (height - y) * stride);
    for (let x = 0; x < stride; x += 4) {
      const alpha = row[x + 3];
      const at = y * stride + x;
      // The array rounds and clamps: colour above alpha (additive effects) has no straight form.
      for (let c = 0; c < 3; c++) result[at + c] = alpha === 0 ? 0 : (row[x + c] * 255) / alpha;
      result[at + 3] = alpha;
    }
  }
  return result;
}

/**
 * @param {Uint8Array} buffer RGBA8, bottom row first
 * @returns {Uint8Array} alpha, top row first
 */
export const alphaOf = (buffer, width, height) =>
  Uint8Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    return buffer[((height - 1 - y) * width + x) * 4 + 3];
  });

const SCALE = 16;

/**
 * Differences of premultiplied channels times 16, as a picture; a difference of alpha shows in every channel.
 * @param {import('../../compare/image.mjs').Image} expected straight alpha
 * @param {import('../../compare/image.mjs').Image} actual
 * @returns {Uint8ClampedArray} RGBA8, opaque; black = equal
 */
export function scaledDifference({ data: a }, { data: b }) {
  const result = new Uint8ClampedArray(a.length);
  const premultiplied = (pixels, i, alpha) => Math.round((pixels[i] * alpha) / 255);
  for (let i = 0; i < a.length; i += 4) {
    const [alphaA, alphaB] = [a[i + 3], b[i + 3]];
    const alpha = Math.abs(alphaA - alphaB);
    for (let c = i; c < i + 3; c++) {
      result[c] = SCALE * Math.max(alpha, Math.abs(premultiplied(a, c, alphaA) - premultiplied(b, c, alphaB)));
    }
    result[i + 3] = 255;
  }
  return result;
}
