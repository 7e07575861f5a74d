/**
 * What the table of the shot is written with. A row is plain data: what a key takes, what it is where it is left out, what it is in a
 * resolved shot, and what it means. js/shot/schema.mjs makes of it what checks a shot, js/shot/resolved_schema.mjs what checks a
 * resolved one, js/build/docs the pages, the types and the C++ that reads it.
 *
 * @typedef {object} Row
 * @property {'number' | 'boolean' | 'choice' | 'literal' | 'text' | 'vector' | 'extents' | 'colour' | 'index' | 'bytes' | 'object' | 'record' | 'list' | 'union' | 'variants'} kind
 * @property {string} doc - What it means, with its unit.
 * @property {string} [unit] - Of a number.
 * @property {unknown} [default] - Value where the key is left out.
 * @property {unknown} [otherwise] - The same where the resolver writes it, as it does not suit every shot: an orthographic camera has no fovY.
 * @property {boolean} [optional] - May be left out; the resolver says what it is then.
 * @property {boolean} [nullable] - May be null.
 * @property {boolean} [stays] - May be left out of a resolved shot too.
 * @property {string} [when] - The key beside it that says by true that this one is there, in a resolved shot.
 * @property {Row | null} [resolved] - What it is in a resolved shot, where that is another thing; null = it is not there.
 * @property {string} [name] - Of an object or a choice that has a C++ type of its own.
 * @property {boolean} [named] - Of an index: whether it stays a name in a resolved shot where it was given as one.
 * @property {boolean} [isShared] - Of a choice: whether its C++ type has a header of its own.
 * @property {boolean} [drawn] - false: the renderer does not read it.
 */

/** Largest coordinate, distance and intensity: inside the range of the GPU's 32-bit floats. */
export const HUGE = 1e30;

/** Smallest length that something is divided by: its inverse is in that range too. */
export const TINY = 1e-30;

/** Largest index of anything in a file: the renderer's are 32 bits. */
export const INDEX_MAX = 2 ** 31 - 1;

/** 1000000000 as "1e9", half a turn as "PI / 2". */
const bound = (x) => (x === Math.PI / 2 ? 'PI / 2' : Math.abs(x) >= 1e6 ? x.toExponential().replace('+', '') : String(x));

/** A range as messages write it: "[0, 1]", "(0, 10]". */
export const interval = (min, max, above) => `${above === undefined ? `[${bound(min)}` : `(${bound(above)}`}, ${bound(max)}]`;

const quoted = (values) =>
  values
    .map((value) => JSON.stringify(value))
    .join(', ')
    .replace(/, ([^,]*)$/, ' or $1');

/** @returns {Row} */
const row = (kind, doc, rest) => Object.freeze({ kind, doc, ...rest, ...(rest.otherwise !== undefined && { optional: true }) });

/** The same row with another standing: `{...}` of Row. */
export const but = (given, changes) => Object.freeze({ ...given, ...changes });

/**
 * @param {string} doc
 * @param {object} domain - what: as messages say it; above: exclusive minimum; the rest is of Row.
 * @returns {Row}
 */
export function number(doc, { what = 'a number', unit, min, max = HUGE, above, integer = false, ...rest }) {
  return row('number', doc, { unit, min, max, above, integer, expected: `${what} in ${interval(min, max, above)}`, ...rest });
}

export const boolean = (doc, rest = {}) => row('boolean', doc, { expected: 'true or false', ...rest });

/** One of some names. */
export const choice = (doc, values, rest = {}) => row('choice', doc, { values: [...values], expected: quoted(values), ...rest });

/** One of some values that are no names, or one value alone. */
export const literal = (doc, values, expected, rest = {}) => row('literal', doc, { values: [values].flat(), expected, ...rest });

/** Whole characters (no half of a surrogate pair, which no UTF-8 holds) without control characters. */
export const CHARACTERS = /^[^\u0000-\u001f\u007f\ud800-\udfff]*$/u;

/** A string; `expected` names it in messages; `max`: its most characters. */
export const text = (doc, expected, rest = {}) => row('text', doc, { expected, pattern: CHARACTERS, ...rest });

/** The same over several lines. */
export const LINES = /^[^\u0000-\u0009\u000b-\u001f\u007f\ud800-\udfff]*$/u;

/** Three finite numbers. */
export const vector = (doc, { expected = 'three numbers [x, y, z] in metres', ...rest } = {}) =>
  row('vector', doc, { expected, expectedNumber: `a number in ${interval(-HUGE, HUGE)}`, ...rest });

/** Two lengths, metres along x and z, unless `expected` names others; `min`, `max`: of each. */
export const extents = (doc, rest = {}) => row('extents', doc, { expected: 'two lengths [x, z] in metres', ...rest });

const COLOUR = 'a CSS colour without transparency (name, #hex, rgb(), hsl()) or a linear [r, g, b]';

/** "expected ..." of a colour, the keywords that may stand in its place, and other things in words. */
export const expectedColour = (keywords = [], others = []) => [...keywords.map((word) => JSON.stringify(word)), ...others, COLOUR].join(', ');

/** A CSS colour, or linear Rec.709 [r, g, b] with components >= 0, which it resolves to; or a keyword. */
export const colour = (doc, { keywords = [], expected = expectedColour(keywords), ...rest } = {}) =>
  row('colour', doc, { keywords, expected, expectedNumber: `a number in ${interval(0, HUGE)}`, ...rest });

/** Index or name of something in the model, `expected`. In a resolved shot an index, or as it was given where it is `named`. */
export const indexOrName = (doc, expected, rest = {}) => row('index', doc, { expected, ...rest });

/** Bytes of a file: in JavaScript alone. */
export const bytes = (doc, expected) => row('bytes', doc, { expected });

/** An object that refuses keys it does not know. */
export const object = (doc, shape, { expected = 'an object', ...rest } = {}) => row('object', doc, { shape: Object.freeze(shape), expected, ...rest });

/** Named values of one kind: {name: value}; `max`: most of them. */
export const record = (doc, of, expected, rest = {}) => row('record', doc, { of, expected, ...rest });

/** Values of one kind; `length`: how many, or `max`: at most how many. */
export const list = (doc, of, expected, rest = {}) => row('list', doc, { of, expected, ...rest });

/** One of several rows. */
export const union = (doc, options, expected, rest = {}) => row('union', doc, { options, expected, ...rest });

/** Objects told apart by the name that their key `by` has: {name: object}. */
export const variants = (doc, by, of, expected, rest = {}) => row('variants', doc, { by, of, expected, ...rest });
