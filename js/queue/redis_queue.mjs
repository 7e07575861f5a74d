import { TelarError, fromNative } from '../error/index.mjs';
import { FolderStore } from './folder_store.mjs';
import { STEP, isKept, isOver } from './job_queue.mjs';
import { readAdding } from './options.mjs';
import { jobId, packTask } from './pack.mjs';
import { RedisMarks } from './redis_marks.mjs';
import { RedisRuns } from './redis_runs.mjs';
import { checkServer, closedInTime, connect, letGoOf, libraries, told } from './redis_server.mjs';
import { RedisStore } from './redis_store.mjs';
import { loadResult, refsOf, storeTask } from './stored.mjs';
import { cancelled, poisoned, tooLarge, tooManyWait, tooOften } from './verdict.mjs';

/** Names of BullMQ's keys begin so. */
const PREFIX = 'telar';
/** What ends a job in BullMQ itself: its workers ended. */
const STALLED = /stalled more than/;
/** Milliseconds after which listeners are told of what no event told. */
const LOOK_MS = 2000;
/** Milliseconds between two looks at the folder of bytes. */
const SWEEP_MS = 3_600_000;
/** Jobs that are over and kept. */
const KEPT = 100_000;
const EVENTS = ['waiting', 'active', 'progress', 'completed', 'failed', 'delayed', 'removed'];

/** The error of a job that failed; its worker wrote it down as JSON. */
function errorOf({ failedReason = '', stalledCounter }) {
  if (STALLED.test(failedReason)) return poisoned(stalledCounter);
  try {
    return fromNative(JSON.parse(failedReason));
  } catch {
    return new TelarError('X_INTERNAL', failedReason);
  }
}

/**
 * Jobs of BullMQ on a Redis or Valkey server: processes of many machines share it.
 * @implements {import('./job_queue.mjs').JobQueue}
 */
export class RedisQueue {
  warnings;
  #bounds;
  #bullmq;
  #client;
  #queue;
  #store;
  #marks;
  #runs;
  #events;
  /** What lets go of the connections. */
  #lettingGo = [];
  #listeners = new Map();
  /** The last adding. */
  #adding = Promise.resolve();
  #timers = [];

  /**
   * @param {object} bounds of readQueueOptions()
   * @throws {TelarError} X_QUEUE, X_LIBRARY_MISSING
   */
  static async open(bounds) {
    const bullmq = await libraries();
    const client = connect(bullmq.Redis, bounds.redis, { waits: false });
    try {
      let why;
      client.on('error', (error) => {
        why = error;
      });
      await told(() => client.connect().catch((error) => Promise.reject(why ?? error)));
      const warnings = await told(() => checkServer(client));
      const store = bounds.folder === undefined ? new RedisStore(client, `${PREFIX}-bytes:${bounds.name}:`) : await FolderStore.open(bounds.folder);
      return new RedisQueue(bounds, { bullmq, client, store, warnings });
    } catch (error) {
      client.disconnect();
      throw error;
    }
  }

  constructor(bounds, { bullmq, client, store, warnings }) {
    this.warnings = warnings;
    this.#bounds = bounds;
    this.#bullmq = bullmq;
    this.#client = client;
    this.#lettingGo.push(letGoOf(client));
    this.#store = store;
    this.#marks = this.#marksOf(client);
    this.#queue = new bullmq.Queue(bounds.name, { connection: client, prefix: PREFIX, skipVersionCheck: true });
    this.#queue.on('error', () => {}); // each call tells
    this.#timers.push(setInterval(() => this.#look(), LOOK_MS));
    this.#timers.push(setInterval(() => store.sweep(Math.max(bounds.waitMs, bounds.resultMs)).catch(() => {}), SWEEP_MS));
  }

  #key(what, id) {
    return `${PREFIX}-${what}:${this.#bounds.name}:${id}`;
  }

  #marksOf(client) {
    return new RedisMarks(client, (id) => this.#key('cancelled', id));
  }

  #rateKey(tenant) {
    return this.#key('added', `${Math.floor(Date.now() / this.#bounds.tenantMs)}:${tenant}`);
  }

  async check(tenant = '') {
    const { waiting } = await this.counts();
    if (waiting >= this.#bounds.jobs) throw tooManyWait(waiting);
    const { tenantJobs } = this.#bounds;
    if (tenantJobs !== undefined && Number(await told(() => this.#client.get(this.#rateKey(tenant)))) >= tenantJobs) throw tooOften(this.#bounds);
  }

  async add(task, how) {
    const { meta, tenant, priority, put } = readAdding(how);
    const packed = packTask(task);
    if (packed.bytes > this.#bounds.taskBytes) throw tooLarge(packed.bytes, this.#bounds);
    const id = await jobId(packed, { meta, tenant, put });
    return told(async () => {
      const { known } = await this.#found(id);
      if (known) return known;
      await this.check(tenant);
      const stored = await storeTask(this.#store, packed, this.#bounds.waitMs);
      return this.#oneByOne(async () => {
        try {
          const meanwhile = await this.#found(id);
          if (meanwhile.known) {
            await this.#store.drop(refsOf(stored));
            return meanwhile.known;
          }
          await this.check(tenant);
          await this.#count(tenant);
          if (meanwhile.before) await this.#makeRoom(meanwhile.before);
          await this.#marks.clear(id);
        } catch (error) {
          await this.#store.drop(refsOf(stored)).catch(() => {});
          throw error;
        }
        await this.#addStored(id, { kind: task.kind, task: stored, meta, put, ends: 0 }, priority);
        return this.get(id);
      });
    });
  }

  /** The job, as far as it is known, and its state where it stays as it is. */
  async #found(id) {
    const before = await this.#queue.getJob(id);
    const state = await this.#stateOf(id, before);
    return { before, known: state && isKept(state) ? state : undefined };
  }

  /** Between a look at the bounds and the adding, this process adds no other job. */
  #oneByOne(use) {
    const done = this.#adding.then(use);
    this.#adding = done.catch(() => {});
    return done;
  }

  async #addStored(id, data, priority) {
    const { attempts, resultMs, quarantineMs } = this.#bounds;
    const keep = (ms) => ({ age: Math.ceil(ms / 1000), count: KEPT });
    const options = { jobId: id, priority: priority + 1, attempts, backoff: { type: 'telar' }, stackTraceLimit: 0 };
    try {
      await this.#queue.add(data.kind, data, { ...options, removeOnComplete: keep(resultMs), removeOnFail: keep(Math.max(resultMs, quarantineMs)) });
      const job = await this.#queue.getJob(id);
      // Another process may have been quicker: the job has its bytes.
      if (refsOf(job?.data.task)[0] !== refsOf(data.task)[0]) await this.#store.drop(refsOf(data.task));
    } catch (error) {
      // Whether the server has the job is not known; where it has, its bytes are needed.
      if (!/Connection|closed|writeable|timed out|ECONN|EPIPE/i.test(error.message)) await this.#store.drop(refsOf(data.task)).catch(() => {});
      throw error;
    }
  }

  /** An ended job goes, so that it can run again. */
  async #makeRoom(job) {
    try {
      await job.remove();
    } catch (cause) {
      throw new TelarError('X_BUSY', 'the job was cancelled, and its worker is about to stop; try again later', { cause });
    }
  }

  async #count(tenant) {
    if (this.#bounds.tenantJobs === undefined) return;
    const key = this.#rateKey(tenant);
    await this.#client.multi().incr(key).pexpire(key, this.#bounds.tenantMs).exec();
  }

  /** @param {import('bullmq').Job | undefined} job */
  async #stateOf(id, job) {
    const cancelledAs = await this.#marks.cancelled(id);
    if (cancelledAs || !job) return cancelledAs;
    const { data, timestamp: created, processedOn: started, finishedOn: ended, progress, attemptsStarted: tries } = job;
    // What an earlier try failed with stays in a job that is done.
    const error = ended && !job.returnvalue ? errorOf(job) : undefined;
    const age = error?.code === 'X_QUARANTINE' ? this.#bounds.quarantineMs : this.#bounds.resultMs;
    if (ended && Date.now() - ended >= age) return undefined;
    const state = stateName(ended, error, !ended && (await job.isActive()));
    const part = state === 'done' ? 1 : state === 'waiting' || typeof progress !== 'number' ? 0 : progress;
    return { id, kind: data.kind, state, progress: part, created, ...(started && { started }), ...(ended && { ended }), tries, ...(error && { error }) };
  }

  get(id) {
    return told(async () => this.#stateOf(id, await this.#queue.getJob(id)));
  }

  result(id) {
    return told(async () => {
      const job = await this.#queue.getJob(id);
      if ((await this.#stateOf(id, job))?.state !== 'done') return undefined;
      const result = await loadResult(this.#store, job.returnvalue);
      return result && { result, meta: job.data.meta };
    });
  }

  cancel(id) {
    return told(async () => {
      const job = await this.#queue.getJob(id);
      const state = await this.#stateOf(id, job);
      if (!job || !state || isOver(state)) return state;
      const over = { ...state, state: 'cancelled', ended: Date.now(), error: cancelled() };
      // A worker that has its end already is not stopped.
      if (!(await this.#marks.cancel(id, over, Math.max(this.#bounds.resultMs, this.#bounds.leaseMs)))) return this.#stateOf(id, job);
      // A job that runs cannot be removed: its worker sees the mark.
      const removed = await job.remove().then(
        () => true,
        () => false,
      );
      if (removed) await this.#store.drop(refsOf(job.data.task)).catch(() => {});
      this.#tell(id);
      return over;
    });
  }

  watch(id, listener) {
    this.#listen();
    const entry = this.#listeners.get(id) ?? { told: undefined, all: new Set(), last: Promise.resolve() };
    this.#listeners.set(id, entry);
    entry.all.add(listener);
    // It may have changed since its watcher asked last.
    this.#tell(id);
    return () => {
      entry.all.delete(listener);
      if (entry.all.size === 0 && this.#listeners.get(id) === entry) this.#listeners.delete(id);
    };
  }

  /** One stream of events for all listeners. */
  #listen() {
    if (this.#events) return;
    const connection = connect(this.#bullmq.Redis, this.#bounds.redis, { waits: true });
    this.#lettingGo.push(letGoOf(connection));
    this.#events = new this.#bullmq.QueueEvents(this.#bounds.name, { connection, prefix: PREFIX, skipVersionCheck: true });
    this.#events.on('error', () => {}); // it connects again
    for (const event of EVENTS) this.#events.on(event, ({ jobId }) => this.#tell(jobId));
  }

  /** In the order of the events, and no state twice. */
  #tell(id) {
    const entry = this.#listeners.get(id);
    if (!entry) return;
    entry.last = entry.last.then(async () => {
      const state = await this.get(id).catch(() => undefined);
      if (!state) return;
      if (isNews(entry.told, state)) {
        entry.told = state;
        for (const listener of entry.all) listener(state);
      }
      if (isOver(state)) this.#listeners.delete(id);
      else if (state.state === 'running') await this.#show(state, entry);
    });
  }

  /** The picture so far, where it is another one than before. */
  async #show(state, entry) {
    const text = await this.#client.get(this.#key('preview', state.id)).catch(() => null);
    const { png, ...shown } = JSON.parse(text ?? '{}');
    if (!text || shown.samples === entry.samples) return;
    entry.samples = shown.samples;
    for (const listener of entry.all) listener(state, { ...shown, png: Buffer.from(png, 'base64') });
  }

  /** Events may be missed while the server is away. */
  #look() {
    for (const id of this.#listeners.keys()) this.#tell(id);
  }

  counts() {
    return told(async () => {
      const { wait, waiting = wait ?? 0, prioritized, delayed, active, completed, failed } = await this.#queue.getJobCounts();
      return { waiting: waiting + prioritized + delayed, running: active, kept: completed + failed };
    });
  }

  take(work, { atOnce, hosts }) {
    this.#runs = new RedisRuns(work, {
      atOnce,
      hosts,
      bounds: this.#bounds,
      bullmq: this.#bullmq,
      prefix: PREFIX,
      store: (client) => (this.#store instanceof RedisStore ? new RedisStore(client, `${PREFIX}-bytes:${this.#bounds.name}:`) : this.#store),
      marksOf: (client) => this.#marksOf(client),
      previewOf: (id) => this.#key('preview', id),
    });
  }

  async idle() {
    await this.#runs?.idle();
  }

  abort(reason) {
    this.#runs?.abort(reason);
  }

  async close() {
    this.#timers.forEach(clearInterval);
    this.abort(new TelarError('X_SHUTDOWN', 'the queue was closed'));
    await this.idle();
    await closedInTime([this.#events?.close(), this.#queue.close()]);
    for (const letGo of this.#lettingGo) letGo();
  }
}

const stateName = (ended, error, isActive) => {
  if (error) return error.code === 'X_CANCELLED' ? 'cancelled' : 'failed';
  if (ended) return 'done';
  return isActive ? 'running' : 'waiting';
};

const isNews = (told, { state, progress, tries }) =>
  told?.state !== state || told.tries !== tries || progress - told.progress >= STEP || progress < told.progress;
