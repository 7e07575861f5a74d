import { TelarError } from '../error/index.mjs';
import { hasSharp } from '../api/avif.mjs';
import { loadNative } from '../api/native.mjs';
import { onAbort } from '../api/on_abort.mjs';
import { wrongOption } from '../api/option_check.mjs';
import { Admission } from './admission.mjs';
import { wantedOf } from './answer.mjs';
import { tagOf, isUnchanged } from './conditional.mjs';
import { ownLight } from './light.mjs';
import { openMetrics } from './metrics.mjs';
import { keyOf } from '../queue/key.mjs';
import { openQueue } from '../queue/open.mjs';
import { perform } from '../queue/perform.mjs';
import { checkGivenSize, checkStored, isSizedByModel } from '../queue/picture_size.mjs';
import { ResultStore } from '../queue/result_store.mjs';
import { References } from './references.mjs';
import { Scope, priorityOf, waitOf } from './scope.mjs';
import { Signatures } from './signature.mjs';
import { openSpans } from './spans.mjs';
import { readTask } from './task.mjs';

/** Jobs that wait for each worker, where the owner does not say it. */
const WAITING_EACH = 4;

const isPool = (value) => typeof value?.render === 'function' && typeof value.close === 'function';
const isQueue = (value) => typeof value?.take === 'function' && typeof value.close === 'function';

/** null where the queue is away. */
async function countsOf(queue) {
  try {
    return await queue.counts();
  } catch {
    return null;
  }
}

/** The queue in this process, or the one that the owner names; it holds what a request may be. */
function ownQueue({ queue, drawJobs, jobs, jobBytes, resultBytes, resultMs, requestBytes }) {
  if (!drawJobs && queue?.redis === undefined && queue?.sqlite === undefined)
    throw wrongOption('options.drawJobs', 'true, or a queue on Redis or in SQLite: no other process draws the jobs of this one', drawJobs);
  return openQueue({ jobs, jobBytes, resultBytes, resultMs, taskBytes: requestBytes, ...queue });
}

/** What the routes share: the pool, who may use it now, and how a request becomes a result. */
export class Service {
  #options;
  #pool;
  #owns;
  #references;
  #fileBytes;
  #timeoutMs;
  #scopes = new Set();
  #able = { avif: hasSharp() };
  /** @type {ResultStore | undefined} */
  #store;

  /** @param {object} options of readOptions() */
  static async open(options) {
    const given = options.pool ?? {};
    const queue = isQueue(options.queue) ? options.queue : await ownQueue(options);
    const owns = { queue: queue !== options.queue, pool: !isPool(given) };
    let pool = given;
    try {
      if (owns.pool) pool = await (await import('../pool/index.mjs')).createPool(given);
      const service = await new Service(options, { pool, queue, owns }).#withMetrics();
      service.#takeJobs();
      return service;
    } catch (error) {
      if (owns.pool && isPool(pool)) await pool.close();
      if (owns.queue) await queue.close();
      throw error;
    }
  }

  constructor(options, { pool, queue, owns }) {
    this.#options = options;
    this.#pool = pool;
    this.#owns = owns;
    this.queue = queue;
    const ownsPool = owns.pool;
    this.#timeoutMs = (ownsPool && options.pool?.timeoutMs) || Infinity;
    this.#fileBytes = Math.min(options.requestBytes, (ownsPool && options.pool?.limits?.L_FILE_BYTES) || loadNative().limits.L_FILE_BYTES);
    this.signatures = new Signatures(options.signingKeys);
    this.#references = new References({ ...options, maxBytes: this.#fileBytes });
    const places = Math.max(1, pool.workers.length);
    this.admission = new Admission({ places, waiting: options.waiting ?? WAITING_EACH * places, uploads: options.uploads, uploadBytes: options.uploadBytes });
  }

  async #withMetrics() {
    this.metrics = await openMetrics({ admission: this.admission, queue: this.queue, pool: this.#pool });
    this.spans = await openSpans();
    const { store, storeBytes } = this.#options;
    this.#store = await ResultStore.open(store, storeBytes, (outcome) => this.metrics.stored.inc({ outcome }));
    return this;
  }

  /** A queue that outlives processes may have waiting ones: they are drawn at once. */
  #takeJobs() {
    if (this.#options.drawJobs) this.queue.take((task, how) => this.#workLater(task, how), { atOnce: this.admission.places });
  }

  /** Whether a worker is there, and work is let in. */
  async state() {
    const { workers } = this.#pool;
    const count = (state) => workers.filter((worker) => worker.state === state).length;
    const facts = {
      workers: { idle: count('idle'), busy: count('busy'), starting: count('starting') },
      running: this.admission.running,
      waiting: this.admission.waiting,
      jobs: await countsOf(this.queue),
    };
    const lacks = facts.workers.idle + facts.workers.busy === 0 ? 'no workers' : facts.jobs === null && 'no queue';
    return { status: this.admission.isClosed ? 'ending' : lacks || 'ready', ...facts };
  }

  /**
   * A request as a task whose bytes are there.
   * @param {string} kind
   * @param {{method: string, query: URLSearchParams, raw: import('node:http').IncomingMessage, isSigned?: boolean}} request
   * @param {Scope} scope its clock starts when the request is there: what the owner or another host takes for a reference is part of the answer's time
   * @param {() => void} [check] whether there is room
   * @returns {Promise<import('./task.mjs').Task>}
   */
  read(kind, request, scope, check) {
    const { uploadMs, requestBytes, environments, side, deadlineMs } = this.#options;
    const { signal } = scope;
    return this.admission.receive(async () => {
      const { asked, files } = await readTask(kind, request, { signal, ms: uploadMs, maxBytes: requestBytes, fileBytes: this.#fileBytes, held: scope.held });
      scope.startClock(waitOf(request.raw, deadlineMs));
      const { model: reference, ...rest } = asked;
      const { environment: light, ...own } = files;
      if (kind !== 'compare') own.model = await this.#modelOf(reference, files.model, request, scope);
      else for (const name of ['expected', 'actual']) if (!own[name]) throw missing(name);
      const isDrawn = kind === 'thumbnail' || kind === 'inspect' || kind === 'sheet';
      const shot = isDrawn && ownLight(rest.shot ?? {}, { environments, file: light });
      if (kind === 'thumbnail') checkGivenSize(shot, side);
      // What the model makes of its scale is known when it is loaded, by whichever process.
      const bound = kind === 'thumbnail' && isSizedByModel(shot) && { side };
      this.metrics.received.inc(Object.values(own).reduce((sum, { byteLength }) => sum + byteLength, 0));
      return { kind, asked: { ...rest, ...(isDrawn && { shot }), ...bound }, files: own };
    }, check);
  }

  async #modelOf(reference, file, { isSigned }, { signal, held }) {
    if (file && reference !== undefined) throw new TelarError('E_REQUEST', 'request.model: it is a file and a reference; give one', { pointer: '/model' });
    if (file) return file;
    if (reference === undefined) throw missing('model');
    if (this.signatures.areNeeded && !isSigned) throw new TelarError('E_SIGNATURE', 'this service takes references from signed addresses alone');
    return this.#references.bytes(reference, signal, held);
  }

  /**
   * The result of a request, or the news that its client has it already.
   * @param {string} kind
   * @param {{method: string, query: URLSearchParams, raw: import('node:http').IncomingMessage}} request
   * @param {import('node:http').ServerResponse} response
   * @returns {Promise<{type: string, kind: string, tag?: string, result?: import('../queue/perform.mjs').Result, waited: number, worked: number}>} without result: 304
   */
  answer(kind, request, response) {
    return this.#within(new Scope(response, this.admission.hold()), async (scope) => {
      const { task, type, tag, key, isKnown } = await this.#wanted(kind, request, scope);
      if (isKnown) return { type, kind, tag };
      const { result, waited, worked } = await this.#work(task, scope, 'run', { key, span: request.span });
      return { type, kind, result, waited, worked };
    });
  }

  /**
   * A request as a job whose result is fetched later; of what the client has already there is none.
   * @returns {Promise<import('../queue/job_queue.mjs').JobState>}
   */
  submit(kind, request, response) {
    return this.#within(new Scope(response, this.admission.hold()), async (scope) => {
      const { headers } = request.raw;
      const { tenantHeader } = this.#options;
      const tenant = (tenantHeader && headers[tenantHeader.toLowerCase()]) || '';
      const { task, type } = await this.#wanted(kind, request, scope, () => this.queue.check(tenant));
      return this.queue.add(task, { meta: { type, kind }, tenant, ...priorityOf(headers) });
    });
  }

  async #within(scope, use) {
    this.#scopes.add(scope);
    try {
      return await use(scope);
    } finally {
      this.#scopes.delete(scope);
      scope.close();
    }
  }

  async #wanted(kind, request, scope, check) {
    const begun = performance.now();
    const read = await this.read(kind, request, scope, check).finally(() => request.span.add('telar.receive', begun, performance.now()));
    const { task, type } = wantedOf(read, request.raw.headers.accept, this.#able);
    const key = await keyOf(task);
    const tag = key && tagOf(key, type);
    return { task, type, tag, key, isKnown: key !== undefined && isUnchanged(request.raw, tag) };
  }

  /** @param {'run' | 'runLater'} how it is admitted */
  async #work(task, scope, how, { key, span, onProgress, onPreview, onStart } = {}) {
    const asked = performance.now();
    const kept = key && (await this.#store?.get(key, scope.signal));
    if (key && this.#store) span.add('telar.store', asked, performance.now(), { 'telar.outcome': kept ? 'hit' : 'miss' });
    if (kept) {
      onStart?.();
      checkStored(task, kept);
      return { result: kept };
    }
    let begun;
    const spanned = () => {
      span.add('telar.wait', asked, begun ?? performance.now());
      if (begun) span.add('telar.work', begun, performance.now(), { 'telar.kind': task.kind });
    };
    const result = await this.admission[how](() => {
      begun = performance.now();
      onStart?.();
      return this.#perform(task, scope, { onProgress, onPreview });
    }, scope.signal).finally(spanned);
    const [waited, worked] = [(begun - asked) / 1000, (performance.now() - begun) / 1000];
    this.metrics.waited.observe({ kind: task.kind }, waited);
    this.metrics.worked.observe({ kind: task.kind }, worked);
    // By the key that was found here: a worker that was taken over names no other picture's.
    if (key) this.#store?.put({ ...result, key });
    return { result, waited, worked };
  }

  /** What the queue does with a job; its clock starts when it has a worker. */
  #workLater(task, { signal, onProgress, onPreview, onStart }) {
    return this.#within(new Scope(), async (scope) => {
      const span = this.spans.job({ 'telar.kind': task.kind });
      let code;
      const stopListening = onAbort(signal, (reason) => scope.abort(reason));
      try {
        // It may have been cancelled while its bytes were fetched.
        signal.throwIfAborted();
        const start = () => {
          scope.startClock(this.#options.jobMs);
          onStart();
        };
        const key = this.#store && (await keyOf(task));
        return (await this.#work(task, scope, 'runLater', { key, span, onProgress, onPreview, onStart: start })).result;
      } catch (error) {
        ({ code } = error);
        throw error;
      } finally {
        span.end({ attributes: {}, code, isFault: code !== undefined });
        stopListening();
      }
    });
  }

  /** A worker that ended is not the client's fault: another one gets the job, once. */
  async #perform(task, scope, callbacks) {
    try {
      return await this.#performOnce(task, scope, callbacks);
    } catch (error) {
      if (error.code !== 'X_CRASH' || scope.signal.aborted) throw error;
      this.metrics.retries.inc();
      return this.#performOnce(task, scope, callbacks);
    }
  }

  async #performOnce(task, scope, callbacks) {
    const { left } = scope;
    const timeoutMs = Math.min(left, this.#timeoutMs);
    try {
      return await perform(this.#pool, task, { ...callbacks, signal: scope.signal, timeoutMs, templates: this.#options.templates });
    } catch (error) {
      // Of two clocks with one end the worker's may be the first.
      if (error.code === 'X_TIMEOUT' && timeoutMs === left) throw scope.late;
      throw error;
    }
  }

  /** Nothing new is let in. */
  end() {
    this.admission.close();
  }

  /** Resolves when nothing runs. A queue that this process does not draw is not its own to stop. */
  async idle() {
    if (this.#options.drawJobs) await this.queue.idle();
    while (this.#scopes.size > 0) await Promise.allSettled([...this.#scopes].map(({ ended }) => ended));
  }

  /** What still runs is ended. */
  abort() {
    const reason = new TelarError('X_SHUTDOWN', 'the service ended before the answer was there');
    if (this.#options.drawJobs) this.queue.abort(reason);
    for (const scope of this.#scopes) scope.abort(reason);
  }

  async close() {
    this.end();
    this.abort();
    // A queue of the owner takes no more jobs for a pool that is about to close.
    if (this.#options.drawJobs) await this.queue.idle();
    await this.#store?.idle();
    this.metrics.close();
    if (this.#owns.queue) await this.queue.close();
    if (this.#owns.pool) await this.#pool.close();
  }
}

const missing = (name) =>
  new TelarError('E_REQUEST', `request.${name}: expected a file of the request${name === 'model' ? ' or a reference' : ''}, got none`, { pointer: `/${name}` });
