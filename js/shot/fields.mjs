import * as z from '../dist/zod.mjs';
import { parseColour } from './colour.mjs';

/**
 * Builders of the shot's fields. Each says once what it accepts; messages, JSON Schema, types and tables derive from it.
 * `error` of a zod type is the "expected ..." part of the message.
 */

/** Largest coordinate, distance and intensity: inside the range of the GPU's 32-bit floats. */
export const HUGE = 1e30;

/** Smallest length that something is divided by: its inverse is in that range too. */
export const TINY = 1e-30;

/** 1000000000 as "1e9", half a turn as "PI / 2". */
const bound = (x) => (x === Math.PI / 2 ? 'PI / 2' : Math.abs(x) >= 1e6 ? x.toExponential().replace('+', '') : String(x));
const interval = (min, max, above) => `${above === undefined ? `[${bound(min)}` : `(${bound(above)}`}, ${bound(max)}]`;

/**
 * @param {string} doc
 * @param {{what?: string, min?: number, max?: number, above?: number, integer?: boolean}} domain above: exclusive minimum
 */
export function number(doc, { what = 'a number', min, max = HUGE, above, integer = false }) {
  const error = `${what} in ${interval(min, max, above)}`;
  let type = integer ? z.int({ error }) : z.number({ error });
  type = above === undefined ? type.min(min, { error }) : type.gt(above, { error });
  return type.max(max, { error }).describe(doc);
}

export const boolean = (doc) => z.boolean({ error: 'true or false' }).describe(doc);

const quoted = (values) => values.map((value) => JSON.stringify(value)).join(', ').replace(/, ([^,]*)$/, ' or $1');

export const choice = (doc, values) => z.enum(values, { error: quoted(values) }).describe(doc);

/** A string of whole characters (no half of a surrogate pair, which no UTF-8 holds) without control characters; `what` names it in messages. */
export const text = (doc, what) => z.string({ error: what }).regex(/^[^\u0000-\u001f\u007f\ud800-\udfff]*$/u, { error: what }).describe(doc);

/** Three finite numbers. */
export function vector(doc, what = 'three numbers [x, y, z] in metres') {
  const error = `a number in ${interval(-HUGE, HUGE)}`;
  const component = z.number({ error }).min(-HUGE, { error }).max(HUGE, { error });
  return z.tuple([component, component, component], { error: what }).describe(doc);
}

const COLOUR = 'a CSS colour without transparency (name, #hex, rgb(), hsl()) or a linear [r, g, b]';

/** "expected ..." of a colour, the keywords that may stand in its place, and other things in words. */
export const expectedColour = (keywords = [], others = []) => [...keywords.map((word) => JSON.stringify(word)), ...others, COLOUR].join(', ');

/** A CSS colour, or linear Rec.709 [r, g, b] with components >= 0. Resolves to the latter. */
export function colour(doc, keywords = [], error = expectedColour(keywords)) {
  const range = `a number in ${interval(0, HUGE)}`;
  const component = z.number({ error: range }).min(0, { error: range }).max(HUGE, { error: range });
  const css = z.string({ error }).refine((value) => keywords.includes(value) || parseColour(value) !== undefined, { error });
  return z.union([css, z.tuple([component, component, component], { error })], { error })
    .transform((value) => (typeof value === 'string' && !keywords.includes(value) ? parseColour(value) : value))
    .describe(doc);
}

/** An object that refuses keys it does not know. */
export const object = (doc, shape, what = 'an object') => z.strictObject(shape, { error: what }).describe(doc);

/** Largest index of anything in a file: the renderer's are 32 bits. */
export const INDEX_MAX = 2 ** 31 - 1;

/** Index or name of something in the model; `what` says so in messages. */
export const indexOrName = (doc, what) => z.union([z.int({ error: what }).min(0, { error: what }).max(INDEX_MAX, { error: what }), text('Name', what)],
  { error: what }).describe(doc);
