import type { TelarError } from '../error/index.js';
import type { Pool } from '../pool/index.js';
import type { QueueSettings } from './options.js';

export { TelarError } from '../error/index.js';
export type { QueueSettings };

/** Options of openQueue: `redis` or `sqlite` says where jobs are kept; without either they are in this process, and end with it. */
export type QueueOptions = QueueSettings;

/** What is to be drawn: keys and files as the routes of js/docs/server.md have them. */
export interface Task {
  kind: 'thumbnail' | 'inspect' | 'sheet' | 'compare';
  /** The keys of the route: `shot`, `failOn`, `spec`, `gate`, ... */
  asked: Record<string, unknown>;
  /** `model`, or `expected` and `actual`; files beside a model by "part NAME", images and fonts of a sheet by "image NAME" and "font NAME". */
  files: Record<string, Uint8Array>;
}

/** What is said with a job. */
export interface AddOptions {
  /**
   * Plain data that comes back with the result.
   * @default {}
   */
  meta?: Record<string, unknown>;
  /**
   * On whose behalf; `tenantJobs` counts for each, and jobs of two are never the same.
   * @default ''
   */
  tenant?: string;
  /**
   * 0 to 7, 0 first (RFC 9218).
   * @default 3
   */
  priority?: number;
  /**
   * Addresses that take the files of the result by PUT, in their order, as presigned ones of S3 do. The queue then keeps no bytes of the result.
   * @default undefined
   */
  put?: string[];
}

/** A job as it is now. */
export interface JobState {
  /** SHA-256 of the task, what is said with it and telar's version, 64 hex digits. */
  id: string;
  kind: Task['kind'];
  state: 'waiting' | 'running' | 'done' | 'failed' | 'cancelled';
  /** 0..1 */
  progress: number;
  /** Milliseconds since 1970, as the other times. */
  created: number;
  /** Of the last try. */
  started?: number;
  ended?: number;
  /** Tries that were begun. */
  tries: number;
  /** Of a job that failed or was cancelled. */
  error?: TelarError;
}

/** A file of a result: its bytes, or where they were sent. */
export interface ResultFile {
  name: string;
  type: string;
  data?: Uint8Array;
  /** Length of what was sent to `url`, which lacks its signature. */
  bytes?: number;
  url?: string;
}

export interface JobResult {
  result: { key?: string; info: any; files: ResultFile[] };
  meta: Record<string, unknown>;
}

/** The picture of a job as far as it is, of qualities that take many samples. */
export interface JobPreview {
  /** Of the picture itself, in pixels. */
  width: number;
  height: number;
  /** That a pixel has taken so far, at most. */
  samples: number;
  /** The picture so far, shrunk to a side of at most 192 pixels. */
  png: Uint8Array;
}

/** Jobs that are asked for now and fetched later. js/docs/queue.md says what is promised. */
export interface Queue {
  /** What is not as it should be where jobs are kept: W_QUEUE. */
  readonly warnings: Array<{ code: string; message: string }>;
  /**
   * Whether one more job would be taken.
   * @throws {TelarError} X_BUSY where one more job of this tenant would be refused, X_QUEUE
   * @example
   * await queue.check('shop-12');
   */
  check(tenant?: string): void | Promise<void>;
  /**
   * Asks for a job. One that waits, runs or is done already is the same job.
   * @throws {TelarError} E_OPTION, L_REQUEST_BYTES, X_BUSY, X_QUEUE
   * @example
   * const task: Task = { kind: 'thumbnail', asked: { shot: { camera: { view: 'back' } } }, files: { model: bytes } };
   * const { id, state } = await queue.add(task, { tenant: 'shop-12', priority: 1, meta: { sku: 'A-17' } });
   */
  add(task: Task, options?: AddOptions): Promise<JobState>;
  /**
   * The state of a job; undefined where there is no such job, or it is no longer kept.
   * @example
   * const job = await queue.get(id);
   * if (job?.state === 'failed') console.error(job.error?.message);
   */
  get(id: string): Promise<JobState | undefined>;
  /**
   * The result of a job; undefined where the job is not done.
   * @example
   * const done = await queue.result(id);
   * const [file] = done?.result.files ?? [];
   * if (file?.data) await writeFile(file.name, file.data);
   */
  result(id: string): Promise<JobResult | undefined>;
  /**
   * A job that waits does not run, one that runs is stopped; the state afterwards.
   * @example
   * console.log((await queue.cancel(id))?.state);
   */
  cancel(id: string): Promise<JobState | undefined>;
  /**
   * Tells what changes, and shows pictures so far, by whichever process, until the job is over; the returned function ends it.
   * @example
   * const stop = queue.watch(id, ({ progress }, preview) => console.log(progress, preview?.samples));
   */
  watch(id: string, listener: (state: JobState, preview?: JobPreview) => void): () => void;
  /**
   * Jobs of all tenants.
   * @example
   * const { waiting, running, kept } = await queue.counts();
   */
  counts(): { waiting: number; running: number; kept: number } | Promise<{ waiting: number; running: number; kept: number }>;
  /**
   * Ends what this process runs for the queue, and lets go of where it is kept.
   * @example
   * await queue.close();
   */
  close(): Promise<void>;
}

/**
 * Opens a queue.
 * @throws {TelarError} E_OPTION, X_QUEUE, X_LIBRARY_MISSING
 * @example
 * const queue = await openQueue({ redis: process.env.REDIS_URL });
 * const { id } = await queue.add({ kind: 'thumbnail', asked: { shot: { size: { width: 512, height: 512 } } }, files: { model: bytes } });
 * const stop = queue.watch(id, ({ state, progress }) => console.log(state, progress));
 */
export function openQueue(options?: QueueOptions): Promise<Queue>;

/** Where a result is, as presigned addresses of S3 say it. */
export type ResultAddress = string | URL | { url: string | URL; headers?: Record<string, string> };

/** Gives the address of a result by its name: letters, digits and dashes, at most 80. Null: it is not kept there. */
export interface ResultAddresses {
  /** Asked with GET; 404 and 403 mean that there is none. */
  get?: (name: string) => ResultAddress | null | undefined | Promise<ResultAddress | null | undefined>;
  /** Written with PUT and the type application/octet-stream. */
  put?: (name: string) => ResultAddress | null | undefined | Promise<ResultAddress | null | undefined>;
}

export interface WorkerOptions {
  /** Draws; its owner closes it, after drain(). */
  pool: Pool;
  /**
   * Jobs at once.
   * @default the workers of the pool
   */
  atOnce?: number;
  /**
   * Milliseconds that a job may work.
   * @default 600000
   */
  jobMs?: number;
  /**
   * Milliseconds that a picture of it may take.
   * @default jobMs
   */
  timeoutMs?: number;
  /**
   * Folders of own templates of sheets, by name.
   * @default undefined
   */
  templates?: Record<string, string>;
  /**
   * Hosts, as host or host:port, that `put` of a job may name.
   * @default undefined: any
   */
  putHosts?: string[];
  /**
   * Where pictures are kept by their content keys, so that none is drawn twice: a folder, which services and workers may share, or callbacks that
   * give addresses, as `store` of the service. A store that fails costs time, and no job.
   * @default undefined
   */
  store?: string | ResultAddresses;
  /**
   * Bytes of that folder, from which those that were read longest ago go; at addresses, of one result.
   * @default 1073741824
   */
  storeBytes?: number;
}

export interface Worker {
  /** Resolves when jobs are taken; rejects with E_OPTION where the folder of `store` cannot be made. */
  readonly ready: Promise<void>;
  /**
   * Takes no more jobs, finishes those that run, and gives back those that take longer than `ms`; a queue in this process is emptied first.
   * @example
   * await worker.drain(25_000);
   */
  drain(ms: number): Promise<void>;
}

/**
 * Draws the jobs of a queue in this process, as `telar worker` does; once for each queue.
 * @throws {TelarError} E_OPTION
 * @example
 * const pool = await createPool();
 * const worker = startWorker(queue, { pool });
 * process.once('SIGTERM', async () => {
 *   await worker.drain(25_000);
 *   await queue.close();
 *   await pool.close();
 * });
 */
export function startWorker(queue: Queue, options: WorkerOptions): Worker;
