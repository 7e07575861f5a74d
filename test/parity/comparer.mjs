import { Worker } from 'node:worker_threads';

/** Compares pictures and writes them for the report in a thread of its own, while the next ones are drawn. */
export class Comparer {
  #worker = new Worker(new URL('./comparer_worker.mjs', import.meta.url));
  #waiting = new Map();
  #jobs = 0;

  constructor() {
    this.#worker.on('message', ({ id, error, result }) => this.#settle(id, (job) => (error ? job.reject(error) : job.resolve(result))));
    this.#worker.on('error', (error) => {
      for (const id of [...this.#waiting.keys()]) this.#settle(id, (job) => job.reject(error));
    });
  }

  #settle(id, how) {
    how(this.#waiting.get(id));
    this.#waiting.delete(id);
  }

  /**
   * @param {import('./cases.mjs').Case} item
   * @param {{width: number, height: number, image: Uint8Array, mask: Uint8Array}} expected - The browser's, premultiplied.
   * @param {Uint8Array} actual - The server's.
   * @param {Uint8Array} [second] - The browser's on another rasteriser.
   * @returns {Promise<{difference: import('./metrics.mjs').Difference, rasterizers?: import('./rasterizers.mjs').Distances}>}
   */
  compare(item, { width, height, image, mask }, actual, second = undefined) {
    const pictures = { expected: image, actual, mask, width, height, background: item.shot.background !== 'transparent' };
    const id = ++this.#jobs;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, name: item.name, pictures, second });
    });
  }

  close() {
    return this.#worker.terminate();
  }
}
