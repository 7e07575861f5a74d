/** Which pixels are judged as the inside of the object, and which as its edge. */

/** Width in pixels of the band along a silhouette that is judged apart. */
const EDGE_PIXELS = 2;

/** What pairRegions() calls a pixel. */
export const [OUTSIDE, INSIDE, BAND] = [0, 1, 2];

/** What compareImages() calls a pixel that is not compared. */
export const IGNORED = 3;

/** What maskedRegions() calls a background that both pictures show. */
export const BACKGROUND = 4;

/** Object pixels above and left of each corner of the grid: (width + 1) * (height + 1). */
function summedAreas(object, width, height) {
  const sums = new Uint32Array((width + 1) * (height + 1));
  for (let y = 0; y < height; y++) {
    let row = 0;
    for (let x = 0; x < width; x++) {
      row += object[y * width + x];
      sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
    }
  }
  return sums;
}

/**
 * INSIDE or OUTSIDE of the object, or BAND where both lie within the square of EDGE_PIXELS around; the frame's border is no
 * silhouette.
 * @param {Uint8Array} object 1 or 0 a pixel, width * height
 * @returns {Uint8Array} one of the three a pixel
 */
function regionsOf(object, width, height) {
  const sums = summedAreas(object, width, height);
  const regions = new Uint8Array(object.length);
  for (let y = 0; y < height; y++) {
    const [top, bottom] = [Math.max(0, y - EDGE_PIXELS), Math.min(height, y + EDGE_PIXELS + 1)];
    const [above, below] = [top * (width + 1), bottom * (width + 1)];
    for (let x = 0; x < width; x++) {
      const left = Math.max(0, x - EDGE_PIXELS);
      const right = Math.min(width, x + EDGE_PIXELS + 1);
      const count = sums[below + right] - sums[below + left] - sums[above + right] + sums[above + left];
      if (count === 0) regions[y * width + x] = OUTSIDE;
      else regions[y * width + x] = count === (right - left) * (bottom - top) ? INSIDE : BAND;
    }
  }
  return regions;
}

/**
 * The one definition of interior and edge. The object is what both pictures cover (alpha above 0), or the mask where it is
 * given, for pictures whose own alpha does not tell: those with a drawn background. BAND lies along the object's silhouette,
 * INSIDE is the rest of what shows, within the object and on a drawn background; what only one picture covers is BAND, and
 * OUTSIDE is where both are fully transparent.
 * @param {Uint8Array} expected RGBA
 * @param {Uint8Array} actual RGBA
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array} [mask] not 0 where the object is, width * height
 * @returns {Uint8Array} one of the three a pixel
 */
export const pairRegions = (expected, actual, width, height, mask = undefined) =>
  maskedRegions(expected, actual, width, height, mask).map((region) => (region === BACKGROUND ? INSIDE : region));

/** The same, with BACKGROUND in place of INSIDE for what both pictures show away from the mask's object. */
export function maskedRegions(expected, actual, width, height, mask = undefined) {
  const covered = new Uint8Array(width * height);
  for (let i = 0, alpha = 3; i < covered.length; i++, alpha += 4) {
    covered[i] = (expected[alpha] > 0 ? 1 : 0) + (actual[alpha] > 0 ? 1 : 0);
  }
  const object = mask ? mask.map((value) => (value === 0 ? 0 : 1)) : covered.map((pictures) => (pictures === 2 ? 1 : 0));
  const regions = regionsOf(object, width, height);
  for (let i = 0; i < regions.length; i++) {
    if (covered[i] === 0) regions[i] = OUTSIDE;
    else if (regions[i] === OUTSIDE) regions[i] = covered[i] === 2 ? BACKGROUND : BAND;
  }
  return regions;
}
