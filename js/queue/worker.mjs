import { TelarError } from '../error/index.mjs';
import { isObject, wrongOption } from '../api/option_check.mjs';
import { keyOf } from './key.mjs';
import { perform } from './perform.mjs';
import { checkStored } from './picture_size.mjs';
import { ResultStore, storeOption } from './result_store.mjs';
import { STORE } from './table.mjs';

const JOB_MS = 600_000;
const MOST_MS = 86_400_000;

function readWorkerOptions({
  pool,
  atOnce = Math.max(1, pool?.workers?.length ?? 1),
  jobMs = JOB_MS,
  timeoutMs = jobMs,
  templates,
  putHosts,
  store,
  storeBytes = STORE.storeBytes.default,
}) {
  if (typeof pool?.render !== 'function') throw wrongOption('options.pool', 'a pool of createPool', pool);
  for (const [name, value] of Object.entries({ atOnce, jobMs, timeoutMs }))
    if (!Number.isInteger(value) || value < 1 || value > MOST_MS) throw wrongOption(`options.${name}`, `a whole number in [1, ${MOST_MS}]`, value);
  if (templates !== undefined && !isObject(templates)) throw wrongOption('options.templates', 'an object of folders by name', templates);
  if (putHosts !== undefined && !Array.isArray(putHosts)) throw wrongOption('options.putHosts', 'a list of hosts', putHosts);
  if (!Number.isSafeInteger(storeBytes) || storeBytes < 1) throw wrongOption('options.storeBytes', 'a whole number from 1 on', storeBytes);
  return { pool, atOnce, jobMs, timeoutMs, templates, putHosts, store: storeOption(store), storeBytes };
}

/** Documented in js/queue/index.d.ts. */
export function startWorker(queue, options = {}) {
  const { pool, atOnce, jobMs, timeoutMs, templates, putHosts, store: where, storeBytes } = readWorkerOptions(options);
  let store;
  const draw = async (task, { signal, ...callbacks }) => {
    const late = new AbortController();
    const clock = setTimeout(() => late.abort(new TelarError('X_TIMEOUT', `the job took longer than ${jobMs} ms`)), jobMs);
    try {
      return await perform(pool, task, { signal: AbortSignal.any([signal, late.signal]), ...callbacks, timeoutMs, templates });
    } finally {
      clearTimeout(clock);
    }
  };
  const work = async (task, { onStart, ...how }) => {
    const key = store && (await keyOf(task));
    const kept = key && (await store.get(key, how.signal));
    onStart();
    if (kept) checkStored(task, kept);
    if (kept) return kept;
    const result = await draw(task, how);
    // By the key that was found here: a process that draws and was taken over names no other picture's.
    if (key) store.put({ ...result, key });
    return result;
  };
  const take = () => queue.take(work, { atOnce, ...(putHosts && { hosts: putHosts }) });
  const open = async () => {
    store = await ResultStore.open(where, storeBytes, () => {});
    take();
  };
  return {
    ready: where === undefined ? Promise.resolve(take()) : open(),
    async drain(ms) {
      const reason = new TelarError('X_SHUTDOWN', 'the worker ended before the job was done');
      const clock = setTimeout(() => queue.abort(reason), ms);
      await queue.idle();
      clearTimeout(clock);
      await store?.idle();
    },
  };
}
