import { ERRORS, TelarError, toTelarError } from '../error/index.mjs';

/** Errors as problem+json (RFC 9457), from the one table of errors. */

/** Of these kinds a client is told the meaning alone: their messages are for whoever runs the service, and may name its folders. */
const OURS = ['internal', 'machine'];
/** Machine errors whose messages are made for clients. */
const TOLD = ['X_SOURCE', 'X_WORKERS', 'X_LIBRARY_MISSING'];

/** By status of what HTTP itself finds wrong. */
const CODES = { 404: 'E_NOT_FOUND', 405: 'E_METHOD', 408: 'X_UPLOAD_TIME', 413: 'L_REQUEST_BYTES', 415: 'E_MEDIA_TYPE' };

const isRefused = (status) => status >= 400 && status < 500;

/** Whether a request was refused for a reason that this service has not: who asks (401, 403), or how often (429). */
export const isOwners = (thrown) =>
  !(thrown instanceof TelarError) && isRefused(thrown?.statusCode) && !(thrown.statusCode in CODES) && thrown.statusCode !== 400;

/** @param {unknown} thrown @returns {TelarError} */
export function errorOf(thrown) {
  if (thrown instanceof TelarError) return thrown;
  const status = thrown?.statusCode;
  if (!isRefused(status)) return toTelarError(thrown);
  return new TelarError(CODES[status] ?? 'E_REQUEST', ERRORS[CODES[status] ?? 'E_REQUEST'].meaning, { cause: thrown });
}

/**
 * @param {TelarError} error
 * @param {{prefix?: string, id?: string}} [about] where the routes begin; id of the request, by which its line of the log is found
 * @returns {object} plain data
 */
export function problemOf(error, { prefix = '', id } = {}) {
  const { meaning } = ERRORS[error.code];
  const isOurs = OURS.includes(error.kind) && !TOLD.includes(error.code);
  const message = isOurs ? `${meaning}${id ? `; the log of the service says more, under ${id}` : ''}` : error.message;
  return {
    type: `${prefix}/v1/errors/${error.code}`,
    title: meaning,
    status: error.http,
    detail: message,
    ...(id && { instance: id }),
    ...error.toJSON(),
    message,
  };
}
