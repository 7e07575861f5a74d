import { object, text } from '../shot/table/rows.mjs';
import { HOUR, MIB, milliseconds, whole } from './option_rows.mjs';

/** The options of a queue: what openQueue() takes, `telar serve` and `telar worker` have as flags, and js/docs/queue.md lists. */

/** How much waits and is kept: of the service too, for the queue in its own process. */
export const BOUNDS = {
  jobs: whole('Jobs (`prefer: respond-async`) that wait in the queue; one more is X_BUSY', { flag: '--jobs <n>', min: 0, max: 1_000_000, default: 256 }),
  jobBytes: whole('Bytes of the models of jobs that wait and run; more is X_BUSY', {
    flag: '--job-bytes <n>',
    unit: 'bytes',
    min: 1,
    max: 2 ** 40,
    default: 1024 * MIB,
  }),
  resultMs: milliseconds('Milliseconds for which the result of a job is kept', '--result-ms <ms>', { default: HOUR / 6 }),
  resultBytes: whole('Bytes of the results that are kept; the oldest go first', {
    flag: '--result-bytes <n>',
    unit: 'bytes',
    min: 1,
    max: 2 ** 40,
    default: 256 * MIB,
  }),
};

/** What is drawn once, of a service and of a worker. */
export const STORE = {
  storeBytes: whole('Bytes of a folder of results, from which those that were read longest ago go; at addresses, of one result', {
    flag: '--store-bytes <n>',
    unit: 'bytes',
    min: 1,
    max: 2 ** 44,
    default: 1024 * MIB,
  }),
};

/** Where the queue is. */
export const PLACES = {
  redis: {
    ...text('Address of a Redis or Valkey server, as in redis://127.0.0.1:6379', 'an address that begins with redis:// or rediss://', {
      max: 2048,
      optional: true,
    }),
    flag: '--redis <url>',
  },
  sqlite: {
    ...text('File of an SQLite database, made where there is none', 'a file', { max: 4096, optional: true }),
    flag: '--sqlite <file>',
  },
  folder: {
    ...text('Folder that all processes share, for the bytes of models and results in place of Redis', 'a folder', { max: 4096, optional: true }),
    flag: '--queue-folder <folder>',
  },
  name: {
    ...text('Name of the queue: several may be on one server', 'letters, digits, - and _', { max: 64, default: 'jobs' }),
    flag: '--queue-name <name>',
  },
};

/** How jobs are tried. */
export const TRIES = {
  taskBytes: whole('Bytes of the models of one job', { flag: '--task-bytes <n>', unit: 'bytes', min: 1, max: 2 ** 32, default: 128 * MIB }),
  waitMs: milliseconds('Milliseconds from the asking to the end of a job, tries included; then its model is no longer kept', '--wait-ms <ms>', {
    max: 30 * 24 * HOUR,
    default: 24 * HOUR,
  }),
  attempts: whole('Tries of a job whose error may pass', { flag: '--attempts <n>', min: 1, max: 100, default: 3 }),
  backoffMs: milliseconds('Milliseconds before the second try; before each later one four times as many', '--backoff-ms <ms>', { default: 1000 }),
  poison: whole('Workers that a job may end; then it fails with X_QUARANTINE', { flag: '--poison <n>', min: 1, max: 100, default: 3 }),
  quarantineMs: milliseconds('Milliseconds for which such a job is not run again', '--quarantine-ms <ms>', { default: 24 * HOUR }),
  leaseMs: milliseconds('Milliseconds without a sign of life after which the jobs of a worker go to another one', '--lease-ms <ms>', {
    min: 100,
    default: 30_000,
  }),
  tenantJobs: whole('Jobs that a tenant may add within `tenantMs`; one more is X_BUSY', { flag: '--tenant-jobs <n>', min: 1, max: 1_000_000, optional: true }),
  tenantMs: milliseconds('Milliseconds that `tenantJobs` counts', '--tenant-ms <ms>', { default: 60_000 }),
};

/** @type {Record<string, import('./option_rows.mjs').OptionRow>} */
export const OPTIONS = Object.freeze({ ...PLACES, ...BOUNDS, ...TRIES });

export const QUEUE_OPTIONS = object('Options', OPTIONS, { expected: 'an object' });
