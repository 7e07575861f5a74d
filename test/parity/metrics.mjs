import { channelDifference, DifferenceHistogram } from '../../js/compare/channels.mjs';
import { flipMap } from '../../js/compare/flip.mjs';
import { judge } from '../../js/compare/gates.mjs';
import { isOpaque, over } from '../../js/compare/image.mjs';
import { BAND, INSIDE, pairRegions } from '../../js/compare/regions.mjs';

export { premultiply } from '../../js/compare/image.mjs';

/**
 * How far two pictures of one shot are apart, of telar/compare what its gate "parity" asks for.
 * @typedef {object} Difference
 * @property {Region | null} interior - Pixels off the silhouette, within the object, and beside it where the background is
 *   drawn; null where there is none.
 * @property {(Region & {flip: {mean: number}}) | null} edge - The other pixels of the object.
 * @property {import('../../js/compare/gates.mjs').Verdict} verdict
 * @property {boolean} pass - verdict.pass
 *
 * @typedef {import('../../js/compare/channels.mjs').ChannelFigures} Region
 *
 * @typedef {object} Pictures - All RGBA8, premultiplied, top row first, width * height.
 * @property {Uint8Array} expected - The browser's.
 * @property {Uint8Array} actual - The server's.
 * @property {Uint8Array} mask - The browser's without background: alpha > 0 is the object.
 * @property {number} width
 * @property {number} height
 * @property {boolean} background - Whether pixels beside the object show something.
 */

/**
 * @param {Pictures} pictures
 * @returns {Difference}
 */
export function difference(pictures) {
  const { expected, actual, width, height } = pictures;
  if (actual.length !== expected.length) throw new Error(`expected ${expected.length} bytes, got ${actual.length}`);
  const regions = regionsOf(pictures);
  const interior = figuresOf(expected, actual, regions, INSIDE, width);
  const edge = figuresOf(expected, actual, regions, BAND, width);
  if (edge) edge.flip = { mean: meanWithin(worstFlip([expected, actual], width, height), regions, BAND) };
  const verdict = judge({ interior, edge }, 'parity');
  return { interior, edge, verdict, pass: verdict.pass };
}

/**
 * What a picture with straight alpha keeps of a drawing buffer, as the browser's own PNG of the canvas does: no colour above
 * its coverage. Before nothing, three.js gives transmissive surfaces and their highlights more.
 * @param {Uint8Array} pixels - RGBA8, premultiplied.
 */
export function withinCoverage(pixels) {
  return pixels.map((value, i) => Math.min(value, pixels[i | 3]));
}

/** Interior figures of several pictures against one, all over the pixels that are interior in `pictures`. */
export function interiorDistances(pictures, reference, others) {
  const regions = regionsOf(pictures);
  return others.map((other) => figuresOf(reference, other, regions, INSIDE, pictures.width));
}

/** FLIP of each pixel of premultiplied pictures, over the background that shows it worse: telar/compare finds it so, along with all its other figures. */
function worstFlip(pair, width, height) {
  const [first, second = first] = (pair.every(isOpaque) ? [0] : [0, 255]).map((grey) => flipMap(...pair.map((pixels) => over(pixels, grey)), width, height));
  return first.map((value, i) => Math.max(value, second[i]));
}

/** Regions as telar/compare defines them; before a background, whose alpha tells nothing, the mask tells the object. */
function regionsOf({ expected, actual, mask, width, height, background }) {
  const object = background ? Uint8Array.from({ length: width * height }, (_, i) => mask[i * 4 + 3]) : undefined;
  return pairRegions(expected, actual, width, height, object);
}

function figuresOf(expected, actual, regions, wanted, width) {
  const histogram = new DifferenceHistogram();
  regions.forEach((region, i) => {
    if (region === wanted) histogram.add(channelDifference(expected, actual, i * 4), i);
  });
  const figures = histogram.figures(width);
  return figures.pixels > 0 ? figures : null;
}

function meanWithin(map, regions, wanted) {
  let [sum, count] = [0, 0];
  regions.forEach((region, i) => {
    if (region !== wanted) return;
    sum += map[i];
    count++;
  });
  return sum / count;
}
