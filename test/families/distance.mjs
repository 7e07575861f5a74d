import { channelDifference, DifferenceHistogram } from '../../js/compare/channels.mjs';
import { BAND, INSIDE, pairRegions } from '../../js/compare/regions.mjs';
import { readPixels } from './draw.mjs';

/**
 * How far two pictures of one case are apart, inside of the model and of a background that is drawn.
 * @param {import('./cases.mjs').CASES[number]} item
 * @param {import('./draw.mjs').Picture} expected
 * @param {import('./draw.mjs').Picture} actual
 * @returns {{mean: number, max: number, edge: number} | null} In 1/255 of the channel that differs most, over pixels; `edge` is the largest
 *   along silhouettes. Null where one of the two is absent.
 */
export function distance({ shot }, expected, actual) {
  if (expected.absent || actual.absent) return null;
  if (expected.image === actual.image) return { mean: 0, max: 0, edge: 0 };
  const { width, height } = shot.size;
  const [a, b, mask] = [expected.image, actual.image, expected.mask].map(readPixels);
  const object = shot.background === 'transparent' ? undefined : Uint8Array.from({ length: width * height }, (_, i) => mask[i * 4 + 3]);
  const histograms = { [INSIDE]: new DifferenceHistogram(), [BAND]: new DifferenceHistogram() };
  pairRegions(a, b, width, height, object).forEach((region, i) => histograms[region]?.add(channelDifference(a, b, i * 4), i));
  const [inside, edge] = [INSIDE, BAND].map((region) => histograms[region].figures(width));
  return { mean: inside.mean, max: inside.max, edge: edge.max };
}
