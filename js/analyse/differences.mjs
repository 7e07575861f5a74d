import { ciede2000Map } from '../compare/ciede2000.mjs';
import { LINEAR, labOf } from '../compare/colour.mjs';
import { flipMap } from '../compare/flip.mjs';
import { over, premultiply } from '../compare/image.mjs';
import { mean, percentile } from '../compare/statistics.mjs';

/**
 * How one picture of a cloth differs from another of the same cloth, and in which direction. Both have the same silhouette.
 *
 * @typedef {object} Cloth - Where the cloth is in the frame; from clothOf.
 * @property {number} width pixels
 * @property {number} height pixels
 * @property {Uint32Array} pixels - Indices of pixels that it covers by half or more.
 * @property {Uint32Array} limb - Those seen at a grazing angle.
 * @property {Uint32Array} centre - Those that face the viewer.
 *
 * @typedef {object} Change - Second picture less the first, means over pixels.
 * @property {number} lightness - CIELAB L*, 0..100.
 * @property {number} chroma - CIELAB C*.
 *
 * @typedef {object} Difference
 * @property {{mean: number, p95: number}} flip - Over the cloth, 0..1.
 * @property {{mean: number, p95: number}} deltaE - CIEDE2000 over the cloth.
 * @property {Change} cloth
 * @property {Change | null} limb - Null where the picture has no such pixel, as in the next two.
 * @property {Change | null} centre
 * @property {Change | null} highlight - The brightest pixels of either picture.
 *
 * @typedef {object} Look - A picture prepared once and compared often.
 * @property {Uint8Array} pixels - RGBA over the backdrop.
 * @property {Float32Array} lightness - CIELAB L* of each pixel.
 * @property {Float32Array} chroma - CIELAB C*.
 * @property {Uint32Array} highlights - Indices of the brightest pixels of the cloth.
 */

/** Cosines between normal and viewer below and above which cloth counts as limb and as centre. */
export const LIMB_BELOW = 0.4;
export const CENTRE_ABOVE = 0.8;
/** Share of the cloth's pixels that counts as highlight, in either picture. */
export const HIGHLIGHT_SHARE = 0.03;
/** Normal maps are looked through: the cosine is a mean over this many pixels to each side. */
const SMOOTHING = 2;
/** Behind the cloth while pictures are compared: middle grey, so that neither a dark nor a light edge stands out. */
const BACKDROP = 119;
const HALF_COVERED = 128;

/**
 * @param {import('../compare/image.mjs').Image} image - Any picture of the cloth, transparent where it is not.
 * @param {Float32Array} facing - RGBA of each pixel: the cosine and, in A, coverage (renderQuantity "NoV").
 * @returns {Cloth}
 */
export function clothOf({ width, height, data }, facing) {
  const all = Uint32Array.from({ length: width * height }, (_, i) => i);
  const pixels = all.filter((i) => data[i * 4 + 3] >= HALF_COVERED);
  const cosine = smoothed(facing, width, height);
  return {
    width,
    height,
    pixels,
    limb: pixels.filter((i) => cosine[i] < LIMB_BELOW),
    centre: pixels.filter((i) => cosine[i] > CENTRE_ABOVE),
  };
}

/** Mean cosine around each pixel, of covered pixels alone. */
function smoothed(facing, width, height) {
  return Float32Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    let [sum, weight] = [0, 0];
    for (let v = Math.max(0, y - SMOOTHING); v <= Math.min(height - 1, y + SMOOTHING); v++) {
      for (let u = Math.max(0, x - SMOOTHING); u <= Math.min(width - 1, x + SMOOTHING); u++) {
        sum += facing[(v * width + u) * 4];
        weight += facing[(v * width + u) * 4 + 3];
      }
    }
    return weight > 0 ? sum / weight : 0;
  });
}

/**
 * @param {import('../compare/image.mjs').Image} image - Straight alpha.
 * @param {Cloth} cloth
 * @returns {Look}
 */
export function lookAt({ data }, cloth) {
  const pixels = over(premultiply(data), BACKDROP);
  const [lightness, chroma] = [new Float32Array(pixels.length / 4), new Float32Array(pixels.length / 4)];
  const lab = new Float64Array(3);
  for (let p = 0, i = 0; i < pixels.length; p++, i += 4) {
    labOf(LINEAR[pixels[i]], LINEAR[pixels[i + 1]], LINEAR[pixels[i + 2]], lab);
    lightness[p] = lab[0];
    chroma[p] = Math.hypot(lab[1], lab[2]);
  }
  return { pixels, lightness, chroma, highlights: brightest(cloth.pixels, lightness) };
}

const brightest = (pixels, lightness) =>
  pixels
    .slice()
    .sort((a, b) => lightness[b] - lightness[a] || a - b)
    .slice(0, Math.ceil(pixels.length * HIGHLIGHT_SHARE));

function changeOver(pixels, first, second) {
  if (pixels.length === 0) return null;
  const meanOf = (key) => pixels.reduce((sum, p) => sum + second[key][p] - first[key][p], 0) / pixels.length;
  return { lightness: meanOf('lightness'), chroma: meanOf('chroma') };
}

const pooled = (sorted) => (sorted.length === 0 ? { mean: 0, p95: 0 } : { mean: mean(sorted), p95: percentile(sorted, 0.95) });

/**
 * @param {Look} first
 * @param {Look} second
 * @param {Cloth} cloth
 * @returns {{figures: Difference, map: Float32Array}} `map`: FLIP of each pixel, 0 off the cloth
 */
export function difference(first, second, cloth) {
  const { width, height, pixels } = cloth;
  const flip = flipMap(first.pixels, second.pixels, width, height);
  const deltaE = ciede2000Map(first.pixels, second.pixels);
  const map = new Float32Array(width * height);
  for (const p of pixels) map[p] = flip[p];
  const over95 = (values) => pooled(Float32Array.from(pixels, (p) => values[p]).sort());
  const highlights = Uint32Array.from(new Set([...first.highlights, ...second.highlights]));
  const figures = {
    flip: over95(flip),
    deltaE: over95(deltaE),
    cloth: changeOver(pixels, first, second) ?? { lightness: 0, chroma: 0 },
    limb: changeOver(cloth.limb, first, second),
    centre: changeOver(cloth.centre, first, second),
    highlight: changeOver(highlights, first, second),
  };
  return { figures, map };
}
