import * as z from '../../dist/zod.mjs';
import { resolvedShotSchema } from '../../shot/resolved_schema.mjs';
import { shotSchema } from '../../shot/schema.mjs';
import { specSchema } from '../../sheet/schema.mjs';

const isNoJson = ({ tsType }) => tsType !== undefined;

/** JSON Schema of a zod schema, `tsType` kept where JSON cannot hold the value. */
const draft = (schema, io) => z.toJSONSchema(schema, { io, unrepresentable: 'any' });

/** Leaves out what only JavaScript can hold (bytes). */
function withoutBytes(node) {
  if (Array.isArray(node)) return node.filter((item) => !isNoJson(item ?? {})).map(withoutBytes);
  if (typeof node !== 'object' || node === null) return node;
  const copy = Object.fromEntries(Object.entries(node).map(([key, value]) => [key, withoutBytes(value)]));
  if (copy.anyOf?.length !== 1) return copy;
  const {
    anyOf: [only],
    ...rest
  } = copy;
  return { ...rest, ...only, ...(rest.description && { description: rest.description }) };
}

/** The shot as callers write it, for types: bytes stand as {tsType}. */
export const shotDraft = () => draft(shotSchema, 'input');
export const resolvedShotDraft = () => draft(resolvedShotSchema, 'output');

/** The spec of a sheet as callers write it. */
export const specDraft = () => draft(specSchema, 'input');

/** The same as a schema of its own. */
export const specJsonSchema = () => ({ title: 'telar sheet', ...withoutBytes(specDraft()) });

/** The shot as JSON holds it: what `--shot FILE` and HTTP bodies take. */
export const shotJsonSchema = () => ({ title: 'telar shot', ...withoutBytes(shotDraft()) });
