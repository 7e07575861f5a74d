import { CARE_SYMBOLS } from '../../sheet/care.mjs';
import { keyRows } from './tables.mjs';

/** The tables of js/docs/sheet.md. */

const BEGIN = '<!-- keys: written by js/build/docs/generate.mjs from js/sheet/table -->';
const END = '<!-- end of keys -->';

const quoted = (key) => `\`${key}\``;

/** As the table has them; they are listed once, beneath it. */
const SYMBOLS = Object.keys(CARE_SYMBOLS).map(quoted);

/**
 * The page with the table of the spec's keys in its place.
 * @param {string} page
 * @param {object} schema JSON Schema of the spec
 */
export function withSpecTable(page, schema) {
  const [from, to] = [page.indexOf(BEGIN), page.indexOf(END)];
  if (from < 0 || to < from) throw new Error('js/docs/sheet.md has no place for the table of keys');
  const rows = keyRows(schema).map((line) => line.replace(SYMBOLS.join(' '), 'symbols, see below'));
  return [page.slice(0, from) + BEGIN, '', ...rows, '', `Care symbols: ${SYMBOLS.join(', ')}.`, '', page.slice(to)].join('\n');
}
