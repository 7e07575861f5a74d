import { TelarError } from '../error/index.mjs';

/** The database of SqliteQueue: one table of jobs, one of their pictures so far, one of how many each tenant added. */

/** What the tables look like: an older database gets what it lacks, one of a later telar is refused. */
const SHAPE = 2;

const SCHEMA = `
CREATE TABLE IF NOT EXISTS jobs (
  id TEXT PRIMARY KEY, kind TEXT NOT NULL, state TEXT NOT NULL, progress REAL NOT NULL DEFAULT 0, priority INTEGER NOT NULL, place INTEGER NOT NULL,
  created INTEGER NOT NULL, started INTEGER, ended INTEGER, due INTEGER NOT NULL, tries INTEGER NOT NULL DEFAULT 0, failures INTEGER NOT NULL DEFAULT 0,
  ends INTEGER NOT NULL DEFAULT 0, token TEXT, lease INTEGER, bytes INTEGER NOT NULL, task TEXT NOT NULL, meta TEXT NOT NULL, put TEXT, error TEXT,
  result TEXT, resultBytes INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX IF NOT EXISTS jobs_next ON jobs (state, priority, place);
CREATE INDEX IF NOT EXISTS jobs_ended ON jobs (ended, resultBytes);
CREATE TABLE IF NOT EXISTS previews (id TEXT PRIMARY KEY, samples INTEGER NOT NULL, width INTEGER NOT NULL, height INTEGER NOT NULL, png BLOB NOT NULL) STRICT;
CREATE TABLE IF NOT EXISTS added (tenant TEXT PRIMARY KEY, span INTEGER NOT NULL, count INTEGER NOT NULL) STRICT;
PRAGMA user_version = ${SHAPE};
`;

/** What each process has of its jobs, it may change while it has their token. */
const OWN = "WHERE id = :id AND token = :token AND state = 'running'";

const STATEMENTS = {
  get: 'SELECT * FROM jobs WHERE id = :id',
  counts: "SELECT sum(state = 'waiting') AS waiting, sum(state = 'running') AS running, count(*) AS jobs FROM jobs",
  taskBytes: "SELECT coalesce(sum(bytes), 0) AS bytes FROM jobs WHERE state IN ('waiting', 'running')",
  add: `INSERT INTO jobs (id, kind, state, priority, place, created, due, bytes, task, meta, put)
        VALUES (:id, :kind, 'waiting', :priority, (SELECT coalesce(max(place), 0) + 1 FROM jobs), :now, :now, :bytes, :task, :meta, :put)`,
  remove: 'DELETE FROM jobs WHERE id = :id',
  claim: `UPDATE jobs SET state = 'running', token = :token, lease = :lease, started = :now, progress = 0, tries = tries + 1
          WHERE id = (SELECT id FROM jobs WHERE state = 'waiting' AND due <= :now ORDER BY priority, place LIMIT 1) RETURNING *`,
  renew: `UPDATE jobs SET lease = :lease ${OWN}`,
  progress: `UPDATE jobs SET progress = :progress ${OWN}`,
  preview: 'SELECT samples, width, height, png FROM previews WHERE id = :id',
  show: `INSERT OR REPLACE INTO previews SELECT :id, :samples, :width, :height, :png WHERE EXISTS (SELECT 1 FROM jobs ${OWN})`,
  hide: 'DELETE FROM previews WHERE id = :id',
  forgetShown: "DELETE FROM previews WHERE id NOT IN (SELECT id FROM jobs WHERE state = 'running')",
  done: `UPDATE jobs SET state = 'done', progress = 1, ended = :now, token = NULL, result = :result, resultBytes = :bytes ${OWN}`,
  end: `UPDATE jobs SET state = :state, ended = :now, token = NULL, error = :error ${OWN}`,
  retry: `UPDATE jobs SET state = 'waiting', progress = 0, token = NULL, due = :due, failures = failures + 1, ends = :ends ${OWN}`,
  giveBack: `UPDATE jobs SET state = 'waiting', progress = 0, token = NULL, tries = tries - 1 ${OWN}`,
  stalled: "SELECT * FROM jobs WHERE state = 'running' AND lease < :now",
  recover: `UPDATE jobs SET state = 'waiting', progress = 0, token = NULL, ends = :ends ${OWN}`,
  cancel: "UPDATE jobs SET state = 'cancelled', ended = :now, token = NULL, error = :error WHERE id = :id AND state IN ('waiting', 'running')",
  resultBytes: 'SELECT coalesce(sum(resultBytes), 0) AS bytes FROM jobs WHERE ended IS NOT NULL',
  over: 'SELECT id, task, result, error, ended, resultBytes FROM jobs WHERE ended IS NOT NULL ORDER BY ended DESC',
  added: 'SELECT count FROM added WHERE tenant = :tenant AND span = :span',
  countAdded: `INSERT INTO added VALUES (:tenant, :span, 1)
               ON CONFLICT (tenant) DO UPDATE SET count = iif(span = :span, count + 1, 1), span = :span`,
  forgetAdded: 'DELETE FROM added WHERE span < :span',
  version: 'PRAGMA data_version',
};

/** What Node 22.13 and later has built in; Node 20 takes the same API from a package that npm installs without a compiler. */
async function driver() {
  const built = await import('node:sqlite').catch(() => undefined);
  if (built) return built;
  try {
    return await import('@photostructure/sqlite');
  } catch (cause) {
    throw new TelarError('X_LIBRARY_MISSING', 'this Node has no SQLite: npm install @photostructure/sqlite, or use Node 22.13 or later', { cause });
  }
}

export const wrong = (cause) => (cause instanceof TelarError ? cause : new TelarError('X_QUEUE', `the database of the queue: ${cause.message}`, { cause }));

/** Calls of the statements by name, and transactions. */
export class Table {
  #db;
  #statements;

  /**
   * @param {string} file made where there is none
   * @throws {TelarError} X_QUEUE, X_LIBRARY_MISSING
   */
  static async open(file) {
    const { DatabaseSync } = await driver();
    try {
      return new Table(new DatabaseSync(file));
    } catch (cause) {
      throw wrong(cause);
    }
  }

  constructor(db) {
    this.#db = db;
    // FULL: what was told to be added survives a power cut too.
    db.exec('PRAGMA busy_timeout = 10000; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL');
    const { user_version: shape } = db.prepare('PRAGMA user_version').get();
    if (shape > SHAPE) throw new TelarError('X_QUEUE', 'the database of the queue is of another version of telar: name another file');
    if (shape < SHAPE) this.#within('IMMEDIATE', () => db.exec(SCHEMA));
    this.#statements = Object.fromEntries(Object.entries(STATEMENTS).map(([name, text]) => [name, db.prepare(text)]));
  }

  #within(kind, use) {
    this.#db.exec(`BEGIN ${kind}`);
    try {
      const value = use();
      this.#db.exec('COMMIT');
      return value;
    } catch (error) {
      try {
        this.#db.exec('ROLLBACK');
      } catch {
        // On a full disk SQLite has taken it back by itself.
      }
      throw error;
    }
  }

  /** @throws {TelarError} X_QUEUE, and what it throws */
  transaction(use) {
    try {
      return this.#within('IMMEDIATE', use);
    } catch (error) {
      throw wrong(error);
    }
  }

  /** @returns {Record<string, any> | undefined} the first row */
  row(name, values = {}) {
    try {
      return this.#statements[name].get(values);
    } catch (error) {
      throw wrong(error);
    }
  }

  rows(name, values = {}) {
    try {
      return this.#statements[name].all(values);
    } catch (error) {
      throw wrong(error);
    }
  }

  /** @returns {boolean} whether a row was changed */
  change(name, values = {}) {
    try {
      return Number(this.#statements[name].run(values).changes) > 0;
    } catch (error) {
      throw wrong(error);
    }
  }

  close() {
    this.#db.close();
  }
}
