import { TelarError, fromNative } from '../error/index.mjs';
import { FolderStore } from './folder_store.mjs';
import { isKept, isOver } from './job_queue.mjs';
import { readAdding } from './options.mjs';
import { jobId, packTask } from './pack.mjs';
import { bytesOfResult, loadResult, loadTask, refsOf, storeResult, storeTask } from './stored.mjs';
import { SqliteRuns } from './sqlite_runs.mjs';
import { Table } from './sqlite_table.mjs';
import { busy, cancelled, isPoison, poisoned, tooLarge, tooManyWait, tooOften } from './verdict.mjs';

/** Milliseconds between two looks at what other processes did. */
const LOOK_MS = 100;
/** Milliseconds between two looks at what is too old. */
const SWEEP_MS = 60_000;

const parsed = (text) => (text === null ? undefined : JSON.parse(text));

export function stateOf({ id, kind, state, progress, created, started, ended, tries, error }) {
  const told = error && fromNative(JSON.parse(error));
  return { id, kind, state, progress, created, ...(started && { started }), ...(ended && { ended }), tries, ...(told && { error: told }) };
}

/**
 * Jobs in an SQLite database, their bytes in a folder beside it. Processes of one machine share it.
 * @implements {import('./job_queue.mjs').JobQueue}
 */
export class SqliteQueue {
  warnings = [];
  #bounds;
  #table;
  #store;
  #runs;
  #listeners = new Map();
  #version;
  #timer;
  #swept = 0;

  /**
   * @param {object} bounds of readQueueOptions()
   * @throws {TelarError} X_QUEUE, X_LIBRARY_MISSING
   */
  static async open(bounds) {
    return new SqliteQueue(bounds, await Table.open(bounds.sqlite), await FolderStore.open(`${bounds.sqlite}-bytes`));
  }

  constructor(bounds, table, store) {
    this.#bounds = bounds;
    this.#table = table;
    this.#store = store;
    this.#timer = setInterval(() => this.#look(), LOOK_MS);
  }

  check(tenant = '') {
    const { waiting } = this.counts();
    if (waiting >= this.#bounds.jobs) throw tooManyWait(waiting);
    const { tenantJobs, tenantMs } = this.#bounds;
    if (tenantJobs === undefined) return;
    const { count = 0 } = this.#table.row('added', { tenant, span: Math.floor(Date.now() / tenantMs) }) ?? {};
    if (count >= tenantJobs) throw tooOften(this.#bounds);
  }

  async add(task, how) {
    const { meta, tenant, priority, put } = readAdding(how);
    const packed = packTask(task);
    if (packed.bytes > this.#bounds.taskBytes) throw tooLarge(packed.bytes, this.#bounds);
    const id = await jobId(packed, { meta, tenant, put });
    const known = this.#kept(id);
    if (known) return known;
    this.check(tenant);
    const stored = await storeTask(this.#store, packed, this.#bounds.waitMs);
    let added = false;
    try {
      return this.#table.transaction(() => {
        const meanwhile = this.#kept(id);
        if (meanwhile) return meanwhile;
        this.#checkRoom(tenant, packed.bytes);
        this.#remove(this.#table.row('get', { id }));
        const [text, said] = [JSON.stringify(stored), JSON.stringify(meta)];
        const values = { id, kind: task.kind, priority, now: Date.now(), bytes: packed.bytes, task: text, meta: said, put: put ? JSON.stringify(put) : null };
        this.#table.change('add', values);
        added = true;
        return stateOf(this.#table.row('get', { id }));
      });
    } catch (error) {
      added = false;
      throw error;
    } finally {
      if (!added) await this.#store.drop(refsOf(stored));
      this.#look();
    }
  }

  #checkRoom(tenant, bytes) {
    this.check(tenant);
    const { bytes: taken } = this.#table.row('taskBytes');
    if (taken > 0 && taken + bytes > this.#bounds.jobBytes) throw busy('the files of the jobs that wait take all the room that they may');
    const { tenantJobs, tenantMs } = this.#bounds;
    if (tenantJobs !== undefined) this.#table.change('countAdded', { tenant, span: Math.floor(Date.now() / tenantMs) });
  }

  #ageOf(error) {
    return error && JSON.parse(error).code === 'X_QUARANTINE' ? this.#bounds.quarantineMs : this.#bounds.resultMs;
  }

  /** The row, unless its time is over. */
  #row(id) {
    const row = this.#table.row('get', { id });
    return row && !(row.ended && Date.now() - row.ended >= this.#ageOf(row.error)) ? row : undefined;
  }

  #kept(id) {
    const row = this.#row(id);
    return row && isKept(stateOf(row)) ? stateOf(row) : undefined;
  }

  async get(id) {
    const row = this.#row(id);
    return row && stateOf(row);
  }

  async result(id) {
    const row = this.#row(id);
    if (row?.state !== 'done') return undefined;
    const result = await loadResult(this.#store, parsed(row.result));
    return result && { result, meta: parsed(row.meta) };
  }

  async cancel(id) {
    if (this.#table.change('cancel', { id, now: Date.now(), error: JSON.stringify(cancelled()) })) this.#over(id);
    return this.get(id);
  }

  watch(id, listener) {
    const entry = this.#listeners.get(id) ?? { told: undefined, all: new Set() };
    this.#listeners.set(id, entry);
    entry.all.add(listener);
    // It may have changed since its watcher asked last.
    setImmediate(() => this.#tellAll([id]));
    return () => {
      entry.all.delete(listener);
      if (entry.all.size === 0 && this.#listeners.get(id) === entry) this.#listeners.delete(id);
    };
  }

  counts() {
    const { waiting, running, jobs } = this.#table.row('counts');
    return { waiting: waiting ?? 0, running: running ?? 0, kept: jobs - (waiting ?? 0) - (running ?? 0) };
  }

  take(work, { atOnce, hosts }) {
    this.#runs = new SqliteRuns(work, {
      atOnce,
      bounds: this.#bounds,
      table: this.#table,
      load: (row) => loadTask(this.#store, parsed(row.task)),
      keep: (result, row, signal) => this.#keep(result, row, { signal, hosts }),
      changed: (id) => this.#changed(id),
    });
    this.#look();
  }

  /** The result is there for all in one step: its bytes before, and its bytes alone where another worker was quicker. */
  async #keep(result, { id, token, put }, { signal, hosts }) {
    const stored = await storeResult(this.#store, result, { ms: this.#bounds.resultMs, put: parsed(put), signal, hosts });
    const values = { id, token, now: Date.now(), result: JSON.stringify(stored), bytes: bytesOfResult(stored) };
    if (!this.#table.change('done', values)) await this.#store.drop(refsOf(stored));
    else this.#over(id);
  }

  async idle() {
    await this.#runs?.idle();
  }

  abort(reason) {
    this.#runs?.abort(reason);
  }

  async close() {
    clearInterval(this.#timer);
    this.abort(new TelarError('X_SHUTDOWN', 'the queue was closed'));
    await this.idle();
    this.#table.close();
  }

  /** A job has changed by this process. */
  #changed(id) {
    const row = this.#table.row('get', { id });
    if (row?.ended) return this.#over(id);
    this.#runs?.check(id);
    this.#tell(id);
  }

  #over(id) {
    this.#table.change('hide', { id });
    this.#drop(refsOf(parsed(this.#table.row('get', { id }).task)));
    this.#runs?.check(id);
    this.#tell(id);
    if (this.#table.row('resultBytes').bytes > this.#bounds.resultBytes) this.#forget();
  }

  #drop(refs) {
    // What cannot be removed now is swept later.
    this.#store.drop(refs).catch(() => {});
  }

  #tell(id) {
    const entry = this.#listeners.get(id);
    if (!entry) return;
    const row = this.#table.row('get', { id });
    if (!row) return;
    const text = JSON.stringify(stateOf(row));
    if (text !== entry.told) for (const listener of entry.all) listener(stateOf(row));
    entry.told = text;
    if (isOver(row)) this.#listeners.delete(id);
    else if (row.state === 'running') this.#show(row, entry);
  }

  /** The picture so far, where it is another one than before. */
  #show(row, entry) {
    const shown = this.#table.row('preview', { id: row.id });
    if (!shown || shown.samples === entry.samples) return;
    entry.samples = shown.samples;
    const { samples, width, height, png } = shown;
    for (const listener of entry.all) listener(stateOf(row), { samples, width, height, png: Buffer.from(png) });
  }

  #tellAll(ids) {
    try {
      for (const id of ids) this.#tell(id);
    } catch {
      // The database cannot be read now; the next look tells.
      this.#version = undefined;
    }
  }

  /** What other processes did, and what of theirs has ended. */
  #look() {
    try {
      const now = Date.now();
      const { data_version: version } = this.#table.row('version');
      if (version !== this.#version) {
        this.#version = version;
        this.#tellAll(this.#listeners.keys());
        this.#runs?.checkAll();
      }
      if (this.#runs) for (const row of this.#table.rows('stalled', { now })) this.#recover(row);
      this.#runs?.next();
      if (now - this.#swept < SWEEP_MS) return;
      this.#swept = now;
      this.#table.change('forgetShown');
      this.#table.change('forgetAdded', { span: Math.floor(now / this.#bounds.tenantMs) });
      this.#forget();
      this.#store.sweep(Math.max(this.#bounds.waitMs, this.#bounds.resultMs)).catch(() => {});
    } catch {
      // The next look tries again; whoever calls is told.
    }
  }

  /** Its worker gave no sign of life for so long as its lease is. */
  #recover({ id, token, ends: before }) {
    const ends = before + 1;
    if (isPoison(ends, this.#bounds)) this.#table.change('end', { id, token, now: Date.now(), state: 'failed', error: JSON.stringify(poisoned(ends)) });
    else this.#table.change('recover', { id, token, ends });
    this.#changed(id);
  }

  #remove(row) {
    if (!row) return;
    this.#table.change('remove', { id: row.id });
    this.#drop([...refsOf(parsed(row.task)), ...refsOf(parsed(row.result))]);
  }

  /** Results that are old, or more than may be kept, go: the oldest first, and never the last. */
  #forget() {
    let bytes = 0;
    for (const [i, row] of this.#table.rows('over').entries()) {
      bytes += row.resultBytes;
      if ((i > 0 && bytes > this.#bounds.resultBytes) || Date.now() - row.ended >= this.#ageOf(row.error)) this.#remove(row);
    }
  }
}
