import { randomUUID } from 'node:crypto';
import { TelarError, toTelarError } from '../error/index.mjs';

/**
 * Jobs that are asked for now and fetched later. The service needs no more of a queue than this; MemoryQueue keeps jobs in this process.
 * @typedef {object} JobQueue
 * @property {() => void} check throws X_BUSY where one more job would be refused
 * @property {(task: import('./task.mjs').Task, meta: object) => Promise<JobState>} add X_BUSY; meta: plain data, given back with the result
 * @property {(id: string) => Promise<JobState | undefined>} get
 * @property {(id: string) => Promise<{result: import('./perform.mjs').Result, meta: object} | undefined>} result of a job that is done
 * @property {(id: string) => Promise<JobState | undefined>} cancel
 * @property {(id: string, listener: (state: JobState, preview?: import('../index.js').Preview) => void) => () => void} watch tells of what changes, and
 *   shows pictures so far where it has them; the returned function ends it
 * @property {() => Promise<void>} idle resolves when no job waits or runs
 * @property {() => {waiting: number, running: number, kept: number}} counts
 * @property {(reason: TelarError) => void} abort ends what waits and runs
 *
 * @typedef {object} JobState
 * @property {string} id not to be guessed
 * @property {string} kind
 * @property {'waiting' | 'running' | 'done' | 'failed' | 'cancelled'} state
 * @property {number} progress 0..1
 * @property {number} created milliseconds since 1970
 * @property {number} [started]
 * @property {number} [ended]
 * @property {TelarError} [error] of a job that failed
 */

/** Jobs that are over and kept, for each that may wait: those that failed take memory too. */
const KEPT_EACH = 16;
/** Steps of progress that listeners are told of. */
const STEP = 0.01;

const bytesIn = (values) => values.reduce((sum, { byteLength }) => sum + byteLength, 0);
const taskBytes = ({ files, asked }) => bytesIn(Object.values(files)) + (asked.shot?.environment?.map?.byteLength ?? 0);
const isOver = ({ state }) => state !== 'waiting' && state !== 'running';

/** @implements {JobQueue} */
export class MemoryQueue {
  #work;
  #bounds;
  /** In order of arrival; those that are over in order of their end. */
  #jobs = new Map();
  #waiting = new Set();
  #running = new Set();
  #taskBytes = 0;
  #resultBytes = 0;

  /**
   * @param {(task: object, how: {signal: AbortSignal, onProgress: (part: number) => void}) => Promise<import('./perform.mjs').Result>} work
   * @param {{atOnce: number, jobs: number, jobBytes: number, resultBytes: number, resultMs: number}} bounds jobs: that wait; jobBytes: of what waits
   *   and runs; resultBytes: of what is kept
   */
  constructor(work, bounds) {
    this.#work = work;
    this.#bounds = bounds;
  }

  check() {
    if (this.#waiting.size >= this.#bounds.jobs)
      throw new TelarError('X_BUSY', `${this.#waiting.size} jobs wait in the queue of this service, as many as may; try again later`);
  }

  async add(task, meta) {
    this.check();
    const bytes = taskBytes(task);
    if (this.#taskBytes > 0 && this.#taskBytes + bytes > this.#bounds.jobBytes)
      throw new TelarError('X_BUSY', 'the files of the jobs that wait take all the memory that they may; try again later');
    this.#forget();
    this.#taskBytes += bytes;
    const job = { id: randomUUID(), kind: task.kind, state: 'waiting', progress: 0, created: Date.now(), task, bytes, meta };
    Object.assign(job, { controller: new AbortController(), listeners: new Set() });
    this.#jobs.set(job.id, job);
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
    if (!isOver(job)) this.#stop(job, new TelarError('X_CANCELLED', 'the job was cancelled'));
    return stateOf(job);
  }

  watch(id, listener) {
    const job = this.#jobs.get(id);
    job?.listeners.add(listener);
    return () => job?.listeners.delete(listener);
  }

  counts() {
    return { waiting: this.#waiting.size, running: this.#running.size, kept: this.#jobs.size - this.#waiting.size - this.#running.size };
  }

  async idle() {
    while (this.#waiting.size + this.#running.size > 0) await Promise.allSettled([...this.#running].map(({ working }) => working));
  }

  abort(reason) {
    for (const job of [...this.#waiting, ...this.#running]) this.#stop(job, reason);
  }

  /** Its worker stops by the signal; nobody waits for it. */
  #stop(job, reason) {
    this.#end(job, reason.code === 'X_CANCELLED' ? 'cancelled' : 'failed', { error: reason });
    job.controller.abort(reason);
  }

  #next() {
    const [job] = this.#waiting;
    if (!job || this.#running.size >= this.#bounds.atOnce) return;
    this.#waiting.delete(job);
    this.#running.add(job);
    job.working = this.#run(job).finally(() => {
      this.#running.delete(job);
      this.#taskBytes -= job.bytes;
      job.task = undefined;
      this.#next();
    });
    this.#next();
  }

  async #run(job) {
    const onProgress = (part) => {
      if (isOver(job) || part - job.progress < STEP) return;
      job.progress = part;
      tell(job);
    };
    const onPreview = (preview) => {
      if (!isOver(job)) tell(job, preview);
    };
    const onStart = () => {
      if (isOver(job)) return;
      Object.assign(job, { state: 'running', started: Date.now() });
      tell(job);
    };
    try {
      const result = await this.#work(job.task, { signal: job.controller.signal, onProgress, onPreview, onStart });
      this.#end(job, 'done', { result, progress: 1 });
    } catch (error) {
      this.#end(job, 'failed', { error: toTelarError(error) });
    }
  }

  #end(job, state, facts) {
    if (isOver(job)) return;
    if (this.#waiting.delete(job)) {
      this.#taskBytes -= job.bytes;
      job.task = undefined;
    }
    Object.assign(job, facts, { state, ended: Date.now() });
    this.#jobs.delete(job.id);
    this.#jobs.set(job.id, job);
    job.resultBytes = bytesIn((job.result?.files ?? []).map(({ data }) => data));
    this.#resultBytes += job.resultBytes;
    tell(job);
    job.listeners.clear();
    this.#forget();
  }

  /** Results that are old, or more than may be kept, go: the oldest first, and never the last. */
  #forget() {
    const over = [...this.#jobs.values()].filter(isOver);
    const { resultMs, resultBytes, jobs } = this.#bounds;
    for (const [i, { id, ended, resultBytes: bytes }] of over.entries()) {
      const isTooMuch = i < over.length - 1 && (this.#resultBytes > resultBytes || over.length - i > KEPT_EACH * Math.max(jobs, 1));
      if (!isTooMuch && Date.now() - ended < resultMs) return;
      this.#jobs.delete(id);
      this.#resultBytes -= bytes;
    }
  }
}

function stateOf({ id, kind, state, progress, created, started, ended, error }) {
  return { id, kind, state, progress, created, ...(started && { started }), ...(ended && { ended }), ...(error && { error }) };
}

function tell(job, preview) {
  for (const listener of job.listeners) listener(stateOf(job), preview);
}
