import { MemoryQueue } from './memory_queue.mjs';
import { readQueueOptions } from './options.mjs';

/**
 * Documented in js/queue/index.d.ts. What a queue needs is loaded with it.
 * @returns {Promise<import('./job_queue.mjs').JobQueue>}
 */
export async function openQueue(options = {}) {
  const bounds = readQueueOptions(options);
  if (bounds.redis !== undefined) return (await import('./redis_queue.mjs')).RedisQueue.open(bounds);
  if (bounds.sqlite !== undefined) return (await import('./sqlite_queue.mjs')).SqliteQueue.open(bounds);
  return new MemoryQueue(bounds);
}
