import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { checkText } from './fonts.mjs';
import { ABOUT } from './read.mjs';

/** Lists of colours that a user brings: CSV (RFC 4180, or with semicolons) of a name and CIE Lab. */

const BYTES_MAX = 4 * 2 ** 20;
const ROWS_MAX = 50_000;
const NAME_MAX = 120;

const SEPARATORS = [';', '\t', ','];
/** Columns by their heading; without a heading a row is name, L, a, b. */
const HEADINGS = { name: /^(name|colou?r|nombre|color name)$/i, L: /^(cie[ -]?)?L\*?$/i, a: /^(cie[ -]?)?a\*?$/i, b: /^(cie[ -]?)?b\*?$/i };

const [PLACE, POINTER] = ['spec.colourList.file', '/colourList/file'];

const wrong = (message) => new TelarError(ABOUT.code, `${PLACE}: ${message}`, { pointer: POINTER });

/** End of a quoted cell that begins at `at`: the quote that is not doubled. */
function quoteEnd(line, at) {
  for (let end = line.indexOf('"', at + 1); end >= 0; end = line.indexOf('"', end + 2)) if (line[end + 1] !== '"') return end;
  return -1;
}

/** Cells of a line; a quoted one may hold the separator and doubled quotes. @returns {string[] | undefined} undefined where quotes do not match */
function cellsOf(line, separator) {
  const cells = [];
  for (let at = 0; at <= line.length; ) {
    const isQuoted = line[at] === '"';
    const from = isQuoted ? quoteEnd(line, at) + 1 : at;
    const end = line.indexOf(separator, from);
    const stop = end < 0 ? line.length : end;
    if (isQuoted && (from === 0 || line.slice(from, stop).trim() !== '')) return undefined;
    cells.push(isQuoted ? line.slice(at + 1, from - 1).replaceAll('""', '"') : line.slice(at, stop).trim());
    at = stop + 1;
  }
  return cells;
}

/** A number, with a decimal comma where commas do not separate. */
const numberOf = (text, separator) => (text === undefined || text === '' ? Number.NaN : Number(separator === ',' ? text : text.replace(',', '.')));

/** @returns {Record<string, number> | undefined} index of each column; undefined where the row is no heading */
function columnsOf(cells) {
  const found = Object.entries(HEADINGS).map(([key, pattern]) => [key, cells.findIndex((cell) => pattern.test(cell.trim()))]);
  return found.every(([, index]) => index >= 0) ? Object.fromEntries(found) : undefined;
}

function colourOf(cells, columns, { separator, line, fonts }) {
  const name = cells?.[columns.name]?.trim() ?? '';
  const lab = ['L', 'a', 'b'].map((key) => numberOf(cells?.[columns[key]], separator));
  const isLab = lab.every(Number.isFinite) && lab[0] >= 0 && lab[0] <= 100 && Math.abs(lab[1]) <= 200 && Math.abs(lab[2]) <= 200;
  if (name === '' || name.length > NAME_MAX || !isLab)
    throw wrong(
      `line ${line}: expected a name of at most ${NAME_MAX} characters, L in [0, 100], and a and b in [-200, 200], got ${shown(cells?.join(separator) ?? '')}`,
    );
  if (fonts) checkText(name, fonts, { place: `${PLACE}: line ${line}`, pointer: POINTER });
  return { name, lab };
}

/**
 * @param {Uint8Array} bytes
 * @param {object} [fonts] of readFonts, which have to have the characters of the names
 * @returns {{name: string, lab: number[]}[]}
 * @throws {TelarError} E_SPEC with the line
 */
export function readColourList(bytes, fonts) {
  if (bytes.length > BYTES_MAX) throw wrong(`it has ${bytes.length} bytes, more than ${BYTES_MAX}`);
  const lines = new TextDecoder()
    .decode(bytes)
    .split(/\r\n|\n|\r/)
    .map((text, i) => ({ text, line: i + 1 }))
    .filter(({ text }) => text.trim() !== '');
  if (lines.length === 0) throw wrong('expected rows of a name, L, a and b, got none');
  if (lines.length > ROWS_MAX) throw wrong(`it has ${lines.length} rows, more than ${ROWS_MAX}`);
  const separator = SEPARATORS.find((each) => lines[0].text.includes(each)) ?? ',';
  const heading = columnsOf(cellsOf(lines[0].text, separator) ?? []);
  const columns = heading ?? { name: 0, L: 1, a: 2, b: 3 };
  const rows = heading ? lines.slice(1) : lines;
  if (rows.length === 0) throw wrong('expected rows of a name, L, a and b beneath the heading, got none');
  return rows.map(({ text, line }) => colourOf(cellsOf(text, separator), columns, { separator, line, fonts }));
}
