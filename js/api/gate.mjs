import { TelarError } from '../error/index.mjs';
import { onAbort } from './on_abort.mjs';

/** Lets a limited number of tasks run at once and the others wait in order of arrival, so that waiting costs no memory. */
export class Gate {
  #free;
  #maxWaiting;
  #owner;
  #waiting = new Set();

  /**
   * @param {number} places
   * @param {number} maxWaiting
   * @param {string} [owner] whose places they are
   */
  constructor(places, maxWaiting, owner = 'renderer') {
    this.#free = places;
    this.#owner = owner;
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
      throw new TelarError('X_BUSY', `${this.#waiting.size} jobs wait for this ${this.#owner}, its maxWaiting; try again later`);
    }
    return new Promise((resolve, reject) => {
      const enter = () => {
        stopListening?.();
        resolve();
      };
      const stopListening =
        signal &&
        onAbort(signal, (reason) => {
          this.#waiting.delete(enter);
          reject(reason);
        });
      this.#waiting.add(enter);
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
