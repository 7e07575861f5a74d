import * as z from '../dist/zod.mjs';
import { SHOT } from './table/index.mjs';
import { resolvedRow } from './table/resolved.mjs';
import { CHARACTERS, INDEX_MAX } from './table/rows.mjs';

/**
 * What checks a resolved shot, made of its table, for types and tests: what resolveShot returns and the renderer reads.
 * Lengths in metres, camera and environment angles in degrees, spot cones in radians, colours linear Rec.709.
 */

function numberType({ integer, min, max, above }) {
  const type = integer ? z.int() : z.number();
  return type.check(above === undefined ? z.gte(min) : z.gt(above), z.lte(max));
}

const tuple = (length, type) => z.tuple(Array(length).fill(type));

const index = z.int().check(z.gte(0), z.lte(INDEX_MAX));

/** A zod type of each kind of row. */
const TYPES = {
  number: numberType,
  boolean: () => z.boolean(),
  choice: ({ values }) => z.enum(values),
  literal: ({ values }) => z.literal(values),
  text: ({ pattern }) => z.string().check(z.regex(pattern)),
  vector: () => tuple(3, z.number()),
  extents: () => tuple(2, z.number()),
  colour: ({ keywords }) => (keywords.length > 0 ? z.union([z.enum(keywords), tuple(3, z.number().check(z.gte(0)))]) : tuple(3, z.number().check(z.gte(0)))),
  index: ({ named }) => (named ? z.union([index, z.string().check(z.regex(CHARACTERS))]) : index),
  bytes: () => z.custom((value) => value instanceof Uint8Array).register(z.globalRegistry, { tsType: 'Uint8Array' }),
  object: ({ shape }) => z.strictObject(Object.fromEntries(Object.entries(shape).map(([key, row]) => [key, zodOf(row)]))),
  record: ({ of }) => z.record(z.string(), zodOf(of)),
  list: ({ of }) => z.array(zodOf(of)),
  union: ({ options }) => z.union(options.map(zodOf)),
  variants: ({ by, of }) => z.discriminatedUnion(by, Object.values(of).map(zodOf)),
};

/** @param {import('./table/rows.mjs').Row} given */
function zodOf(given) {
  const row = resolvedRow(given);
  let type = TYPES[row.kind](row);
  if (row.nullable) type = z.nullable(type);
  if (row.doc) type.register(z.globalRegistry, { description: row.doc });
  return row.optional ? z.optional(type) : type;
}

export const resolvedShotSchema = zodOf(SHOT);
