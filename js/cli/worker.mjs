import { once } from 'node:events';
import { TelarError } from '../error/index.mjs';
import { OPTIONS } from '../server/table.mjs';
import { readLimits, readTimeout, readWorkers } from './limits.mjs';
import { workerOptions } from './service_options.mjs';

/** Milliseconds that the end of the workers gets beside the draining. */
const LEEWAY_MS = 5000;

/**
 * telar worker
 * Draws the jobs of a queue until it is told to end; then it takes no more, finishes or gives back what runs, and ends well.
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, ending: {patienceMs: number, isWell: boolean}}} context
 * @returns {Promise<number>} 0
 */
export async function worker(options, { console, signal, env, ending, loadPool }) {
  const { queue: where, jobMs = OPTIONS.jobMs.default, drainMs = OPTIONS.drainMs.default, storeBytes } = workerOptions(options, env);
  if (where.redis === undefined && where.sqlite === undefined)
    throw new TelarError('E_USAGE', 'telar worker: expected --redis URL, --sqlite FILE or REDIS_URL in the environment');
  const { openQueue, startWorker } = await import('../queue/index.mjs');
  const queue = await openQueue(where);
  try {
    const { createPool } = await loadPool();
    const size = readWorkers('--workers', options.workers);
    const limits = readLimits(options.limit);
    const timeoutMs = readTimeout(options.timeoutMs);
    const pool = await createPool({
      backend: options.backend,
      limits,
      timeoutMs,
      ...(size && { size }),
      cgroup: options.cgroup,
    });
    try {
      ending.patienceMs = drainMs + LEEWAY_MS;
      ending.isWell = true;
      for (const warning of queue.warnings) console.warning(warning, 'queue');
      const drawing = startWorker(queue, { pool, jobMs, timeoutMs: timeoutMs ?? jobMs, putHosts: options.putHost, store: options.store, storeBytes });
      await drawing.ready;
      const count = pool.workers.length;
      await console.result({ ok: true, workers: count }, [`${count} worker${count === 1 ? ' draws' : 's draw'} the jobs of the queue`]);
      if (!signal.aborted) await once(signal, 'abort');
      await drawing.drain(drainMs);
    } finally {
      await pool.close();
    }
  } finally {
    await queue.close();
  }
  return 0;
}
