import { toTelarError } from '../error/index.mjs';
import { showing } from './preview.mjs';
import { CLOSE_MS, connect, letGoOf } from './redis_server.mjs';
import { loadTask, refsOf, storeResult } from './stored.mjs';
import { backoffOf, cancelled, isPoison, poisoned, verdictOf } from './verdict.mjs';

/** Milliseconds between two looks whether jobs that run here were cancelled. */
const LOOK_MS = 500;
/** Milliseconds between two writings of how far a job is. */
const PROGRESS_MS = 250;

/** Jobs of a RedisQueue that run in this process: BullMQ's worker takes them, and renews their locks while the process lives. */
export class RedisRuns {
  #how;
  #work;
  #client;
  #store;
  #marks;
  #worker;
  #running = new Map();
  #timer;
  #closing;
  #letGo;

  /**
   * @param {import('./job_queue.mjs').Work} work
   * @param {object} how
   */
  constructor(work, how) {
    const { bullmq, bounds, prefix, atOnce } = how;
    this.#work = work;
    this.#how = how;
    // Unlike whoever adds, a worker waits for a server that is away.
    this.#client = connect(bullmq.Redis, bounds.redis, { waits: true });
    this.#letGo = letGoOf(this.#client);
    this.#store = how.store(this.#client);
    this.#marks = how.marksOf(this.#client);
    this.#worker = new bullmq.Worker(bounds.name, (job, token) => this.#process(job, token), {
      connection: this.#client,
      prefix,
      skipVersionCheck: true,
      concurrency: atOnce,
      lockDuration: bounds.leaseMs,
      stalledInterval: Math.ceil(bounds.leaseMs / 2),
      maxStalledCount: bounds.poison - 1,
      settings: { backoffStrategy: (tries) => backoffOf(tries, bounds) },
    });
    this.#worker.on('error', () => {}); // it connects again
    // What cannot be removed goes by itself, later.
    const drop = ({ id, data }) => Promise.all([this.#store.drop(refsOf(data.task)), this.#client.unlink(how.previewOf(id))]).catch(() => {});
    this.#worker.on('completed', drop);
    this.#worker.on('failed', (job) => {
      if (job?.finishedOn) drop(job);
    });
    this.#timer = setInterval(() => this.#look(), LOOK_MS);
  }

  async #process(job, token) {
    const { bullmq, bounds } = this.#how;
    const controller = new AbortController();
    this.#running.set(job.id, controller);
    const { signal } = controller;
    try {
      if (await this.#marks.cancelled(job.id)) throw cancelled();
      const ends = job.data.ends + job.stalledCounter;
      if (isPoison(ends, bounds)) throw poisoned(ends);
      const task = await loadTask(this.#store, job.data.task);
      const told = this.#tellerOf(job);
      const result = await this.#work(task, { signal, ...told, onStart: () => {} });
      return await this.#keep(result, job, signal);
    } catch (thrown) {
      const verdict = verdictOf(thrown, { tries: job.attemptsMade + 1, ends: job.data.ends }, bounds);
      if (verdict.does === 'give back') {
        if (verdict.isLast) await this.#worker.pause(true);
        await job.moveToWait(token);
        throw new bullmq.WaitingError();
      }
      if (verdict.does === 'end') {
        const error = (await this.#marks.end(job.id, bounds.leaseMs)) ? verdict.error : cancelled();
        throw new bullmq.UnrecoverableError(JSON.stringify(error));
      }
      if (verdict.ends > job.data.ends) await job.updateData({ ...job.data, ends: verdict.ends });
      throw new Error(JSON.stringify(toTelarError(thrown)));
    } finally {
      this.#running.delete(job.id);
    }
  }

  /** BullMQ keeps it where this worker has the job still; otherwise its bytes go by themselves, later. */
  async #keep(result, job, signal) {
    const { bounds, hosts } = this.#how;
    const stored = await storeResult(this.#store, result, { ms: bounds.resultMs, put: job.data.put, signal, hosts });
    if (await this.#marks.end(job.id, bounds.leaseMs)) return stored;
    await this.#store.drop(refsOf(stored)).catch(() => {});
    throw cancelled();
  }

  /** Tells how far a job is, and shows its picture so far: whoever watches is told of the progress, and looks. */
  #tellerOf(job) {
    let [said, last] = [0, 0];
    const tell = (part) => {
      said = Date.now();
      return job.updateProgress(part).catch(() => {});
    };
    return {
      onProgress: (part) => {
        last = part;
        if (Date.now() - said >= PROGRESS_MS) void tell(part);
      },
      onPreview: showing(async ({ png, ...shown }) => {
        await this.#client.set(this.#how.previewOf(job.id), JSON.stringify({ ...shown, png: png.toString('base64') }), 'PX', this.#how.bounds.resultMs);
        await tell(last);
      }),
    };
  }

  async #look() {
    const ids = [...this.#running.keys()];
    if (ids.length === 0) return;
    for (const id of await this.#marks.cancelledOf(ids).catch(() => [])) this.#running.get(id)?.abort(cancelled());
  }

  idle() {
    this.#closing ??= this.#worker.close().finally(() => {
      clearInterval(this.#timer);
      this.#letGo();
    });
    return this.#closing;
  }

  abort(reason) {
    // What is given back is for another process.
    const ended = this.idle().catch(() => {});
    // What waits for a server that is away ends with its connection; another process takes the job when the lease is over.
    const late = setTimeout(() => this.#letGo(), CLOSE_MS);
    ended.finally(() => clearTimeout(late));
    for (const controller of this.#running.values()) controller.abort(reason);
  }
}
