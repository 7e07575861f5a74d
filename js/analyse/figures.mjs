import { inWords } from './words.mjs';

/** An analysis as plain figures: what --json prints and what lies beside the report. */

const plain = (difference) => ({ ...difference, words: inWords(difference) });

/**
 * @param {import('./analyse.mjs').Analysis} analysis
 * @returns {{from: object, to: object, ranking: import('./ranking.mjs').Row[], cells: object[]}} without pictures and curves
 */
export function figuresOf({ swaps, rows, cells }) {
  return {
    from: swaps.shadings.from,
    to: swaps.shadings.to,
    ranking: rows,
    cells: cells.map(({ target, light, cloth, all, terms }) => ({
      target,
      light,
      pixels: cloth.pixels.length,
      all: plain(all),
      terms: Object.fromEntries(Object.entries(terms).map(([slot, { alone, rest }]) => [slot, { alone: plain(alone), rest: plain(rest) }])),
    })),
  };
}
