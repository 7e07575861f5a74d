import { mean } from '../compare/statistics.mjs';
import { inWords } from './words.mjs';

/**
 * Which term changes the pictures most.
 *
 * @typedef {object} Cell - One target in one light.
 * @property {string} target
 * @property {string} light
 * @property {import('./differences.mjs').Difference} all - Second shading against the first.
 * @property {Record<string, {alone: import('./differences.mjs').Difference, rest: import('./differences.mjs').Difference}>} terms -
 *   By slot. alone: the first shading with this term swapped, against the first (main effect); rest: the second shading
 *   against the second with this term put back (what is left of the effect when every other term is swapped).
 *
 * @typedef {object} Spread - Of one figure over the cells.
 * @property {number} mean
 * @property {number} deviation - Standard deviation of the cells (n - 1), 0 for one cell.
 * @property {number} min
 * @property {number} max
 *
 * @typedef {object} Row
 * @property {string} slot
 * @property {string} from
 * @property {string} to
 * @property {number} rank - By FLIP, 1 = most; terms without any effect share the last.
 * @property {number} rankByColour - By CIEDE2000.
 * @property {[number, number]} ranks - Best and worst rank in a single cell.
 * @property {{flip: Spread, deltaE: Spread, deltaEp95: Spread}} alone
 * @property {{flip: Spread, deltaE: Spread, deltaEp95: Spread}} rest
 * @property {number} effect - Mean FLIP of both, which the rank goes by.
 * @property {number} share - effect over the FLIP of the whole difference.
 * @property {string} interaction - Empty where the term changes as much alone as with the others swapped.
 * @property {string} words - Direction, in the cell that the term alone changes most.
 */

/** @param {number[]} values not empty @returns {Spread} */
export function spread(values) {
  const middle = mean(values);
  const squares = values.reduce((sum, value) => sum + (value - middle) ** 2, 0);
  const deviation = values.length > 1 ? Math.sqrt(squares / (values.length - 1)) : 0;
  return { mean: middle, deviation, min: Math.min(...values), max: Math.max(...values) };
}

const spreads = (differences) => ({
  flip: spread(differences.map(({ flip }) => flip.mean)),
  deltaE: spread(differences.map(({ deltaE }) => deltaE.mean)),
  deltaEp95: spread(differences.map(({ deltaE }) => deltaE.p95)),
});

/** Ranks of values, 1 = largest; equal ones share the better. */
export const ranksOf = (values) => values.map((value) => 1 + values.filter((other) => other > value).length);

/** Factors between the two effects up to which they count as the same, and FLIP that is too small to speak of. */
const SAME_WITHIN = 1.25;
const FLIP_WORTH = 0.002;

/** @param {number} alone mean FLIP @param {number} rest */
export function interactionOf(alone, rest) {
  if (Math.max(alone, rest) < FLIP_WORTH || Math.max(alone, rest) <= SAME_WITHIN * Math.min(alone, rest)) return '';
  if (Math.min(alone, rest) === 0) return alone > rest ? 'only while the others are not swapped' : 'only once others are swapped';
  const factor = Math.max(alone, rest) / Math.min(alone, rest);
  return `${alone > rest ? 'less' : 'more'} once the others are swapped (x ${Number((alone > rest ? 1 / factor : factor).toPrecision(2))})`;
}

/** Terms of a cell that lead. */
const LEADING_TERMS = 3;

/** @param {Cell} cell @returns {string[]} slots of the terms that change it most by themselves, the one that does most first */
export const strongestIn = ({ terms }) =>
  Object.entries(terms)
    .filter(([, { alone }]) => flipOf(alone) > 0)
    .sort(([, a], [, b]) => flipOf(b.alone) - flipOf(a.alone))
    .slice(0, LEADING_TERMS)
    .map(([slot]) => slot);

const effectIn = ({ alone, rest }, figure) => (figure(alone) + figure(rest)) / 2;
const flipOf = ({ flip }) => flip.mean;
const colourOf = ({ deltaE }) => deltaE.mean;

/** The words of the cell that the term changes most, and which that is; where it changes nothing alone, those of it as the last. */
function wordsOf(cells, slot) {
  const which = cells.some(({ terms }) => flipOf(terms[slot].alone) > 0) ? 'alone' : 'rest';
  const amount = ({ terms }) => flipOf(terms[slot][which]);
  const worst = cells.reduce((most, cell) => (amount(cell) > amount(most) ? cell : most));
  const words = inWords(worst.terms[slot][which]);
  if (words === 'no change') return words;
  return `${which === 'rest' ? 'as the last: ' : ''}${words}${cells.length === 1 ? '' : ` (${worst.target}, ${worst.light})`}`;
}

/**
 * @param {Cell[]} cells not empty
 * @param {import('./swaps.mjs').Term[]} terms
 * @returns {Row[]} the term that changes most first
 */
export function rank(cells, terms) {
  const effects = (figure) => terms.map(({ slot }) => mean(cells.map((cell) => effectIn(cell.terms[slot], figure))));
  const [byFlip, byColour] = [effects(flipOf), effects(colourOf)];
  const [flipRanks, colourRanks] = [ranksOf(byFlip), ranksOf(byColour)];
  const cellRanks = cells.map((cell) => ranksOf(terms.map(({ slot }) => effectIn(cell.terms[slot], flipOf))));
  const whole = mean(cells.map(({ all }) => flipOf(all)));
  const rows = terms.map((term, i) => {
    const [alone, rest] = ['alone', 'rest'].map((which) => spreads(cells.map((cell) => cell.terms[term.slot][which])));
    const own = cellRanks.map((ranks) => ranks[i]);
    return {
      ...term,
      rank: flipRanks[i],
      rankByColour: colourRanks[i],
      ranks: [Math.min(...own), Math.max(...own)],
      alone,
      rest,
      effect: byFlip[i],
      share: whole > 0 ? byFlip[i] / whole : 0,
      interaction: interactionOf(alone.flip.mean, rest.flip.mean),
      words: wordsOf(cells, term.slot),
    };
  });
  return rows.sort((a, b) => a.rank - b.rank || a.rankByColour - b.rankByColour);
}
