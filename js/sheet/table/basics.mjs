import { LINES, number, text, vector } from '../../shot/table/rows.mjs';

/** Rows that many parts of a spec share, and how much of each it may hold. */

/** Most characters of a name, of a cell of a table, and of a paragraph. */
export const NAME_MAX = 120;
const CELL_MAX = 500;
const PARAGRAPH_MAX = 4000;

/** Most rows of a list. */
export const MOST = Object.freeze({
  views: 24,
  callouts: 500,
  details: 48,
  measures: 300,
  colourways: 48,
  bill: 500,
  notes: 500,
  symbols: 24,
  sizes: 40,
  named: 200,
});

/** A name on one line. */
export const name = (doc, rest = {}) => text(doc, `a text of at most ${NAME_MAX} characters on one line`, { max: NAME_MAX, ...rest });

/** A name that may be left out. */
export const nameIfAny = (doc, rest = {}) => name(doc, { optional: true, ...rest });

/** What stands in a cell of a table: lines are broken where it needs to. */
export const cell = (doc, rest = {}) => text(doc, `a text of at most ${CELL_MAX} characters`, { max: CELL_MAX, pattern: LINES, optional: true, ...rest });

/** A paragraph, or several with line feeds between. */
export const paragraph = (doc, rest = {}) =>
  text(doc, `a text of at most ${PARAGRAPH_MAX} characters`, { max: PARAGRAPH_MAX, pattern: LINES, optional: true, ...rest });

/** Largest length in the spec's `units`. */
export const LENGTH_MAX = 1e5;

/** A length in the spec's `units`. */
export const lengthIn = (doc, rest = {}) =>
  number(doc, { what: 'a length', unit: "the spec's `units`", min: -LENGTH_MAX, max: LENGTH_MAX, optional: true, ...rest });

/** A place in the model, metres. */
export const place = (doc, rest = {}) => vector(doc, rest);

/** An image by name: the caller of the API resolves it, the command line reads it beside the spec. */
export const image = (doc) => nameIfAny(`${doc}: name of a PNG, JPEG or WebP file beside the spec`);
