import { bestSwaps, closestRelease, rankedSwaps } from '../../js/analyse/releases.mjs';
import { channelDifference } from '../../js/compare/channels.mjs';
import { familyName } from '../../js/shot/three_terms.mjs';
import { withinCoverage } from '../parity/metrics.mjs';

/** Mean over pixels of the channel that differs most, in 1/255. */
function meanDifference(expected, actual) {
  let sum = 0;
  for (let i = 0; i < expected.length; i += 4) sum += channelDifference(expected, actual, i);
  return sum / (expected.length / 4);
}

/**
 * Why telar's picture of a case is not that of a release.
 * @typedef {object} Explanation
 * @property {number} distance - Mean difference without a swap, in 1/255.
 * @property {import('../../js/analyse/releases.mjs').Swap[]} swaps - Terms that, put in alone, leave least of it: one, or several that show alike.
 * @property {import('../../js/analyse/releases.mjs').Fit} [release] - Another release that fits better, where no term does.
 *
 * Draws the case with each other term, and where none explains it as each other release.
 * @param {import('../parity/draw_cases.mjs').Result} result - Of a case over the bar.
 * @param {'three' | object} shading - What telar drew it with.
 * @param {import('../parity/server.mjs').Server} server
 * @returns {Promise<Explanation>}
 */
export async function explained({ item, inputs, expected }, shading, server) {
  const image = withinCoverage(expected.image);
  const distanceOf = async (wanted) => meanDifference(image, await server.draw({ ...inputs, shot: { ...item.shot, shading: wanted } }));
  const ranked = await rankedSwaps(shading, distanceOf);
  const swaps = bestSwaps(ranked);
  if (swaps.length > 0) return { distance: ranked.distance, swaps };
  const { best, isBetter } = await closestRelease(shading, { toneMapping: item.shot.toneMapping, distanceOf });
  return { distance: ranked.distance, swaps, release: isBetter ? best : undefined };
}

const figure = (distance) => `${Number(distance.toPrecision(2))}/255`;

/** @param {Explanation} explanation */
export function explanationText({ distance, swaps, release }) {
  if (swaps.length > 0) {
    const names = swaps.map(({ slot, from, to }) => `${slot}: "${to}" in place of "${from}"`).join(', or ');
    return `explained by ${names} (mean difference ${figure(swaps[0].distance)}, was ${figure(distance)})`;
  }
  if (release) return `looks like ${familyName(release)} (mean difference ${figure(release.distance)}, was ${figure(distance)})`;
  return `no single term and no other release explains a mean difference of ${figure(distance)}`;
}
