/** Milliseconds of work on one image, unless the caller says otherwise. */
export const TIMEOUT_MS = 20_000;

/**
 * One piece of work under its caller's signal and under a bound on its time, which native calls share that are made one
 * after another. Only time counts in which a thread works on it: one that waits behind others is not late for it.
 * @internal
 */
export class Work {
  #timeoutMs;

  /**
   * @param {object} native the addon's exports
   * @param {AbortSignal | undefined} signal
   * @param {number | null} [timeoutMs] null = any time; by default TIMEOUT_MS, until allowLong()
   * @param {object} [token] of other work, whose time this goes on with
   */
  constructor(native, signal, timeoutMs, token = new native.CancelToken((timeoutMs === undefined ? TIMEOUT_MS : timeoutMs) ?? undefined)) {
    this.signal = signal;
    this.#timeoutMs = timeoutMs;
    this.token = token;
  }

  /** The same work under another signal. @returns {Work} */
  under(native, signal) {
    return new Work(native, signal, this.#timeoutMs, this.token);
  }

  /** Work for the same caller in the same time, whose progress is its own. @returns {{signal?: AbortSignal, token: object}} */
  beside(native) {
    return { signal: this.signal, token: new native.CancelToken(this.token) };
  }

  /** What follows is known to be long: it may take any time, unless the caller gave a bound. */
  allowLong() {
    if (this.#timeoutMs === undefined) this.token.allowAnyTime();
  }
}
