/** Comparisons off the page's own thread; a newer one ends an older. */
export class Comparer {
  #worker;
  #waiting;
  #count = 0;

  /**
   * @param {import('../../compare/image.mjs').Image} expected
   * @param {import('../../compare/image.mjs').Image} actual of the same size
   * @param {{gate: string, mask?: Uint8Array}} options mask: not 0 where the object is; without it, alpha tells
   * @returns {Promise<object | undefined>} {comparison, verdict, flip, difference}; undefined when a newer one came
   */
  compare(expected, actual, { gate, mask }) {
    this.cancel();
    this.#worker ??= new Worker(new URL('./compare_worker.js', import.meta.url), { type: 'module' });
    const id = ++this.#count;
    return new Promise((resolve, reject) => {
      this.#waiting = resolve;
      this.#worker.onmessage = ({ data }) => {
        if (data.id !== id) return;
        this.#waiting = undefined;
        resolve(data);
      };
      this.#worker.onerror = (event) => {
        this.cancel();
        reject(new Error(`the comparison failed: ${event.message}`));
      };
      this.#worker.postMessage({ id, expected, actual, mask, gate });
    });
  }

  cancel() {
    if (!this.#waiting) return;
    this.#worker.terminate();
    this.#worker = undefined;
    this.#waiting(undefined);
    this.#waiting = undefined;
  }
}
