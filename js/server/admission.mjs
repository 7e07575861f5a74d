import { TelarError } from '../error/index.mjs';
import { onAbort } from '../api/on_abort.mjs';

/** How much the last job counts in the mean of the time that jobs take. */
const WEIGHT = 0.2;
/** Milliseconds that a first job is taken to last. */
const FIRST_GUESS = 1000;
/** Longest and shortest `retry-after`, seconds. */
const RETRY = { least: 1, most: 60 };

const busy = (message) => new TelarError('X_BUSY', message);

/**
 * Bytes of one request that are in memory, from its body to its answer.
 * @typedef {object} Held
 * @property {(bytes: number) => void} grow so many by now, or as many as will come; throws X_BUSY where those of all requests are too many
 * @property {() => void} release
 */

/** Lets so many jobs run and so many wait, and so many bodies of so many bytes be received; the others are refused at once. */
export class Admission {
  running = 0;
  receiving = 0;
  /** Bytes of the requests that are in memory. */
  heldBytes = 0;
  #places;
  #maxWaiting;
  #uploads;
  #uploadBytes;
  #waiting = new Set();
  #later = new Set();
  #meanMs = FIRST_GUESS;
  #isClosed = false;

  /** @param {{places: number, waiting: number, uploads: number, uploadBytes: number}} bounds */
  constructor({ places, waiting, uploads, uploadBytes }) {
    this.#places = places;
    this.#maxWaiting = waiting;
    this.#uploads = uploads;
    this.#uploadBytes = uploadBytes;
  }

  get waiting() {
    return this.#waiting.size;
  }

  get places() {
    return this.#places;
  }

  get isClosed() {
    return this.#isClosed;
  }

  /** No more bodies are received; what has been, or is being received, still gets its turn. */
  close() {
    this.#isClosed = true;
  }

  /** Seconds after which a place may be free. */
  get retryAfter() {
    const ms = (this.#meanMs * (this.#waiting.size + 1)) / this.#places;
    return Math.min(Math.max(Math.ceil(ms / 1000), RETRY.least), RETRY.most);
  }

  /**
   * Before a body is read: a job that would be refused afterwards is refused now.
   * @throws {TelarError} X_BUSY, X_SHUTDOWN
   */
  check() {
    this.#checkOpen();
    this.#checkRoom();
  }

  #checkOpen() {
    if (this.#isClosed) throw new TelarError('X_SHUTDOWN', 'the service is ending and takes no more work');
  }

  #checkRoom() {
    if (this.running >= this.#places && this.#waiting.size >= this.#maxWaiting)
      throw busy(`${this.#waiting.size} jobs wait for this service, as many as may; try again later`);
  }

  /**
   * Receives a body.
   * @param {() => Promise<T>} receive
   * @param {() => void | Promise<void>} [check] whether there is room for what is asked
   * @returns {Promise<T>}
   * @throws {TelarError} X_BUSY, X_SHUTDOWN
   * @template T
   */
  async receive(receive, check = () => this.check()) {
    this.#checkOpen();
    await check();
    if (this.receiving >= this.#uploads) throw busy(`${this.receiving} requests are being received by this service, as many as may; try again later`);
    this.receiving += 1;
    try {
      return await receive();
    } finally {
      this.receiving -= 1;
    }
  }

  /** @returns {Held} One request alone may take what its own bounds allow: it would never be let in otherwise. */
  hold() {
    let own = 0;
    const grow = (bytes) => {
      const others = this.heldBytes - own;
      if (others > 0 && others + bytes > this.#uploadBytes) throw busy('the requests of this service have all the memory that they may');
      this.heldBytes = others + Math.max(own, bytes);
      own = Math.max(own, bytes);
    };
    const release = () => {
      this.heldBytes -= own;
      own = 0;
    };
    return { grow, release };
  }

  /**
   * Runs a job whose body was received, in order of arrival.
   * @param {() => Promise<T>} task
   * @param {AbortSignal} signal ends the waiting
   * @returns {Promise<T>}
   * @throws {TelarError} X_BUSY
   * @template T
   */
  async run(task, signal) {
    this.#checkRoom();
    return this.#run(task, signal, this.#waiting);
  }

  /** Runs a job that nobody waits for at the other end of a connection: after those. Whoever asks bounds how many. */
  runLater(task, signal) {
    return this.#run(task, signal, this.#later);
  }

  async #run(task, signal, queue) {
    signal.throwIfAborted();
    if (this.running < this.#places) this.running += 1;
    else await this.#wait(signal, queue);
    const start = performance.now();
    try {
      return await task();
    } finally {
      this.#meanMs += WEIGHT * (performance.now() - start - this.#meanMs);
      this.#leave();
    }
  }

  /** Resolves with a place taken over from a job that left. */
  #wait(signal, queue) {
    return new Promise((resolve, reject) => {
      const enter = () => {
        stopListening();
        resolve();
      };
      const stopListening = onAbort(signal, (reason) => {
        queue.delete(enter);
        reject(reason);
      });
      queue.add(enter);
    });
  }

  #leave() {
    const [next] = this.#waiting.size > 0 ? this.#waiting : this.#later;
    if (!next) {
      this.running -= 1;
      return;
    }
    this.#waiting.delete(next);
    this.#later.delete(next);
    next();
  }
}
