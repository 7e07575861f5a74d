import { bestSwaps, closestRelease, rankedSwaps } from '../analyse/index.mjs';
import { meanDifference } from '../compare/hints.mjs';
import { familyName, familyOf, isRelease, releaseOf } from '../shot/three_terms.mjs';

/** Whether a picture is of another release of three.js than its shot names. */

const text = (distance) => `${Number(distance.toPrecision(2))}/255`;

/** Seconds since then, as a hint tells what it cost. */
const costOf = (drawn, begin) => `${drawn} drawn in ${((performance.now() - begin) / 1000).toFixed(1)} s`;

/**
 * Draws the shot again as other releases of three.js do, and, where it is asked for, with other terms.
 * @param {object} what
 * @param {import('../compare/image.mjs').Image} what.expected
 * @param {object} what.shot - Of the expected picture.
 * @param {(shading: object) => Promise<import('../compare/image.mjs').Image>} what.draw - In the expected picture's size.
 * @param {boolean} [what.explain] - Looks for the term that differs, too, and says so where nothing fits.
 * @returns {Promise<Array<{cause: string, message: string}>>}
 */
export async function releaseHints({ expected, shot, draw, explain = false }) {
  const { shading = 'three', toneMapping = 'neutral' } = shot;
  if (!isRelease(shading)) return [];
  const distances = new Map();
  const distanceOf = async (wanted) => {
    const key = JSON.stringify(wanted);
    if (!distances.has(key)) distances.set(key, meanDifference(expected.data, (await draw(wanted)).data));
    return distances.get(key);
  };
  const begin = performance.now();
  const found = await closestRelease(shading, { toneMapping, distanceOf });
  const release = releaseHint(found, { shading, cost: costOf(found.drawn, begin), explain });
  return explain ? [...release, await termHint(found.isBetter ? { base: 'three', revision: found.best.to } : shading, distanceOf)] : release;
}

function releaseHint({ named, best, isBetter }, { shading, cost, explain }) {
  const asked = familyName(familyOf(releaseOf(shading)));
  if (isBetter) {
    const message =
      `the expected picture looks like ${familyName(best)}: mean difference ${text(best.distance)}, where it is ${text(named.distance)} ` +
      `as ${asked}; ask for shading three@${best.to} (families of releases: ${cost})`;
    return [{ cause: 'release', message, from: best.from, to: best.to }];
  }
  return explain ? [{ cause: 'release', message: `no other release of three.js fits better than ${asked} (families of releases: ${cost})` }] : [];
}

async function termHint(shading, distanceOf) {
  const begin = performance.now();
  const ranked = await rankedSwaps(shading, distanceOf);
  const best = bestSwaps(ranked);
  const cost = `terms: ${costOf(ranked.drawn, begin)}`;
  if (best.length === 0) return { cause: 'term', message: `no single term of three.js explains a mean difference of ${text(ranked.distance)} (${cost})` };
  const names = best.map(({ slot, from, to }) => `${slot} "${to}" in place of "${from}"`).join(', or ');
  const message = `what differs is ${names}: mean difference ${text(best[0].distance)}, where it is ${text(ranked.distance)} (${cost})`;
  return { cause: 'term', message, slots: best.map(({ slot, to }) => ({ slot, term: to })) };
}
