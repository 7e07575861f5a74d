import { setTimeout as sleep } from 'node:timers/promises';
import { TelarError } from '../error/index.mjs';

/** The connection to a Redis or Valkey server, and what its settings have to be. */

/** Milliseconds to connect. */
const CONNECT_MS = 10_000;
/** Milliseconds that a server has to answer whoever does not wait for one: less than Prometheus waits for figures, and time for a large model. */
const ANSWER_MS = 8000;
/** Milliseconds between two tries to connect again: the longest. */
const AGAIN_MS = 2000;

/** Libraries that only this queue needs. */
export async function libraries() {
  try {
    const [bullmq, { Redis }] = await Promise.all([import('bullmq'), import('ioredis')]);
    return { ...bullmq, Redis };
  } catch (cause) {
    throw new TelarError('X_LIBRARY_MISSING', 'a queue on Redis needs two packages: npm install bullmq ioredis', { cause });
  }
}

/** What Redis says, as one of our errors; of what is full, whoever adds is to come again. */
export function wrong(cause) {
  if (cause instanceof TelarError) return cause;
  if (/^OOM /.test(cause?.message ?? '')) return new TelarError('X_BUSY', 'the memory of the Redis server is full; try again later', { cause });
  return new TelarError('X_QUEUE', `the Redis server of the queue: ${cause?.message ?? cause}`, { cause });
}

/** @template T @param {() => Promise<T>} use @returns {Promise<T>} */
export async function told(use) {
  try {
    return await use();
  } catch (error) {
    throw wrong(error);
  }
}

/**
 * @param {typeof import('ioredis').Redis} Redis
 * @param {string} url
 * @param {{waits: boolean}} how waits: commands wait for a server that is away, as workers do; otherwise they fail at once, and where it does not answer in time
 */
export function connect(Redis, url, { waits }) {
  const client = new Redis(url, {
    lazyConnect: true,
    maxRetriesPerRequest: null,
    enableOfflineQueue: waits,
    connectTimeout: CONNECT_MS,
    ...(!waits && { commandTimeout: ANSWER_MS }),
    retryStrategy: (tries) => Math.min(50 * 2 ** tries, AGAIN_MS),
  });
  client.on('error', () => {}); // It connects again; each command tells.
  return client;
}

/**
 * Lets go of a client and of what BullMQ makes after its pattern: without a server, neither would end by itself.
 * @param {import('ioredis').Redis} client
 * @returns {() => void}
 */
export function letGoOf(client) {
  const all = [client];
  const duplicate = client.duplicate.bind(client);
  client.duplicate = (...args) => {
    all.push(duplicate(...args));
    return all.at(-1);
  };
  return () => all.forEach((one) => one.disconnect());
}

/** Milliseconds that the server has to answer when a queue is closed. */
export const CLOSE_MS = 2000;

/** Resolves when all are closed, or when a server that is away has had its time. @param {Promise<unknown>[]} closing */
export async function closedInTime(closing) {
  const clock = new AbortController();
  const late = sleep(CLOSE_MS, undefined, { signal: clock.signal }).catch(() => {});
  await Promise.race([Promise.allSettled(closing), late]);
  clock.abort();
}

/** "key:value" lines of INFO. */
const infoOf = (text) =>
  Object.fromEntries(
    text
      .split(/\r?\n/)
      .filter((line) => line.includes(':'))
      .map((line) => line.split(/:(.*)/s).slice(0, 2)),
  );

/**
 * Refuses a server that may throw jobs away, and tells of one that may lose them. INFO says so where CONFIG is forbidden, too.
 * @param {Pick<import('ioredis').Redis, 'info'>} client
 * @returns {Promise<{code: string, message: string}[]>} warnings
 * @throws {TelarError} X_QUEUE
 */
export async function checkServer(client) {
  const facts = infoOf(await client.info());
  const policy = facts.maxmemory_policy;
  if (policy !== undefined && policy !== 'noeviction')
    throw new TelarError('X_QUEUE', `maxmemory-policy of the Redis server is ${policy}: it may throw jobs away. Set it to noeviction`);
  if (facts.aof_enabled === '1') return [];
  return [{ code: 'W_QUEUE', message: 'the Redis server keeps no append-only file: jobs are lost when it ends. Set appendonly to yes' }];
}
