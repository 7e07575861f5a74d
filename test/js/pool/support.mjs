import '../api/support/real.mjs';
import { createPool } from '../../../js/pool/index.mjs';
import { until } from '../../until.mjs';

export const SHOT = { size: { width: 48, height: 48 } };

/** Takes hours: what ends it is what is tested. One thread, so that it leaves the other cores to other tests. */
export const ENDLESS = { size: { width: 256, height: 256 }, quality: { preset: 'reference', samples: 65_536, threads: 1 } };

/** A pool without a folder of environments, of one worker unless said otherwise. */
export const open = (options) => createPool({ size: 1, cacheDirectory: null, ...options });

/** The error that a promise rejects with. */
export const errorOf = (promise) =>
  promise.then(
    () => undefined,
    (error) => error,
  );

/** Process ids of the workers that have a job, once there are so many. */
export async function busy(pool, count = 1) {
  const found = () => pool.workers.filter(({ state }) => state === 'busy').map(({ pid }) => pid);
  await until(() => found().length >= count);
  return found();
}

export function isAlive(pid) {
  try {
    return process.kill(pid, 0);
  } catch {
    return false;
  }
}
