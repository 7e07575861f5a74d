/** Which pixels are judged as the inside of the object, and which as its edge. */

/** Width in pixels of the band along a silhouette that is judged apart. */
export const EDGE_PIXELS = 2;

/** What regionsOf() calls a pixel. */
export const [OUTSIDE, INSIDE, BAND] = [0, 1, 2];

/** Smallest or largest (`pick`) value within EDGE_PIXELS of each pixel, a square window cut at the frame. */
function windowed(mask, width, height, pick) {
  const along = (source, length, stride, lines, lineStride) => {
    const result = new Uint8Array(source.length);
    for (let line = 0; line < lines; line++) {
      for (let i = 0; i < length; i++) {
        let value = source[line * lineStride + i * stride];
        for (let j = Math.max(0, i - EDGE_PIXELS); j <= Math.min(length - 1, i + EDGE_PIXELS); j++) {
          value = pick(value, source[line * lineStride + j * stride]);
        }
        result[line * lineStride + i * stride] = value;
      }
    }
    return result;
  };
  return along(along(mask, width, 1, height, width), height, width, width, 1);
}

/**
 * INSIDE or OUTSIDE the mask, or BAND where both lie within EDGE_PIXELS; the frame's border is no silhouette.
 * @param {Uint8Array} mask 1 or 0 a pixel, width * height
 * @returns {Uint8Array} one of the three a pixel
 */
export function regionsOf(mask, width, height) {
  const least = windowed(mask, width, height, Math.min);
  const most = windowed(mask, width, height, Math.max);
  return least.map((low, i) => (low === 1 ? INSIDE : most[i] === 0 ? OUTSIDE : BAND));
}

/**
 * The regions of two pictures: INSIDE where both are opaque for EDGE_PIXELS around, BAND for the rest of what either one
 * covers, OUTSIDE where both are fully transparent.
 * @param {Uint8Array} expected RGBA
 * @param {Uint8Array} actual RGBA
 * @returns {Uint8Array}
 */
export function pairRegions(expected, actual, width, height) {
  const solid = new Uint8Array(width * height);
  for (let i = 0; i < solid.length; i++) solid[i] = expected[i * 4 + 3] === 255 && actual[i * 4 + 3] === 255 ? 1 : 0;
  const regions = regionsOf(solid, width, height);
  for (let i = 0; i < regions.length; i++) {
    if (regions[i] !== INSIDE) regions[i] = expected[i * 4 + 3] > 0 || actual[i * 4 + 3] > 0 ? BAND : OUTSIDE;
  }
  return regions;
}
