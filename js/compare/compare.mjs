import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { channelDifference, DifferenceHistogram } from './channels.mjs';
import { ciede2000Map } from './ciede2000.mjs';
import { LINEAR } from './colour.mjs';
import { flipMap, PIXELS_PER_DEGREE } from './flip.mjs';
import { checkPair, isOpaque, over, premultiply } from './image.mjs';
import { BACKGROUND, BAND, IGNORED, INSIDE, maskedRegions } from './regions.mjs';
import { ssim } from './ssim.mjs';
import { mean, percentile, weightedPercentile } from './statistics.mjs';

/**
 * Figures of the pixels of one region.
 * @typedef {import('./channels.mjs').ChannelFigures & {
 *   rmse: number, rmseLinear: number,
 *   flip: {mean: number, weightedMedian: number, weightedQuartile1: number, weightedQuartile3: number, max: number},
 *   deltaE: {mean: number, p95: number, max: number}}} Figures
 *
 * @typedef {object} Comparison
 * @property {number} width pixels
 * @property {number} height pixels
 * @property {Figures} frame every pixel that is compared
 * @property {Figures | null} object pixels that either picture covers, or of a mask those that are light and the edge around; null where there is none,
 *   as in the next two
 * @property {Figures | null} interior pixels whose surroundings of 2 pixels both pictures cover, and with a mask the background that both show
 *   (regions.mjs)
 * @property {Figures | null} edge the rest of the object
 * @property {number | null} ssim mean over the frame; null for a picture smaller than 11 x 11
 * @property {Float32Array} flipMap FLIP of each pixel
 */

const REGIONS = {
  frame: (region) => region !== IGNORED,
  object: (region) => region === INSIDE || region === BAND,
  interior: (region) => region === INSIDE || region === BACKGROUND,
  edge: (region) => region === BAND,
};

/**
 * How far two pictures of one size are apart. `max`, `p999` and `worst` are of premultiplied RGBA, alpha included. Every
 * other figure is of the colours seen over black and over white, whichever shows a pixel worse, so that a difference of
 * alpha cannot hide; opaque pictures are taken as they are. Synchronous, up to three seconds for 512 x 512 pixels that all
 * differ, and the less the fewer differ.
 * @param {import('./image.mjs').Image} expected
 * @param {import('./image.mjs').Image} actual
 * @param {{pixelsPerDegree?: number, mask?: Uint8Array, ignore?: Uint8Array}} [options] viewing distance of FLIP, 1 to 1000
 *   pixels for each degree (67); mask: width * height bytes, not 0 where the object is, for pictures with a background whose
 *   alpha does not tell; ignore: as many, not 0 where the pictures are not compared
 * @returns {Comparison}
 * @throws {TelarError} E_OPTION, E_IMAGE_SIZE
 */
export function compareImages(expected, actual, { pixelsPerDegree = PIXELS_PER_DEGREE, mask, ignore } = {}) {
  checkPair(expected, actual);
  const { width, height } = expected;
  checkOptions(pixelsPerDegree, { mask, ignore }, width * height);
  return comparePremultiplied([premultiply(expected.data), premultiply(actual.data)], width, height, { pixelsPerDegree, mask, ignore });
}

function checkOptions(pixelsPerDegree, maps, pixels) {
  if (!(pixelsPerDegree >= 1 && pixelsPerDegree <= 1000)) {
    throw new TelarError('E_OPTION', `options.pixelsPerDegree: expected a number from 1 to 1000, got ${shown(pixelsPerDegree)}`);
  }
  for (const [name, map] of Object.entries(maps)) {
    if (map !== undefined && !(map instanceof Uint8Array && map.length === pixels)) {
      throw new TelarError('E_OPTION', `options.${name}: expected a Uint8Array of ${pixels} bytes, one a pixel, got ${shown(map?.length ?? map)}`);
    }
  }
  if (maps.ignore && !maps.ignore.includes(0)) throw new TelarError('E_OPTION', 'options.ignore: it leaves no pixel to compare');
}

/** What is ignored is made equal, so that no filter carries it to its neighbours. */
function hideIgnored([expected, actual], ignore) {
  const hidden = Uint8Array.from(actual);
  ignore.forEach((value, p) => {
    if (value !== 0) hidden.set(expected.subarray(p * 4, p * 4 + 4), p * 4);
  });
  return [expected, hidden];
}

/**
 * The same of pixels with premultiplied alpha, as a drawing buffer holds them.
 * @internal
 * @param {[Uint8Array, Uint8Array]} pair expected and actual, RGBA
 * @returns {Comparison}
 */
function comparePremultiplied(given, width, height, { pixelsPerDegree = PIXELS_PER_DEGREE, mask, ignore } = {}) {
  const pair = ignore ? hideIgnored(given, ignore) : given;
  const maps = worstMaps(pair, width, height, pixelsPerDegree);
  const regions = maskedRegions(...pair, width, height, mask).map((region, p) => (ignore?.[p] ? IGNORED : region));
  const figures = Object.entries(REGIONS).map(([name, belongs]) => [name, figuresOf(pair, maps, regions, belongs, width)]);
  return { width, height, ...Object.fromEntries(figures), ssim: maps.ssim, flipMap: maps.flip };
}

/** Mean squared difference of the three channels of each pixel, of values in [0, 1]. */
function squaredMap(a, b, amount) {
  const map = new Float32Array(a.length / 4);
  for (let p = 0; p < map.length; p++) {
    for (let c = p * 4; c < p * 4 + 3; c++) map[p] += (amount(a[c]) - amount(b[c])) ** 2 / 3;
  }
  return map;
}

/** The pair over black, and where alpha lets the background through over white too: opaque RGBA. */
const overBackgrounds = (pair) => (pair.every(isOpaque) ? [0] : [0, 255]).map((grey) => pair.map((pixels) => over(pixels, grey)));

/** The larger value of each pixel. */
const largest = ([first, ...rest]) => (rest.length === 0 ? first : first.map((value, i) => Math.max(value, ...rest.map((map) => map[i]))));

function worstMaps(pair, width, height, pixelsPerDegree) {
  const pictures = overBackgrounds(pair);
  const worst = (map) => largest(pictures.map(([a, b]) => map(a, b)));
  const similarities = pictures.map(([a, b]) => ssim(a, b, width, height));
  return {
    flip: worst((a, b) => flipMap(a, b, width, height, pixelsPerDegree)),
    deltaE: worst(ciede2000Map),
    squared: worst((a, b) => squaredMap(a, b, (byte) => byte / 255)),
    squaredLinear: worst((a, b) => squaredMap(a, b, (byte) => LINEAR[byte])),
    ssim: similarities.includes(null) ? null : Math.min(...similarities),
  };
}

function figuresOf([expected, actual], maps, regions, belongs, width) {
  const histogram = new DifferenceHistogram();
  const chosen = new Uint32Array(regions.length);
  let count = 0;
  for (let i = 0; i < regions.length; i++) {
    if (!belongs(regions[i])) continue;
    histogram.add(channelDifference(expected, actual, i * 4), i);
    chosen[count++] = i;
  }
  if (count === 0) return null;
  const valuesOf = (map) => new Float32Array(count).map((_, i) => map[chosen[i]]);
  const [flip, deltaE] = [valuesOf(maps.flip).sort(), valuesOf(maps.deltaE).sort()];
  return {
    ...histogram.figures(width),
    rmse: Math.sqrt(mean(valuesOf(maps.squared))),
    rmseLinear: Math.sqrt(mean(valuesOf(maps.squaredLinear))),
    flip: {
      mean: mean(flip),
      weightedMedian: weightedPercentile(flip, 0.5),
      weightedQuartile1: weightedPercentile(flip, 0.25),
      weightedQuartile3: weightedPercentile(flip, 0.75),
      max: flip.at(-1),
    },
    deltaE: { mean: mean(deltaE), p95: percentile(deltaE, 0.95), max: deltaE.at(-1) },
  };
}
