/**
 * How far two pictures of one shot are apart.
 * @typedef {object} Difference
 * @property {Region} interior - Pixels at least EDGE pixels from the silhouette, within the object, and beside it where
 *   the background is drawn.
 * @property {Region} edge - The other pixels that touch the object.
 * @property {boolean} pass - The interior keeps within the bar.
 *
 * @typedef {object} Region
 * @property {number} pixels
 * @property {number} max - Largest difference of any channel, in 1/255.
 * @property {number} p999 - 99.9th percentile over pixels of the largest channel difference.
 * @property {number} atLeast1 - Pixels that differ by 1 or more.
 * @property {number} atLeast2
 * @property {[number, number] | null} worst - Pixel of `max`, counted from the top left.
 */

/** Width in pixels of the band beside a silhouette that is judged apart. */
const EDGE = 2;

/** Bar of the interior, in 1/255: no pixel above MAX, 99.9 % of them at most P999. */
export const BAR = { max: 2, p999: 1 };

/**
 * Straight to premultiplied alpha, 8 bit. Undoes the division exactly: the quotient's rounding error shrinks by alpha.
 * @param {Uint8Array} pixels - RGBA
 */
export function premultiply(pixels) {
  const result = new Uint8Array(pixels.length);
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3];
    for (let c = 0; c < 3; c++) result[i + c] = Math.round((pixels[i + c] * alpha) / 255);
    result[i + 3] = alpha;
  }
  return result;
}

/**
 * @param {object} pictures - All RGBA8, premultiplied, top row first, width * height.
 * @param {Uint8Array} pictures.expected - The browser's.
 * @param {Uint8Array} pictures.actual - The server's.
 * @param {Uint8Array} pictures.mask - The browser's without background: alpha > 0 is the object.
 * @param {boolean} pictures.background - Whether pixels beside the object show something.
 * @returns {Difference}
 */
export function difference({ expected, actual, mask, width, height, background }) {
  if (actual.length !== expected.length) throw new Error(`expected ${expected.length} bytes, got ${actual.length}`);
  const regions = regionOf(mask, width, height);
  const histograms = { interior: newHistogram(), edge: newHistogram() };
  for (let i = 0; i < regions.length; i++) {
    if (regions[i] === OUTSIDE && !background) continue;
    const kind = regions[i] === BAND ? 'edge' : 'interior';
    add(histograms[kind], channelDifference(expected, actual, i * 4), i);
  }
  const interior = summary(histograms.interior, width);
  return {
    interior,
    edge: summary(histograms.edge, width),
    pass: interior.pixels > 0 && interior.max <= BAR.max && interior.p999 <= BAR.p999,
  };
}

const [OUTSIDE, INSIDE, BAND] = [0, 1, 2];

/** OUTSIDE, INSIDE, or BAND where both lie within EDGE pixels; the frame's border is no silhouette. */
function regionOf(mask, width, height) {
  const inside = (x, y) => mask[(y * width + x) * 4 + 3] > 0;
  const regions = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const own = inside(x, y);
      regions[y * width + x] = own ? INSIDE : OUTSIDE;
      for (let v = Math.max(0, y - EDGE); v <= Math.min(height - 1, y + EDGE); v++) {
        for (let u = Math.max(0, x - EDGE); u <= Math.min(width - 1, x + EDGE); u++) {
          if (inside(u, v) !== own) regions[y * width + x] = BAND;
        }
      }
    }
  }
  return regions;
}

function channelDifference(a, b, offset) {
  let most = 0;
  for (let c = 0; c < 4; c++) most = Math.max(most, Math.abs(a[offset + c] - b[offset + c]));
  return most;
}

const newHistogram = () => ({ counts: new Uint32Array(256), worst: null, max: -1 });

function add(histogram, value, index) {
  histogram.counts[value]++;
  if (value > histogram.max) Object.assign(histogram, { max: value, worst: index });
}

function summary({ counts, worst, max }, width) {
  const pixels = counts.reduce((sum, count) => sum + count, 0);
  const above = (value) => counts.subarray(value).reduce((sum, count) => sum + count, 0);
  let p999 = 0;
  while (p999 < 255 && above(p999 + 1) > 0.001 * pixels) p999++;
  return {
    pixels,
    max: Math.max(0, max),
    p999,
    atLeast1: above(1),
    atLeast2: above(2),
    worst: worst === null ? null : [worst % width, Math.floor(worst / width)],
  };
}
