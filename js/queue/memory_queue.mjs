import { TelarError, toTelarError } from '../error/index.mjs';
import { STEP, isKept, isOver } from './job_queue.mjs';
import { readAdding } from './options.mjs';
import { jobId, packTask } from './pack.mjs';
import { showing } from './preview.mjs';
import { putFiles } from './put.mjs';
import { Rates } from './rates.mjs';
import { busy, cancelled, tooLarge, tooManyWait, tooOften, verdictOf } from './verdict.mjs';

/** Jobs that are over and kept, for each that may wait: those that failed take memory too. */
const KEPT_EACH = 16;

const bytesIn = (values) => values.reduce((sum, { byteLength = 0 }) => sum + byteLength, 0);

/**
 * Jobs in this process: they do not survive its end.
 * @implements {import('./job_queue.mjs').JobQueue}
 */
export class MemoryQueue {
  warnings = [];
  #work;
  #atOnce = 0;
  #hosts;
  #bounds;
  #rates;
  /** In order of arrival; those that are over in order of their end. */
  #jobs = new Map();
  #waiting = new Set();
  #running = new Set();
  /** Until their next try. */
  #delayed = new Map();
  #taskBytes = 0;
  #resultBytes = 0;

  /** @param {object} bounds of readQueueOptions() */
  constructor(bounds) {
    this.#bounds = bounds;
    this.#rates = new Rates(bounds);
  }

  get #waits() {
    return this.#waiting.size + this.#delayed.size;
  }

  check(tenant = '') {
    if (this.#waits >= this.#bounds.jobs) throw tooManyWait(this.#waits);
    if (this.#rates.isFull(tenant)) throw tooOften(this.#bounds);
  }

  async add(task, how) {
    const { meta, tenant, priority, put } = readAdding(how);
    const packed = packTask(task);
    if (packed.bytes > this.#bounds.taskBytes) throw tooLarge(packed.bytes, this.#bounds);
    const id = await jobId(packed, { meta, tenant, put });
    this.#forget();
    const found = this.#jobs.get(id);
    if (found && isKept(found)) return stateOf(found);
    this.check(tenant);
    if (this.#taskBytes > 0 && this.#taskBytes + packed.bytes > this.#bounds.jobBytes)
      throw busy('the files of the jobs that wait take all the memory that they may');
    this.#rates.count(tenant);
    if (found) this.#drop(found);
    this.#taskBytes += packed.bytes;
    const job = { id, kind: task.kind, state: 'waiting', progress: 0, created: Date.now(), tries: 0, ends: 0, task, bytes: packed.bytes, meta, priority, put };
    Object.assign(job, { controller: new AbortController(), listeners: new Set() });
    this.#jobs.set(id, job);
    this.#waiting.add(job);
    const state = stateOf(job);
    this.#next();
    return state;
  }

  async get(id) {
    this.#forget();
    const job = this.#jobs.get(id);
    return job && stateOf(job);
  }

  async result(id) {
    const { result, meta } = this.#jobs.get(id) ?? {};
    return result && { result, meta };
  }

  async cancel(id) {
    const job = this.#jobs.get(id);
    if (!job) return undefined;
    if (!isOver(job)) this.#stop(job, cancelled());
    return stateOf(job);
  }

  watch(id, listener) {
    const job = this.#jobs.get(id);
    job?.listeners.add(listener);
    // It may have ended since its watcher asked last.
    if (job && isOver(job)) queueMicrotask(() => job.listeners.has(listener) && listener(stateOf(job)));
    return () => job?.listeners.delete(listener);
  }

  counts() {
    return { waiting: this.#waits, running: this.#running.size, kept: [...this.#jobs.values()].filter(isOver).length };
  }

  take(work, { atOnce, hosts }) {
    this.#work = work;
    this.#atOnce = atOnce;
    this.#hosts = hosts;
    this.#next();
  }

  /** What waits is finished too: no other process could take it. Where nobody draws, nothing of it ever ends. */
  async idle() {
    if (!this.#work) return;
    for (const job of this.#delayed.keys()) this.#again(job);
    while (this.#waits + this.#running.size > 0) {
      await Promise.allSettled([...this.#running].map(({ working }) => working));
      for (const job of this.#delayed.keys()) this.#again(job);
    }
  }

  abort(reason) {
    for (const job of [...this.#waiting, ...this.#delayed.keys(), ...this.#running]) this.#stop(job, reason);
  }

  async close() {
    this.abort(new TelarError('X_SHUTDOWN', 'the queue was closed'));
  }

  /** Its worker stops by the signal; nobody waits for it. */
  #stop(job, reason) {
    this.#end(job, reason.code === 'X_CANCELLED' ? 'cancelled' : 'failed', { error: reason });
    job.controller.abort(reason);
  }

  #next() {
    if (this.#running.size >= this.#atOnce || this.#waiting.size === 0) return;
    let [job] = this.#waiting;
    for (const other of this.#waiting) if (other.priority < job.priority) job = other;
    this.#waiting.delete(job);
    this.#running.add(job);
    job.working = this.#run(job).finally(() => {
      this.#running.delete(job);
      if (isOver(job)) this.#release(job);
      this.#next();
    });
    this.#next();
  }

  #release(job) {
    if (!job.task) return;
    this.#taskBytes -= job.bytes;
    job.task = undefined;
  }

  async #run(job) {
    const onProgress = (part) => {
      if (isOver(job) || part - job.progress < STEP) return;
      job.progress = part;
      tell(job);
    };
    const onPreview = showing((preview) => {
      if (!isOver(job)) tell(job, preview);
    });
    const onStart = () => {
      if (isOver(job)) return;
      Object.assign(job, { state: 'running', started: Date.now() });
      tell(job);
    };
    const { signal } = job.controller;
    job.tries += 1;
    try {
      const result = await this.#work(job.task, { signal, onProgress, onPreview, onStart });
      const files = job.put ? await putFiles(result.files, job.put, { signal, hosts: this.#hosts }) : result.files;
      this.#end(job, 'done', { result: { ...result, files }, progress: 1 });
    } catch (error) {
      this.#failed(job, error);
    }
  }

  #failed(job, thrown) {
    if (isOver(job)) return;
    const verdict = verdictOf(thrown, job, this.#bounds);
    if (verdict.does === 'end') return this.#end(job, verdict.state, { error: verdict.error });
    // There is no other process that it could be given to.
    if (verdict.does === 'give back') return this.#end(job, 'failed', { error: toTelarError(thrown) });
    Object.assign(job, { state: 'waiting', progress: 0, ends: verdict.ends });
    this.#delayed.set(
      job,
      setTimeout(() => this.#again(job), verdict.afterMs),
    );
    tell(job);
  }

  #again(job) {
    clearTimeout(this.#delayed.get(job));
    this.#delayed.delete(job);
    this.#waiting.add(job);
    this.#next();
  }

  #end(job, state, facts) {
    if (isOver(job)) return;
    clearTimeout(this.#delayed.get(job));
    if (this.#delayed.delete(job) || this.#waiting.delete(job)) this.#release(job);
    Object.assign(job, facts, { state, ended: Date.now() });
    this.#jobs.delete(job.id);
    this.#jobs.set(job.id, job);
    job.resultBytes = bytesIn((job.result?.files ?? []).map(({ data }) => data ?? {}));
    this.#resultBytes += job.resultBytes;
    tell(job);
    job.listeners.clear();
    this.#forget();
  }

  #drop({ id, resultBytes }) {
    this.#jobs.delete(id);
    this.#resultBytes -= resultBytes;
  }

  /** Results that are old, or more than may be kept, go: the oldest first, and never the last. */
  #forget() {
    const over = [...this.#jobs.values()].filter(isOver);
    const { resultMs, quarantineMs, resultBytes, jobs } = this.#bounds;
    for (const [i, job] of over.entries()) {
      const isTooMuch = i < over.length - 1 && (this.#resultBytes > resultBytes || over.length - i > KEPT_EACH * Math.max(jobs, 1));
      const age = Date.now() - job.ended;
      if (isTooMuch || age >= (job.error?.code === 'X_QUARANTINE' ? quarantineMs : resultMs)) this.#drop(job);
    }
  }
}

function stateOf({ id, kind, state, progress, created, started, ended, tries, error }) {
  return { id, kind, state, progress, created, ...(started && { started }), ...(ended && { ended }), tries, ...(error && { error }) };
}

function tell(job, preview) {
  for (const listener of job.listeners) listener(stateOf(job), preview);
}
