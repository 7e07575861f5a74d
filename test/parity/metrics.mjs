import { channelDifference, DifferenceHistogram } from '../../js/compare/channels.mjs';
import { GATES } from '../../js/compare/gates.mjs';
import { BAND, OUTSIDE, regionsOf } from '../../js/compare/regions.mjs';

export { premultiply } from '../../js/compare/image.mjs';

/**
 * How far two pictures of one shot are apart.
 * @typedef {object} Difference
 * @property {Region} interior - Pixels at least EDGE_PIXELS from the silhouette, within the object, and beside it where
 *   the background is drawn.
 * @property {Region} edge - The other pixels that touch the object.
 * @property {boolean} pass - The interior keeps within the bar.
 *
 * @typedef {import('../../js/compare/channels.mjs').ChannelFigures} Region
 */

const limitOf = (figure) => GATES.parity.find((check) => check.region === 'interior' && check.figure === figure).limit;

/** Bar of the interior, in 1/255: no pixel above `max`, 99.9 % of them at most `p999`. */
export const BAR = { max: limitOf('max'), p999: limitOf('p999') };

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
  const object = Uint8Array.from({ length: width * height }, (_, i) => (mask[i * 4 + 3] > 0 ? 1 : 0));
  const histograms = { interior: new DifferenceHistogram(), edge: new DifferenceHistogram() };
  regionsOf(object, width, height).forEach((region, i) => {
    if (region === OUTSIDE && !background) return;
    histograms[region === BAND ? 'edge' : 'interior'].add(channelDifference(expected, actual, i * 4), i);
  });
  const interior = histograms.interior.figures(width);
  return {
    interior,
    edge: histograms.edge.figures(width),
    pass: interior.pixels > 0 && interior.max <= BAR.max && interior.p999 <= BAR.p999,
  };
}
