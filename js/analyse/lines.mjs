import { textTable } from '../compare/figures.mjs';
import { inWords } from './words.mjs';

/** An analysis as text for a terminal. */

/** A positive figure: four decimals below 1, three digits above. */
export const shortFigure = (value) => (value === 0 ? '0' : value < 0.00005 ? '<0.0001' : value < 1 ? value.toFixed(4) : String(Number(value.toPrecision(3))));
const rangeText = ({ min, max }) => `${shortFigure(min)}..${shortFigure(max)}`;
export const percent = (share) => `${Math.round(share * 100)} %`;
export const ranksText = ([best, worst]) => (best === worst ? String(best) : `${best}-${worst}`);

const HEADINGS = ['rank', 'term', 'from', 'to', 'FLIP', 'range', 'last', 'dE00', 'p95', 'share', 'ranks', 'changes'];

/**
 * The ranking.
 * @param {import('./analyse.mjs').Analysis} analysis
 * @returns {string[]}
 */
export function rankLines({ rows, cells, names }) {
  const lines = rows.map((row) => [
    String(row.rank),
    row.slot,
    row.from,
    row.to,
    shortFigure(row.alone.flip.mean),
    rangeText(row.alone.flip),
    shortFigure(row.rest.flip.mean),
    row.alone.deltaE.mean.toFixed(2),
    row.alone.deltaEp95.mean.toFixed(2),
    percent(row.share),
    ranksText(row.ranks),
    row.words + (row.interaction ? `; ${row.interaction}` : ''),
  ]);
  const whole = cells.map(({ target, light, all }) => [
    `${target}, ${light}`,
    `FLIP ${shortFigure(all.flip.mean)}`,
    `dE00 ${all.deltaE.mean.toFixed(2)}`,
    `p95 ${all.deltaE.p95.toFixed(2)}`,
    inWords(all),
  ]);
  const heading = `${names.to} against ${names.from}${rows.length > 0 ? ', all terms' : ''}:`;
  if (rows.length === 0) return [heading, ...textTable(whole, [0, 1, 2, 3, 4])];
  return [
    heading,
    ...textTable(whole, [0, 1, 2, 3, 4]),
    '',
    'One term at a time; FLIP and CIEDE2000 on the cloth: swapped alone, and as the last of all:',
    ...textTable([HEADINGS, ...lines], [1, 2, 3, 11]),
  ];
}

/**
 * What --terms prints.
 * @param {Record<string, string[]>} slots
 * @param {Record<string, object>} bases - By name, with every slot.
 * @returns {string[]}
 */
export function termLines(slots, bases) {
  const marks = (slot, term) => Object.keys(bases).filter((base) => bases[base][slot] === term);
  return Object.entries(slots).flatMap(([slot, terms]) => [
    slot,
    ...terms.map((term) =>
      `  ${term.padEnd(24)}${marks(slot, term)
        .map((base) => `in ${base}`)
        .join(', ')}`.trimEnd(),
    ),
  ]);
}
