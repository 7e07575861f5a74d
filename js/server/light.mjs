import { TelarError } from '../error/index.mjs';
import { isObject } from '../api/option_check.mjs';
import { shown } from '../shot/complain.mjs';
import { ENVIRONMENTS, isNamedEnvironment } from '../shot/table/environments.mjs';

/** What of a shot a stranger may not say: files of the server. */

const withMap = (shot, map) => ({ ...shot, environment: { ...(isObject(shot.environment) && shot.environment), map } });

/**
 * The shot with the bytes of its environment: a file of the request, or one that the owner has named. A path is nothing that a request may name.
 * @param {object} shot not resolved
 * @param {{environments: Record<string, Uint8Array>, file?: Uint8Array}} given
 * @throws {TelarError} E_SHOT
 */
export function ownLight(shot, { environments, file }) {
  if (file) return withMap(shot, file);
  const named = isObject(shot.environment) ? shot.environment.map : shot.environment;
  if (typeof named !== 'string' || isNamedEnvironment(named)) return shot;
  if (Object.hasOwn(environments, named)) return withMap(shot, environments[named]);
  const names = [...Object.keys(ENVIRONMENTS), ...Object.keys(environments)].map((name) => JSON.stringify(name)).join(', ');
  throw new TelarError('E_SHOT', `shot.environment: expected ${names} or a file of the request, got ${shown(named)}`, { pointer: '/environment' });
}
