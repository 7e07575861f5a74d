import { randomBytes } from 'node:crypto';
import { TelarError } from '../error/index.mjs';
import { showing } from './preview.mjs';
import { cancelled, verdictOf } from './verdict.mjs';

/** Milliseconds between two writings of how far a job is. */
const PROGRESS_MS = 250;
/** Signs of life within a lease. */
const RENEWALS = 3;

/** Jobs of an SqliteQueue that run in this process: each has a token, and a lease that is renewed while the process lives. */
export class SqliteRuns {
  #work;
  #how;
  #running = new Map();
  #isEnding = false;
  #timer;

  /**
   * @param {import('./job_queue.mjs').Work} work
   * @param {{atOnce: number, bounds: object, table: import('./sqlite_table.mjs').Table, load: (row: object) => Promise<object>,
   *   keep: (result: object, row: object, signal: AbortSignal) => Promise<void>, changed: (id: string) => void}} how
   */
  constructor(work, how) {
    this.#work = work;
    this.#how = how;
    this.#timer = setInterval(() => this.#renew(), how.bounds.leaseMs / RENEWALS).unref();
  }

  get #lease() {
    return Date.now() + this.#how.bounds.leaseMs;
  }

  /** Takes jobs while there is room. */
  next() {
    while (!this.#isEnding && this.#running.size < this.#how.atOnce) {
      const token = randomBytes(12).toString('hex');
      const row = this.#how.table.row('claim', { token, lease: this.#lease, now: Date.now() });
      if (!row) return;
      const run = { row, controller: new AbortController(), said: 0 };
      this.#running.set(token, run);
      run.working = this.#run(run)
        .catch(() => {}) // The database cannot be written to: the lease ends, and another process takes the job.
        .finally(() => {
          this.#running.delete(token);
          if (!this.#isEnding) this.next();
        })
        .catch(() => {});
      this.#how.changed(row.id);
    }
  }

  async #run({ row, controller: { signal }, ...run }) {
    const { table, load, keep, changed, bounds } = this.#how;
    const { id, token } = row;
    const onProgress = (progress) => {
      if (Date.now() - run.said < PROGRESS_MS) return;
      run.said = Date.now();
      try {
        if (table.change('progress', { id, token, progress })) changed(id);
      } catch {
        // The next one says more.
      }
    };
    const onPreview = showing((shown) => {
      if (table.change('show', { id, token, ...shown })) changed(id);
    });
    try {
      const result = await this.#work(await load(row), { signal, onProgress, onPreview, onStart: () => {} });
      await keep(result, row, signal);
    } catch (error) {
      const verdict = verdictOf(error, { tries: row.failures + 1, ends: row.ends }, bounds);
      const now = Date.now();
      this.#isEnding ||= verdict.isLast === true;
      if (verdict.does === 'give back') table.change('giveBack', { id, token });
      else if (verdict.does === 'retry') table.change('retry', { id, token, due: now + verdict.afterMs, ends: verdict.ends });
      else table.change('end', { id, token, now, state: verdict.state, error: JSON.stringify(verdict.error) });
      changed(id);
    }
  }

  #renew() {
    for (const [token, { row }] of this.#running) {
      try {
        if (!this.#how.table.change('renew', { id: row.id, token, lease: this.#lease })) this.check(row.id);
      } catch {
        // The next one, within the lease.
      }
    }
  }

  checkAll() {
    for (const { row } of this.#running.values()) this.check(row.id);
  }

  /** Ends the run of a job that was cancelled, or that another process has by now. */
  check(id) {
    for (const [token, { row, controller }] of this.#running) {
      if (row.id !== id || controller.signal.aborted) continue;
      const now = this.#how.table.row('get', { id });
      if (now?.token === token || now?.state === 'done') continue;
      controller.abort(now?.state === 'cancelled' ? cancelled() : new TelarError('X_SHUTDOWN', 'another worker has the job'));
    }
  }

  async idle() {
    this.#isEnding = true;
    await Promise.all([...this.#running.values()].map(({ working }) => working));
    clearInterval(this.#timer);
  }

  abort(reason) {
    this.#isEnding = true;
    for (const { controller } of this.#running.values()) controller.abort(reason);
  }
}
