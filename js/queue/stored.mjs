import { randomBytes } from 'node:crypto';
import { unpackTask } from './pack.mjs';
import { putFiles } from './put.mjs';
import { lost } from './verdict.mjs';

/** Tasks and results as plain data, with their bytes in a store. Each writing has names of its own: two that write at once do not meet. */

const newRef = () => randomBytes(16).toString('hex');

/** All or nothing: what is there of an attempt that fails is removed. */
async function putAll(store, entries, ms) {
  const written = await Promise.allSettled(entries.map(({ ref, data }) => store.put(ref, data, ms)));
  const failed = written.find(({ status }) => status === 'rejected');
  if (!failed) return;
  await store.drop(entries.map(({ ref }) => ref)).catch(() => {});
  throw failed.reason;
}

/**
 * @param {import('./folder_store.mjs').Store} store
 * @param {ReturnType<import('./pack.mjs').packTask>} packed
 * @param {number} ms for which the bytes are kept
 * @returns {Promise<{plain: object, parts: {at: (string | number)[], ref: string, bytes: number}[]}>} plain data
 */
export async function storeTask(store, { plain, parts }, ms) {
  const entries = parts.map(({ at, data }) => ({ at, ref: newRef(), data }));
  await putAll(store, entries, ms);
  return { plain, parts: entries.map(({ at, ref, data }) => ({ at, ref, bytes: data.byteLength })) };
}

/** Bytes as long as they were when they were stored. */
async function whole(store, { ref, bytes }) {
  const data = await store.get(ref);
  if (data?.byteLength !== bytes) return undefined;
  return data;
}

/** @throws {import('../error/index.mjs').TelarError} X_QUEUE */
export async function loadTask(store, { plain, parts }) {
  const loaded = await Promise.all(parts.map(async (part) => ({ at: part.at, data: await whole(store, part) })));
  if (loaded.some(({ data }) => data === undefined)) throw lost('the files');
  return unpackTask(plain, loaded);
}

/**
 * @param {import('./folder_store.mjs').Store} store
 * @param {import('./perform.mjs').Result} result
 * @param {{ms: number, put?: string[], signal: AbortSignal, hosts?: string[]}} how put: addresses that take the files in place of the store
 * @returns {Promise<object>} plain data
 */
export async function storeResult(store, { files, ...rest }, { ms, put, signal, hosts }) {
  if (put) return { ...rest, files: await putFiles(files, put, { signal, hosts }) };
  const entries = files.map((file) => ({ ...file, ref: newRef() }));
  await putAll(store, entries, ms);
  return { ...rest, files: entries.map(({ name, type, ref, data }) => ({ name, type, ref, bytes: data.byteLength })) };
}

/** @returns {Promise<import('./perform.mjs').Result | undefined>} undefined where it is not kept any more */
export async function loadResult(store, { files, ...rest }) {
  const loaded = await Promise.all(
    files.map(async ({ ref, bytes, ...file }) => (ref ? { ...file, data: await whole(store, { ref, bytes }) } : { ...file, bytes })),
  );
  return files.some(({ ref }, i) => ref && !loaded[i].data) ? undefined : { ...rest, files: loaded };
}

/** Names of the bytes of a task or of a result. */
export const refsOf = (stored) => (stored?.parts ?? stored?.files ?? []).map(({ ref }) => ref).filter(Boolean);

export const bytesOfResult = ({ files }) => files.reduce((sum, { bytes }) => sum + bytes, 0);
