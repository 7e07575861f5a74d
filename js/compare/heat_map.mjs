/** Colours of no error to the largest, ever lighter, so that the picture reads in grey too (as matplotlib's magma). */
const RAMP = [
  [0, 0, 4],
  [81, 18, 124],
  [183, 55, 121],
  [252, 137, 97],
  [252, 253, 191],
];

/**
 * FLIP of each pixel as a picture.
 * @param {import('./compare.mjs').Comparison} comparison
 * @returns {import('./image.mjs').Image} opaque; black = 0, light yellow = 1
 */
export function heatMap({ flipMap, width, height }) {
  const data = new Uint8Array(flipMap.length * 4).fill(255);
  flipMap.forEach((error, p) => {
    const place = Math.min(1, error) * (RAMP.length - 1);
    const i = Math.min(RAMP.length - 2, Math.floor(place));
    for (let c = 0; c < 3; c++) data[p * 4 + c] = Math.round(RAMP[i][c] + (place - i) * (RAMP[i + 1][c] - RAMP[i][c]));
  });
  return { width, height, data };
}
