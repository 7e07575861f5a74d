import { fromNative, toTelarError } from '../error/index.mjs';
import { hasLongShot } from '../api/long_shot.mjs';
import { onAbort } from '../api/on_abort.mjs';
import { partBytes } from '../api/parts.mjs';
import { TIMEOUT_MS } from '../api/work.mjs';
import { modelBytes } from './held_models.mjs';
import { DRAW_MANY, messageOf } from './request.mjs';
import { GRACE_MS, overTime } from './verdicts.mjs';

/** The longest that a timer may be set to. */
const LONGEST = 2 ** 31 - 1;

/** One job in one worker, on the parent's side: its clock, its caller's callbacks, its outcome. */
export class RunningJob {
  /** @type {Promise<unknown>} settles with the answer, or at once when the caller aborts */
  outcome;
  /** Whether the worker has taken it up: one that ended before has not seen its file. */
  hasBegun = false;
  #id;
  #request;
  #worker;
  #held;
  #settle;
  #clock;
  #scope = new AbortController();
  #resolveFailure;
  #stopListening;
  #loaded = false;
  #told = false;

  /**
   * @param {number} id
   * @param {import('./request.mjs').Request} request
   * @param {{send(message: object, parts?: Uint8Array[]): void, kill(verdict?: Error): void}} worker
   * @param {import('./held_models.mjs').HeldModels} held by the worker
   * @param {AbortSignal | undefined} signal not aborted
   */
  constructor(id, request, worker, held, signal) {
    [this.#id, this.#request, this.#worker, this.#held] = [id, request, worker, held];
    this.outcome = new Promise((resolve, reject) => {
      this.#settle = { resolve, reject };
    });
    const { job, parts } = messageOf(id, request, held);
    worker.send({ job }, parts);
    this.#stopListening = signal && onAbort(signal, (reason) => this.#abort(reason));
    this.#startClock();
  }

  /** @returns {boolean} whether the job is done, and its worker free */
  take({ begun, progress, preview, beat, ask, done, uri, value, error }, parts) {
    if (begun === this.#id) this.hasBegun = true;
    if (progress !== undefined) this.#progress(progress);
    if (preview !== undefined) this.#preview(preview, parts);
    if (beat === this.#id) this.#hold();
    if (ask !== undefined) void this.#resolve(ask, uri);
    if (done !== this.#id) return false;
    const { aborted } = this.#scope.signal;
    this.#finish();
    try {
      if (aborted) this.#forgetMade();
      else if (error) this.#settle.reject(this.#errorOf(error));
      else this.#settle.resolve(this.#unpack(value, parts));
    } catch (thrown) {
      this.#settle.reject(toTelarError(thrown));
    }
    return true;
  }

  /** The worker ended. @param {Error} error */
  end(error) {
    this.#finish();
    this.#settle.reject(error);
  }

  #unpack(value, parts) {
    const answer = this.#request.unpack(value, parts);
    const { recipe, method } = this.#request;
    if (method === 'load' || method === 'derive') this.#held.use(recipe.id, modelBytes(answer));
    return answer;
  }

  #finish() {
    clearTimeout(this.#clock);
    this.#stopListening?.();
    this.#scope.abort();
    const { recipe } = this.#request;
    if (recipe && !this.#loaded) this.#forget(recipe.chain.map(({ id }) => id).filter((id) => !this.#held.has(id)));
  }

  /** A model that its caller does not wait for any more. */
  #forgetMade() {
    const { recipe, method } = this.#request;
    if ((method === 'load' || method === 'derive') && this.#held.forget(recipe.id)) this.#forget([recipe.id]);
  }

  #forget(ids) {
    if (ids.length > 0) this.#worker.send({ forget: ids });
  }

  /** The worker has the model. */
  #hold() {
    this.#loaded = true;
    for (const { id, bytes } of this.#request.recipe.chain) this.#held.use(id, bytes);
    this.#startClock();
  }

  /**
   * A worker that does not stop by itself is ended GRACE_MS after the time of a picture, which begins anew with each. In renderAll the loading has
   * a time of its own.
   */
  #startClock() {
    // What was on its way when the caller aborted leaves the clock of #abort as it is.
    if (this.#scope.signal.aborted) return;
    clearTimeout(this.#clock);
    const { timeoutMs, method, recipe, shots = [] } = this.#request;
    const works = DRAW_MANY.includes(method) && !recipe && !this.#told ? 2 : 1;
    const allowed = timeoutMs === undefined ? TIMEOUT_MS : timeoutMs;
    if (allowed === null) return;
    this.#clock = setTimeout(
      async () => {
        if (timeoutMs === undefined && (await hasLongShot(shots.map(({ shot }) => shot)))) return;
        if (!this.#scope.signal.aborted) this.#worker.kill(overTime(allowed));
      },
      Math.min(works * allowed + GRACE_MS, LONGEST),
    ).unref();
  }

  #progress(part) {
    this.#told = true;
    if (DRAW_MANY.includes(this.#request.method)) this.#startClock();
    this.#call(this.#request.onProgress, part);
  }

  /** Of a worker that was taken over these may be any numbers: what is told has as many bytes as its size says. */
  #preview({ width, height, bitDepth, samples }, [data]) {
    const isWhole = [width, height, bitDepth, samples].every(Number.isSafeInteger) && data?.length === (width * height * bitDepth) / 2;
    if (isWhole) this.#call(this.#request.onPreview, { width, height, bitDepth, samples, data });
  }

  #call(callback, what) {
    if (this.#scope.signal.aborted) return;
    try {
      callback?.(what);
    } catch (error) {
      this.#abort(error);
    }
  }

  #abort(reason) {
    if (this.#scope.signal.aborted) return;
    this.#scope.abort(reason);
    this.#settle.reject(reason);
    this.#worker.send({ cancel: this.#id });
    clearTimeout(this.#clock);
    this.#clock = setTimeout(() => this.#worker.kill(), GRACE_MS).unref();
  }

  async #resolve(id, uri) {
    const { recipe, loading } = this.#request;
    const answer = { id, of: this.#id };
    try {
      const { resolve } = recipe ? recipe.root.loading : loading;
      const given = await resolve(uri, { signal: this.#scope.signal });
      const absent = given === null || given === undefined;
      this.#worker.send({ part: { ...answer, absent } }, absent ? [] : [Uint8Array.from(partBytes(given, uri))]);
    } catch (cause) {
      this.#resolveFailure ??= { cause };
      this.#worker.send({ part: { ...answer, error: toTelarError(cause).toJSON() } });
    }
  }

  /** As the renderer would have thrown it: the caller's own failure of `resolve` is the cause of an X_RESOLVE. */
  #errorOf(plain) {
    const error = fromNative(plain);
    if (error.code === 'X_RESOLVE' && this.#resolveFailure) error.cause = this.#resolveFailure.cause;
    return error;
  }
}
