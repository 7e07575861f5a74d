import { setTimeout as sleep } from 'node:timers/promises';

/**
 * Waits until it holds; a test that waits for ever is ended by its runner.
 * @param {() => T | Promise<T>} holds
 * @returns {Promise<T>} what it gave in the end
 * @template T
 */
export async function until(holds) {
  for (;;) {
    const held = await holds();
    if (held) return held;
    await sleep(10);
  }
}
