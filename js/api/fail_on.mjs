import { TelarError } from '../error/index.mjs';

/**
 * Refuses warnings where the caller wants none.
 * @param {'error' | 'warning' | 'none'} failOn
 * @param {{code: string, message: string, pointer?: string}[]} [warnings]
 * @throws {TelarError} E_WARNING with the first of them
 */
export function refuseWarnings(failOn, warnings = []) {
  if (failOn !== 'warning' || warnings.length === 0) return;
  const [{ code, message, pointer }] = warnings;
  const more = warnings.length > 1 ? ` (and ${warnings.length - 1} more)` : '';
  throw new TelarError('E_WARNING', `${code}: ${message}${more}; with failOn "error" it is drawn`, { pointer });
}
