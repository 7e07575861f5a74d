import * as z from '../dist/zod.mjs';
import { parseColour } from './colour.mjs';
import { FRAME_ROW } from './table/camera.mjs';
import { SHOT } from './table/index.mjs';
import { materials } from './table/materials.mjs';
import { ghost } from './table/parts.mjs';
import { CHARACTERS, HUGE, INDEX_MAX, TINY } from './table/rows.mjs';
import { POSE } from './table/stage.mjs';

/** What checks a shot, made of its table (js/shot/table): `error` of a zod type is the "expected ..." part of the message. */

const between = ({ min, max, above, expected: error }) => [above === undefined ? z.gte(min, { error }) : z.gt(above, { error }), z.lte(max, { error })];

/** A longer one is not looked at any further: what is given may be of any size. */
const atMost = (max, error) => (max === undefined ? [] : [z.maxLength(max, { error, abort: true })]);

/** One number of a tuple. */
const component = (min, max, error) => z.number({ error }).check(...between({ min, max, expected: error }));

function colourOf({ keywords, expected: error, expectedNumber }) {
  const part = component(0, HUGE, expectedNumber);
  const css = z.string({ error }).check(z.refine((value) => keywords.includes(value) || parseColour(value) !== undefined, { error }));
  const linear = (value) => (typeof value === 'string' && !keywords.includes(value) ? parseColour(value) : value);
  return z.pipe(z.union([css, z.tuple([part, part, part], { error })], { error }), z.transform(linear));
}

/** Refuses the own key "__proto__", which JSON may have: zod drops it from records without a word, and no check of what it made sees it. */
function withoutPrototype(type) {
  const { run } = type._zod;
  type._zod.run = (payload, context) => {
    const { value: input } = payload;
    if (typeof input === 'object' && input !== null && Object.hasOwn(input, '__proto__'))
      payload.issues.push({ code: 'custom', path: ['__proto__'], message: 'another name', input, inst: type });
    return run(payload, context);
  };
  return type;
}

/** A zod type of each kind of row, its standing and meaning aside. */
const TYPES = {
  number: (row) => (row.integer ? z.int({ error: row.expected }) : z.number({ error: row.expected })).check(...between(row)),
  boolean: ({ expected: error }) => z.boolean({ error }),
  choice: ({ values, expected: error }) => z.enum(values, { error }),
  literal: ({ values, expected: error }) => z.literal(values, { error }),
  text: ({ pattern, max, expected: error }) => z.string({ error }).check(...atMost(max, error), z.regex(pattern, { error })),
  vector({ expected, expectedNumber }) {
    const part = component(-HUGE, HUGE, expectedNumber);
    return z.tuple([part, part, part], { error: expected });
  },
  extents({ expected: error, min = TINY, max = HUGE }) {
    const part = component(min, max, error);
    return z.tuple([part, part], { error });
  },
  colour: colourOf,
  index: ({ expected: error, doc }) =>
    z.union([z.int({ error }).check(...between({ min: 0, max: INDEX_MAX, expected: error })), TYPES.text({ pattern: CHARACTERS, expected: error })], { error }),
  bytes: ({ expected: error }) => z.custom((value) => value instanceof Uint8Array, { error }).register(z.globalRegistry, { tsType: 'Uint8Array' }),
  object: ({ shape, expected: error }) => z.strictObject(mapped(shape, zodOf), { error }),
  record({ of, expected: error, max = Infinity }) {
    const type = z.record(z.string().check(z.regex(CHARACTERS, { error })), inner(of), { error });
    return withoutPrototype(type.check(z.refine((value) => Object.keys(value).length <= max, { error })));
  },
  list({ of, expected: error, length, max }) {
    const type = z.array(inner(of), { error }).check(...atMost(max, error));
    return length === undefined ? type : type.check(z.length(length, { error }));
  },
  union: ({ options, expected: error }) =>
    z.union(
      options.map((row) => (row.kind === 'object' ? inner(row) : zodOf(row))),
      { error },
    ),
  variants: ({ by, of, expected }) =>
    z.discriminatedUnion(by, Object.values(of).map(zodOf), {
      error: ({ code }) => (code === 'invalid_union' ? expected : 'an object'),
    }),
};

/**
 * A type that is made when a value is there for it, as few shots have one for lists and records: to make all of the shot's takes 12 ms,
 * of a process that draws one picture.
 */
const inner = (row) => z.lazy(() => zodOf(row));

const mapped = (shape, of) => Object.fromEntries(Object.entries(shape).map(([key, row]) => [key, of(row)]));

/** Defaults that are parsed like what a caller gives: a colour becomes numbers, an object gets the defaults of its keys. */
const isGiven = ({ kind, default: value }) => kind === 'colour' || kind === 'list' || (typeof value === 'object' && value !== null && !Array.isArray(value));

/** @param {import('./table/rows.mjs').Row} row @returns {import('zod').ZodType} of what a caller may write */
export function zodOf(row) {
  let type = TYPES[row.kind](row);
  if (row.nullable) type = z.nullable(type);
  if (row.doc) type.register(z.globalRegistry, { description: row.otherwise === undefined ? row.doc : `${row.doc}; default ${JSON.stringify(row.otherwise)}` });
  if (row.default !== undefined) return isGiven(row) ? z.prefault(type, row.default) : z._default(type, row.default);
  return row.optional ? z.optional(type) : type;
}

export const shotSchema = zodOf(SHOT);

/** The parts that are read before the rest, as what the model measures depends on them. */
export const frameSchema = zodOf(FRAME_ROW);
export const poseSchema = zodOf(POSE);
export const materialsSchema = zodOf(materials);
export const ghostSchema = zodOf(ghost);
