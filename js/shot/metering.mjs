import { lensExposure } from './lens_exposure.mjs';
import { luminance } from './luminance.mjs';
import { PRESETS, RASTER } from './table/quality.mjs';
import { inOrder } from './table/resolved.mjs';

/**
 * Exposure by what a picture shows. Server and browser draw it small and without tone mapping, and read the factor from its histogram.
 */

/** Texels of the longer side of the picture that is read. */
const SIDE = 128;

/** Width of the band below the percentile, as a part of the pixels. */
const BAND = 0.05;

/** Luminance that black counts as. */
const DARKEST = 2 ** -64;

/** Pixels with less of the model on them say nothing. */
const LEAST_ALPHA = 0.5;

/**
 * @param {object} shot resolved
 * @returns {{width: number, height: number}} of the picture that is read, pixels
 */
export function meteredSize({ size: { width, height } }) {
  const scale = Math.min(SIDE / Math.max(width, height), 1);
  return { width: Math.max(Math.round(width * scale), 1), height: Math.max(Math.round(height * scale), 1) };
}

/**
 * The picture that is read, as the server draws it: the model alone, radiance by the exposure of the lens, one sample a pixel. A picture
 * holds light up to that of a half float, and a lens dims what is brighter.
 * @internal
 * @param {object} shot resolved
 * @returns {object} resolved
 */
export function meteringShot(shot) {
  // Each triangle is shaded for itself, as the browser does it: merged quads move the exposure by a hundredth.
  const quality = inOrder(RASTER, { ...PRESETS.draft, mergeQuads: false });
  const output = { ...shot.output, format: 'raw', bitDepth: 32 };
  const drawn = { background: 'transparent', ground: 'none', lens: null, exposure: lensExposure(shot.lens), quality, layers: ['beauty'], output };
  return { ...shot, size: meteredSize(shot), ...drawn };
}

/**
 * @param {ArrayLike<number>} pixels - RGBA, linear Rec.709, multiplied by alpha.
 * @returns {Float64Array} Luminance of the pixels that show the model, the darkest first.
 */
function luminances(pixels) {
  const found = [];
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3];
    const shown = luminance(pixels, i) / alpha;
    if (alpha >= LEAST_ALPHA && !Number.isNaN(shown)) found.push(shown);
  }
  return Float64Array.from(found).sort();
}

/**
 * The factor on radiance that a shot's `metering` asks for, beside `exposure` and its lens. It brings the geometric mean of a band below
 * the percentile to the level: a single value there may be another pixel in another renderer.
 * src: after the band of the histogram in Narkowicz 2016, "Automatic Exposure"
 * @param {object} shot - Resolved, with `metering`.
 * @param {ArrayLike<number>} pixels - Of the picture that `meteredSize` tells, RGBA, linear Rec.709 with the exposure of the lens, before
 *   the shot's own and tone mapping, multiplied by alpha.
 * @returns {number} In least..most; 1 where no pixel shows the model.
 */
export function meteredExposure({ metering: { percentile, level, least, most } }, pixels) {
  const sorted = luminances(pixels);
  if (sorted.length === 0) return 1;
  const end = Math.max(Math.round(percentile * sorted.length), 1);
  const band = sorted
    .subarray(Math.min(Math.max(Math.floor((percentile - BAND) * sorted.length), 0), end - 1), end)
    .map((value) => Math.log2(Math.max(value, DARKEST)));
  const mean = 2 ** (band.reduce((sum, value) => sum + value) / band.length);
  return Math.min(Math.max(level / mean, least), most);
}
