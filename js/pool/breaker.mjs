/** Milliseconds until the next start after one that failed: doubled each time, up to the last. */
const FIRST_PAUSE = 100;
const LONGEST_PAUSE = 5000;
/** So many failures within so long mean that starting is of no use now. */
const FAILURES = 5;
const WITHIN = 60_000;

/** Says when a worker is started again, and when to give up for a while. Only starts count: what a file does to workers is for the quarantine. */
export class Breaker {
  #now;
  #failures = [];

  /** @param {() => number} [now] milliseconds */
  constructor(now = Date.now) {
    this.#now = now;
  }

  /** A start failed. */
  fail() {
    this.#failures.push(this.#now());
  }

  /** A worker is ready. */
  succeed() {
    this.#failures = [];
  }

  /** Milliseconds to wait before the next start. */
  get pause() {
    const failed = this.#failures.length;
    return failed === 0 ? 0 : Math.min(FIRST_PAUSE * 2 ** (failed - 1), LONGEST_PAUSE);
  }

  /** Whether jobs are refused. A start is tried all the same, every LONGEST_PAUSE at most. */
  get isOpen() {
    const since = this.#now() - WITHIN;
    if (this.#failures.length > FAILURES) this.#failures = this.#failures.slice(-FAILURES);
    return this.#failures.length === FAILURES && this.#failures[0] >= since;
  }
}
