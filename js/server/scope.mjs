import { TelarError } from '../error/index.mjs';

/** Milliseconds that `prefer: wait=N` asks for (RFC 7240), at most those that the service allows. */
export function waitOf({ headers }, most) {
  const [, seconds] = /(?:^|[,;\s])wait=(\d{1,6})(?:$|[,;\s])/i.exec(headers.prefer ?? '') ?? [];
  return seconds === undefined ? most : Math.min(1000 * Number(seconds), most);
}

/** Whether the client wants to be told where the answer will be, in place of the answer (RFC 7240, 4.1). */
export const isAsync = ({ headers }) => /(?:^|[,;\s])respond-async(?:$|[,;\s])/i.test(headers.prefer ?? '');

/** How urgent a job is: `priority: u=0` to `u=7` (RFC 9218, 4.1), 0 first. */
export function priorityOf({ priority = '' }) {
  const [, urgency] = /(?:^|[,;\s])u=([0-7])(?:$|[,;\s])/.exec(priority) ?? [];
  return urgency === undefined ? {} : { priority: Number(urgency) };
}

/** One answer in the making: its signal fires when its client is gone, when its time is over, or when the service ends. */
export class Scope {
  /** @type {Promise<void>} */
  ended;
  /** @type {TelarError | undefined} what its client is told when its time is over */
  late;
  /** @type {import('./admission.mjs').Held | undefined} its request's bytes */
  held;
  #settle;
  #controller = new AbortController();
  #timer;
  #end;
  #response;
  #onClose;

  /**
   * @param {import('node:http').ServerResponse} [response] that its client waits for
   * @param {import('./admission.mjs').Held} [held] released when the answer is there
   */
  constructor(response, held) {
    this.#response = response;
    this.held = held;
    this.ended = new Promise((resolve) => {
      this.#settle = resolve;
    });
    this.#onClose = () => {
      if (!response?.writableFinished) this.abort(new TelarError('X_CANCELLED', 'the client no longer waits for the answer'));
    };
    response?.once('close', this.#onClose);
  }

  get signal() {
    return this.#controller.signal;
  }

  /** @param {Error} reason */
  abort(reason) {
    this.#controller.abort(reason);
  }

  /** The clock of the answer starts. */
  startClock(ms) {
    this.#end = performance.now() + ms;
    const what = this.#response ? `the answer took longer than the ${ms} ms that it may take, waiting included` : `the job took longer than ${ms} ms`;
    this.late = new TelarError('X_TIMEOUT', what);
    this.#timer = setTimeout(() => this.abort(this.late), ms);
  }

  /** Milliseconds that are left. */
  get left() {
    return Math.max(1, Math.ceil(this.#end - performance.now()));
  }

  close() {
    clearTimeout(this.#timer);
    this.#response?.off('close', this.#onClose);
    this.held?.release();
    this.#settle();
  }
}
