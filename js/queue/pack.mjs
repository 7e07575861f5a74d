import { createHash } from 'node:crypto';
import { canonical, digestOf } from '../api/digest.mjs';
import { bytesOf } from '../api/source.mjs';
import { versions } from '../api/versions.mjs';
import { TelarError } from '../error/index.mjs';

/** Jobs as plain data and bytes apart from it, their ids, and the way back. */

/**
 * Takes the bytes out of a value: those of an environment lie in the middle of a shot.
 * @param {unknown} value
 * @param {(string | number)[]} at
 * @param {{at: (string | number)[], data: Uint8Array}[]} found
 */
function apart(value, at, found) {
  const data = bytesOf(value);
  if (data) {
    found.push({ at, data });
    return null;
  }
  if (Array.isArray(value)) return value.map((item, i) => apart(item, [...at, i], found));
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, apart(item, [...at, key], found)]));
}

/**
 * @param {import('./job_queue.mjs').Task} task
 * @returns {{plain: object, parts: {at: (string | number)[], data: Uint8Array}[], bytes: number}} plain: JSON
 */
export function packTask({ kind, asked, files }) {
  const parts = [];
  const plain = plainOf({ kind, asked, files }, parts);
  return { plain, parts, bytes: parts.reduce((sum, { data }) => sum + data.byteLength, 0) };
}

function plainOf(task, parts) {
  try {
    return JSON.parse(JSON.stringify(apart(task, [], parts)));
  } catch (cause) {
    throw new TelarError('E_REQUEST', `the request is no plain data, or is nested too deep (${cause.message})`, { cause });
  }
}

/** @returns {import('./job_queue.mjs').Task} */
export function unpackTask(plain, parts) {
  const task = structuredClone(plain);
  for (const { at, data } of parts) {
    const last = at.at(-1);
    const holder = at.slice(0, -1).reduce((value, key) => value[key], task);
    // A name of a file may be any text, "__proto__" too.
    Object.defineProperty(holder, last, { value: data, enumerable: true, writable: true, configurable: true });
  }
  return task;
}

/** Of files the order counts for nothing, but for that of fonts: the first that has a character shows it. */
const placeOf = ([at]) => canonical(at[0] === 'files' && at[1].startsWith('font ') ? ['files', 'font '] : at);

/**
 * The id of a job: SHA-256 of all that its result depends on, and of who asks. Asked for again, it is the same job.
 * @param {{plain: object, parts: {at: (string | number)[], data: Uint8Array}[]}} packed
 * @param {{meta: object, tenant: string, put?: string[]}} how
 * @returns {Promise<string>} 64 hex digits
 */
export async function jobId({ plain, parts }, { meta, tenant, put }) {
  const found = await Promise.all(parts.map(async ({ at, data }) => [at, await digestOf(data)]));
  const files = found.sort((a, b) => (placeOf(a) < placeOf(b) ? -1 : Number(placeOf(a) > placeOf(b))));
  // Signatures of presigned addresses differ each time.
  const where = put?.map((url) => new URL(url).origin + new URL(url).pathname);
  return createHash('sha256')
    .update(canonical({ version: versions.telar, plain, files, meta, tenant, where }))
    .digest('hex');
}
