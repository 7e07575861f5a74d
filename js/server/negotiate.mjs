import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** Which type of answer a request gets (RFC 9110, 12.5.1). */

const RANGE = /^([\w!#$%&'*+.^`|~-]+)\/([\w!#$%&'*+.^`|~-]+)$/;
/** More ranges than a browser names. */
const MOST = 64;

/** @returns {{type: string, subtype: string, q: number}[]} what is no media range is left out */
function rangesOf(accept) {
  return accept
    .split(',', MOST)
    .map((part) => {
      const [range, ...parameters] = part.split(';').map((text) => text.trim().toLowerCase());
      const [, type, subtype] = RANGE.exec(range) ?? [];
      const q = Number(parameters.find((parameter) => parameter.startsWith('q='))?.slice(2) ?? 1);
      return { type, subtype, q: q >= 0 && q <= 1 ? q : 0 };
    })
    .filter(({ type }) => type !== undefined);
}

/** How precisely a range names the type: 2 = itself, 1 = type/*, 0 = any; -1 = not at all. */
function precision(range, [type, subtype]) {
  if (range.type === type && range.subtype === subtype) return 2;
  if (range.type === type && range.subtype === '*') return 1;
  return range.type === '*' && range.subtype === '*' ? 0 : -1;
}

/** Weight of a type: that of the range which names it most precisely. */
function weightOf(mediaType, ranges) {
  const names = mediaType.split('/');
  const [best] = ranges
    .map((range) => ({ q: range.q, precision: precision(range, names) }))
    .filter((found) => found.precision >= 0)
    .sort((a, b) => b.precision - a.precision);
  return best ?? { q: 0, precision: -1 };
}

/**
 * The type that the client likes best; of equals the one that it names more precisely, then the first that is offered.
 * @param {string | undefined} accept the header; without one the first is taken
 * @param {string[]} offered media types
 * @throws {TelarError} E_ACCEPT
 */
export function negotiate(accept, offered) {
  if (accept === undefined || accept.trim() === '') return offered[0];
  const ranges = rangesOf(accept);
  const weighed = offered.map((type, at) => ({ type, at, ...weightOf(type, ranges) })).filter(({ q }) => q > 0);
  weighed.sort((a, b) => b.q - a.q || b.precision - a.precision || a.at - b.at);
  if (weighed.length === 0) throw new TelarError('E_ACCEPT', `the answer can be ${offered.join(', ')}; the header accept is ${shown(accept)}`);
  return weighed[0].type;
}
