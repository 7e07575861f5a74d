import { families, familyOf, releaseOf, resolveThree, termsOfRevision, THREE_SLOTS } from '../shot/three_terms.mjs';
import { TONE_MAPPINGS } from '../shot/table/tone_mappings.mjs';

/**
 * Which release of three.js a picture is of, and which term of it differs: found by drawing them all.
 *
 * @typedef {(shading: object) => Promise<number>} DistanceOf - Draws with a shading; how far that is from the picture.
 * @typedef {{from: number, to: number, distance: number}} Fit - Releases that draw alike, both inclusive.
 * @typedef {{slot: string, from: string, to: string, distance: number}} Swap - One term in place of another.
 */

/** A picture fits another release better where that leaves at most this part of the difference. */
const REST = 0.5;

/** A term that leaves no more than this part of the difference is the one: no other needs to be drawn. */
const FOUND = 0.02;

/** The family of a shading, or as many as draw what is looked at alike. */
function rangeAround(fits, best) {
  const at = fits.indexOf(best);
  const isSame = (fit) => fit.distance === best.distance;
  let [first, last] = [at, at];
  while (first > 0 && isSame(fits[first - 1])) first--;
  while (last + 1 < fits.length && isSame(fits[last + 1])) last++;
  return { from: fits[first].from, to: fits[last].to, distance: best.distance };
}

/**
 * The release that fits a picture best.
 * @param {'three' | object} shading - Stock three.js, as the shot names it.
 * @param {{toneMapping: string, distanceOf: DistanceOf}} options - Releases that lack the tone mapping are left out.
 * @returns {Promise<{named: Fit, best: Fit, isBetter: boolean, drawn: number}>} `best` takes in neighbours that draw the same.
 */
export async function closestRelease(shading, { toneMapping, distanceOf }) {
  const named = { ...familyOf(releaseOf(shading)), distance: await distanceOf(shading) };
  const drawable = families().filter(({ to }) => !(to < TONE_MAPPINGS[toneMapping].since));
  const fits = [];
  for (const family of drawable) {
    const isNamed = family.from === named.from;
    fits.push(isNamed ? named : { ...family, distance: await distanceOf({ base: 'three', revision: family.to }) });
  }
  const best = fits.reduce((least, fit) => (fit.distance < least.distance ? fit : least), named);
  return { named, best: rangeAround(fits, best), isBetter: best.distance < REST * named.distance, drawn: fits.length };
}

/**
 * Swaps one term after the other, each alone, until one explains the difference.
 * @param {'three' | object} shading - Stock three.js.
 * @param {DistanceOf} distanceOf
 * @returns {Promise<{distance: number, swaps: Swap[], drawn: number}>} `distance` without a swap; `swaps` the best first.
 */
export async function rankedSwaps(shading, distanceOf) {
  const distance = await distanceOf(shading);
  const swaps = [];
  for (const swap of swapsOf(shading)) {
    swaps.push({ ...swap, distance: await distanceOf(swap.shading) });
    if (swaps.at(-1).distance <= FOUND * distance) break;
  }
  swaps.sort((a, b) => a.distance - b.distance);
  return { distance, swaps: swaps.map(({ shading: _, ...swap }) => swap), drawn: swaps.length };
}

/** Each other term of each slot, put into a shading alone. */
function swapsOf(shading) {
  const own = { ...termsOfRevision(releaseOf(shading)), ...(typeof shading === 'string' ? {} : shading) };
  return Object.entries(THREE_SLOTS).flatMap(([slot, terms]) =>
    Object.keys(terms)
      .filter((to) => to !== own[slot])
      .map((to) => ({ slot, from: own[slot], to, shading: resolveThree({ ...own, base: 'three', revision: releaseOf(shading), [slot]: to }) })),
  );
}

/** Swaps that leave as little as the best one does: where no other term shows, several are one. */
export const bestSwaps = ({ distance, swaps }) => swaps.filter((swap) => swap.distance === swaps[0].distance && swap.distance < REST * distance);
