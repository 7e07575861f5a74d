import { setTimeout as sleep } from 'node:timers/promises';
import { onAbort } from '../api/on_abort.mjs';
import { Breaker } from './breaker.mjs';
import { residentBytes } from './usage.mjs';
import { noWorkers } from './verdicts.mjs';
import { WorkerProcess } from './worker_process.mjs';

/** So many workers, each replaced when it ends, and whoever waits for one. */
export class Workers {
  #options;
  #start;
  #all = new Set();
  #idle = new Set();
  #takers = new Set();
  #breaker;
  #isClosing = false;
  #failure;

  /**
   * @param {object} options of createPool, with every default
   * @param {{start?: (options: object) => WorkerProcess, breaker?: Breaker}} [parts] others in their place, for tests
   */
  constructor(options, { start = (own) => new WorkerProcess(own), breaker = new Breaker() } = {}) {
    this.#options = options;
    this.#start = start;
    this.#breaker = breaker;
  }

  /** Starts them all. @returns {Promise<object>} what the first that is ready says @throws {TelarError} where none starts */
  async open() {
    const first = Array.from({ length: this.#options.size }, () => this.#add());
    try {
      return await Promise.any(first.map(({ ready }) => ready));
    } catch (error) {
      throw error.errors[0];
    }
  }

  /** @returns {WorkerProcess[]} */
  get all() {
    return [...this.#all];
  }

  /**
   * An idle worker, as soon as there is one.
   * @param {(worker: WorkerProcess) => boolean} suits best; any other does too
   * @param {AbortSignal} [signal]
   * @returns {Promise<WorkerProcess>}
   * @throws {TelarError} X_WORKERS
   */
  take(suits, signal) {
    if (this.#breaker.isOpen) throw noWorkers(this.#failure);
    const idle = [...this.#idle];
    const worker = idle.find(suits) ?? idle[0];
    if (worker) {
      this.#idle.delete(worker);
      return worker;
    }
    return new Promise((resolve, reject) => {
      const taker = {
        resolve: (free) => {
          stopListening?.();
          resolve(free);
        },
        reject: (error) => {
          stopListening?.();
          reject(error);
        },
      };
      const stopListening =
        signal &&
        onAbort(signal, (reason) => {
          this.#takers.delete(taker);
          reject(reason);
        });
      this.#takers.add(taker);
    });
  }

  /** A worker that was taken has done its job, or has ended. */
  give(worker) {
    if (worker.hasEnded) return;
    if (worker.isSpoiled) worker.kill();
    else if (this.#isWornOut(worker)) void worker.close();
    else this.#offer(worker);
  }

  /** Ends all. Nothing may be running. */
  async close() {
    this.#isClosing = true;
    await Promise.all(this.all.map((worker) => worker.close()));
  }

  #offer(worker) {
    if (!this.#all.has(worker)) return;
    const [taker] = this.#takers;
    if (!taker) {
      this.#idle.add(worker);
      return;
    }
    this.#takers.delete(taker);
    taker.resolve(worker);
  }

  #isWornOut(worker) {
    if (!this.#all.has(worker)) return false;
    const { jobs, bytes } = this.#options.recycle;
    return worker.jobs >= jobs || residentBytes(worker.pid) > bytes;
  }

  #add() {
    const worker = this.#start(this.#options);
    this.#all.add(worker);
    worker.ready.then(
      () => {
        this.#breaker.succeed();
        this.#offer(worker);
      },
      (error) => this.#fail(error),
    );
    void worker.ended.then(() => this.#replace(worker));
    return worker;
  }

  #fail(error) {
    if (this.#isClosing) return;
    this.#failure = error;
    this.#breaker.fail();
    if (!this.#breaker.isOpen) return;
    for (const { reject } of this.#takers) reject(noWorkers(error));
    this.#takers.clear();
  }

  async #replace(worker) {
    this.#all.delete(worker);
    this.#idle.delete(worker);
    if (this.#breaker.pause > 0) await sleep(this.#breaker.pause, undefined, { ref: false });
    if (!this.#isClosing) this.#add();
  }
}
