import { TelarError } from '../error/index.mjs';

/** Validators (RFC 9110, 8.8.3 and 13.1.2): the tag of a picture is its key, which is known before it is drawn. */

/** @param {string} key @param {string} type of the answer: one key has a picture, and JSON about it */
export const tagOf = (key, type) => `"${key}${type === 'application/json' ? '-json' : ''}"`;

/** Weak comparison, as the header asks for. */
function matches(ifNoneMatch, tag) {
  if (ifNoneMatch.trim() === '*') return false; // whether anything was drawn before is not known
  return ifNoneMatch.split(',').some((one) => one.trim().replace(/^W\//, '') === tag);
}

/**
 * Whether the client has the answer already.
 * @param {{method: string, headers: Record<string, string>}} request
 * @param {string} tag
 * @returns {boolean} true: answer 304
 * @throws {TelarError} E_PRECONDITION of a method that has no 304
 */
export function isUnchanged({ method, headers }, tag) {
  const given = headers['if-none-match'];
  if (given === undefined || !matches(given, tag)) return false;
  if (method === 'GET' || method === 'HEAD') return true;
  throw new TelarError('E_PRECONDITION', 'the answer would be the one that if-none-match names');
}
