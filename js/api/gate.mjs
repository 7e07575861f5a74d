import { TelarError } from '../error/index.mjs';

/** Lets a limited number of tasks run at once and the others wait in order of arrival, so that waiting costs no memory. */
export class Gate {
  #free;
  #maxWaiting;
  #waiting = new Set();

  /**
   * @param {number} places
   * @param {number} maxWaiting
   */
  constructor(places, maxWaiting) {
    this.#free = places;
    this.#maxWaiting = maxWaiting;
  }

  /**
   * @param {() => Promise<T>} task
   * @param {AbortSignal} [signal] ends the waiting
   * @returns {Promise<T>}
   * @throws {TelarError} X_BUSY when too many wait
   * @template T
   */
  async run(task, signal) {
    signal?.throwIfAborted();
    if (this.#free > 0) this.#free -= 1;
    else await this.#wait(signal);
    try {
      return await task();
    } finally {
      this.#leave();
    }
  }

  /** Resolves with a place taken over from a task that left. */
  #wait(signal) {
    if (this.#waiting.size >= this.#maxWaiting) {
      throw new TelarError('X_BUSY', `${this.#waiting.size} jobs wait for this renderer, its maxWaiting; try again later`);
    }
    return new Promise((resolve, reject) => {
      const onAbort = () => {
        this.#waiting.delete(enter);
        reject(signal.reason);
      };
      const enter = () => {
        signal?.removeEventListener('abort', onAbort);
        resolve();
      };
      this.#waiting.add(enter);
      signal?.addEventListener('abort', onAbort, { once: true });
    });
  }

  #leave() {
    const [next] = this.#waiting;
    if (!next) {
      this.#free += 1;
      return;
    }
    this.#waiting.delete(next);
    next();
  }
}
