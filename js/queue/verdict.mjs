import { TelarError, toTelarError } from '../error/index.mjs';

/** What becomes of a job whose try did not succeed: the same for every queue. isLast: this process can draw no other job either. */

const GROWTH = 4;
/** Kinds of errors that are tried once more alone. */
const SCARCE = ['time', 'memory'];

/** Milliseconds before the next try. @param {number} tries that were made */
export const backoffOf = (tries, { backoffMs }) => backoffMs * GROWTH ** (tries - 1);

/** @param {number} ends workers that the job ended */
export const isPoison = (ends, { poison }) => ends >= poison;

export const poisoned = (ends, input) =>
  new TelarError('X_QUARANTINE', `the job ended ${ends} worker${ends === 1 ? '' : 's'}, and is not run again; report it`, input === undefined ? {} : { input });

/**
 * @param {unknown} thrown by the work
 * @param {{tries: number, ends: number}} job tries: with this one; ends: workers that it ended before
 * @param {{attempts: number, backoffMs: number, poison: number}} bounds
 * @returns {{does: 'give back', isLast: boolean} | {does: 'retry', afterMs: number, ends: number} | {does: 'end', state: 'failed' | 'cancelled', error: TelarError}}
 */
export function verdictOf(thrown, { tries, ends }, bounds) {
  const error = toTelarError(thrown);
  // The pool of this process is closed, or its process ends: another one draws the job.
  if (error.code === 'X_SHUTDOWN' || error.code === 'X_CLOSED') return { does: 'give back', isLast: error.code === 'X_CLOSED' };
  if (error.code === 'X_CANCELLED') return { does: 'end', state: 'cancelled', error };
  const now = ends + (error.code === 'X_CRASH' ? 1 : 0);
  if (now > ends && isPoison(now, bounds)) return { does: 'end', state: 'failed', error: poisoned(now, error.input) };
  // What took too long or too much once may have met a busy machine; twice is enough.
  const attempts = SCARCE.includes(error.kind) ? Math.min(2, bounds.attempts) : bounds.attempts;
  if (error.retryable && tries < attempts) return { does: 'retry', afterMs: backoffOf(tries, bounds), ends: now };
  return { does: 'end', state: 'failed', error };
}

export const cancelled = () => new TelarError('X_CANCELLED', 'the job was cancelled');

/** @param {string} of what is full */
export const busy = (text) => new TelarError('X_BUSY', `${text}; try again later`);

export const tooManyWait = (waiting) => busy(`${waiting} jobs wait in the queue of this service, as many as may`);

export const tooOften = ({ tenantJobs, tenantMs }) => busy(`${tenantJobs} jobs were added within ${tenantMs} ms, as many as a tenant may`);

export const tooLarge = (bytes, { taskBytes }) =>
  new TelarError('L_REQUEST_BYTES', `the files of the job have ${bytes} bytes, more than the ${taskBytes} that this queue takes`, {
    limit: { name: 'L_REQUEST_BYTES', max: taskBytes, actual: bytes },
  });

export const lost = (what, cause) => new TelarError('X_QUEUE', `${what} of the job ${/s$/.test(what) ? 'are' : 'is'} not there any more`, { cause });
