import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

const FILE_BYTES = 64 * 2 ** 20;

/**
 * Limits from --limit NAME=N.
 * @param {string[]} [assignments]
 * @returns {Record<string, number>} by the L_* names; the API checks the names
 * @throws {TelarError} E_USAGE
 */
export function readLimits(assignments = []) {
  return Object.fromEntries(
    assignments.map((assignment) => {
      const match = /^(L_[A-Z_]+)=(\d{1,15})$/.exec(assignment);
      if (!match) throw new TelarError('E_USAGE', `--limit: expected NAME=N, as in L_TRIANGLES=30000000, got ${shown(assignment)}`);
      return [match[1], Number(match[2])];
    }),
  );
}

/**
 * Milliseconds from --timeout-ms; undefined where it is not given, null for "none".
 * @param {string} [text]
 * @returns {number | null | undefined} the API checks the range
 * @throws {TelarError} E_USAGE
 */
export function readTimeout(text) {
  if (text === undefined) return undefined;
  if (text === 'none') return null;
  if (!/^[1-9]\d{0,9}$/.test(text)) throw new TelarError('E_USAGE', `--timeout-ms: expected milliseconds or none, got ${shown(text)}`);
  return Number(text);
}

/** More processes than a machine has cores. */
const MOST_WORKERS = 1024;

/**
 * Processes that draw: undefined where the flag is not given, null for "auto".
 * @param {'--jobs' | '--workers'} flag
 * @param {string} [text]
 * @returns {number | null | undefined}
 * @throws {TelarError} E_USAGE
 */
export function readWorkers(flag, text) {
  if (text === undefined) return undefined;
  if (text === 'auto') return null;
  if (/^[1-9]\d{0,3}$/.test(text) && Number(text) <= MOST_WORKERS) return Number(text);
  throw new TelarError('E_USAGE', `${flag}: expected processes from 1 to ${MOST_WORKERS}, or auto, got ${shown(text)}`);
}

/** How much of stdin to take. */
export const maxFileBytes = (limits) => limits.L_FILE_BYTES ?? FILE_BYTES;
