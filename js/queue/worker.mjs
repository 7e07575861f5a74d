import { TelarError } from '../error/index.mjs';
import { isObject, wrongOption } from '../api/option_check.mjs';
import { perform } from './perform.mjs';

const JOB_MS = 600_000;
const MOST_MS = 86_400_000;

function readWorkerOptions({ pool, atOnce = Math.max(1, pool?.workers?.length ?? 1), jobMs = JOB_MS, templates, putHosts }) {
  if (typeof pool?.render !== 'function') throw wrongOption('options.pool', 'a pool of createPool', pool);
  for (const [name, value] of Object.entries({ atOnce, jobMs }))
    if (!Number.isInteger(value) || value < 1 || value > MOST_MS) throw wrongOption(`options.${name}`, `a whole number in [1, ${MOST_MS}]`, value);
  if (templates !== undefined && !isObject(templates)) throw wrongOption('options.templates', 'an object of folders by name', templates);
  if (putHosts !== undefined && !Array.isArray(putHosts)) throw wrongOption('options.putHosts', 'a list of hosts', putHosts);
  return { pool, atOnce, jobMs, templates, putHosts };
}

/** Documented in js/queue/index.d.ts. */
export function startWorker(queue, options = {}) {
  const { pool, atOnce, jobMs, templates, putHosts } = readWorkerOptions(options);
  const work = async (task, { signal, onProgress, onStart }) => {
    const late = new AbortController();
    const clock = setTimeout(() => late.abort(new TelarError('X_TIMEOUT', `the job took longer than ${jobMs} ms`)), jobMs);
    onStart();
    try {
      return await perform(pool, task, { signal: AbortSignal.any([signal, late.signal]), onProgress, timeoutMs: jobMs, templates });
    } finally {
      clearTimeout(clock);
    }
  };
  queue.take(work, { atOnce, ...(putHosts && { hosts: putHosts }) });
  return {
    async drain(ms) {
      const reason = new TelarError('X_SHUTDOWN', 'the worker ended before the job was done');
      const clock = setTimeout(() => queue.abort(reason), ms);
      await queue.idle();
      clearTimeout(clock);
    },
  };
}
