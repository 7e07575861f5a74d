/**
 * Jobs that are asked for now and fetched later. One interface, three queues: MemoryQueue in this process, SqliteQueue in a file, RedisQueue on a
 * server. A job is asked for by its content (jobId() of pack.mjs): while it waits, runs or is done, asking again gives the same job. It may run more
 * than once, as its worker may end, and has one result.
 * @typedef {object} JobQueue
 * @property {(tenant?: string) => void | Promise<void>} check throws X_BUSY where one more job would be refused
 * @property {(task: Task, how?: {meta?: object, tenant?: string, priority?: number, put?: string[]}) => Promise<JobState>} add X_BUSY; meta: plain data, given
 *   back with the result; priority: 0 to 7, 0 first; put: addresses that take the files of the result by PUT
 * @property {(id: string) => Promise<JobState | undefined>} get
 * @property {(id: string) => Promise<{result: import('./perform.mjs').Result, meta: object} | undefined>} result of a job that is done
 * @property {(id: string) => Promise<JobState | undefined>} cancel
 * @property {(id: string, listener: (state: JobState, preview?: import('./preview.mjs').ShownPreview) => void) => () => void} watch tells of what
 *   changes, and shows pictures so far, by whichever process; the returned function ends it
 * @property {() => Counts | Promise<Counts>} counts
 * @property {(work: Work, how: {atOnce: number}) => void} take begins to run jobs in this process; once
 * @property {() => Promise<void>} idle takes no more jobs that another process could take, and resolves when none runs here
 * @property {(reason: TelarError) => void} abort ends what runs here: jobs of MemoryQueue fail, the others are given back
 * @property {() => Promise<void>} close
 * @property {{code: string, message: string}[]} warnings what is not as it should be where the queue is kept
 *
 * @typedef {{waiting: number, running: number, kept: number}} Counts
 * @typedef {import('../error/index.mjs').TelarError} TelarError
 *
 * @typedef {(task: Task, how: {signal: AbortSignal, onProgress: (part: number) => void,
 *   onPreview?: (preview: import('../index.js').Preview) => void, onStart: () => void}) => Promise<import('./perform.mjs').Result>} Work
 *
 * @typedef {object} Task what a request asks for: plain data and bytes
 * @property {string} kind of KINDS in perform.mjs
 * @property {Record<string, unknown>} asked
 * @property {Record<string, Uint8Array>} files
 *
 * @typedef {object} JobState
 * @property {string} id
 * @property {string} kind
 * @property {'waiting' | 'running' | 'done' | 'failed' | 'cancelled'} state
 * @property {number} progress 0..1
 * @property {number} created milliseconds since 1970
 * @property {number} [started] of the last try
 * @property {number} [ended]
 * @property {number} tries that were begun
 * @property {TelarError} [error] of a job that failed or was cancelled
 */

/** Steps of progress that listeners are told of. */
export const STEP = 0.01;

export const isOver = ({ state }) => state !== 'waiting' && state !== 'running';

/** Whether a job stays as it is where it is asked for again: another try of it would not end otherwise, or not better. */
export const isKept = (state) => !isOver(state) || state.state === 'done' || state.error?.code === 'X_QUARANTINE';
