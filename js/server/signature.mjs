import { createHmac, timingSafeEqual } from 'node:crypto';
import { TelarError } from '../error/index.mjs';
import { isObject, wrongOption } from '../api/option_check.mjs';

/**
 * Signed addresses of thumbnails, /v1/thumbnails/SIGNATURE/OPTIONS/SOURCE, as imgproxy has them. OPTIONS is what is asked for as JSON and SOURCE the
 * reference of the model, both in base64url, which no proxy writes anew. SIGNATURE is HMAC-SHA256 of salt and "/OPTIONS/SOURCE", in base64url.
 */

/** Bytes that a key has at least. */
const KEY_BYTES = 16;
/** Keys of the request that an address may hold; `expires`: seconds since 1970. */
const ASKED = ['shot', 'failOn', 'ambientVisibility'];
const MOST_KEYS = 16;

const HEX = /^(?:[0-9a-f]{2})+$/i;
const BASE64URL = /^[\w-]+$/;

/** What was given may be a secret: no message has it. */
const wrong = (name, expected) => new TelarError('E_OPTION', `${name}: expected ${expected}`);

/**
 * @param {unknown} given [{key, salt}] in hexadecimal
 * @returns {{key: Buffer, salt: Buffer}[]}
 * @throws {TelarError} E_OPTION, which has nothing of them
 */
export function readSigningKeys(given, name = 'options.signingKeys') {
  if (!Array.isArray(given) || given.length > MOST_KEYS) throw wrong(name, `a list of at most ${MOST_KEYS} {key, salt}`);
  return given.map((pair, i) => {
    const at = `${name}[${i}]`;
    if (!isObject(pair)) throw wrong(at, '{key, salt}');
    const { key, salt } = pair;
    if (typeof key !== 'string' || !HEX.test(key) || key.length < 2 * KEY_BYTES) throw wrong(`${at}.key`, `at least ${KEY_BYTES} bytes in hexadecimal`);
    if (typeof salt !== 'string' || !HEX.test(salt)) throw wrong(`${at}.salt`, 'bytes in hexadecimal');
    return { key: Buffer.from(key, 'hex'), salt: Buffer.from(salt, 'hex') };
  });
}

const digest = ({ key, salt }, text) => createHmac('sha256', key).update(salt).update(text).digest();

const encoded = (text) => Buffer.from(text).toString('base64url');

/**
 * The address of a thumbnail, beneath the service's own.
 * @param {string} model reference
 * @param {object} asked js/server/index.d.ts documents it
 * @param {{key: string, salt: string}} pair in hexadecimal
 * @throws {TelarError} E_OPTION
 */
export function signThumbnail(model, asked, pair) {
  const [own] = readSigningKeys([pair], 'pair');
  if (typeof model !== 'string' || model === '') throw wrongOption('model', 'a reference', model);
  if (!isObject(asked)) throw wrongOption('asked', 'an object', asked);
  const { expires, ...rest } = asked;
  for (const name of Object.keys(rest)) if (!ASKED.includes(name)) throw wrongOption('asked', `no other keys than ${ASKED.join(', ')} and expires`, name);
  if (expires !== undefined && !Number.isSafeInteger(expires)) throw wrongOption('asked.expires', 'whole seconds since 1970', expires);
  const text = `/${encoded(JSON.stringify(asked))}/${encoded(model)}`;
  return `/v1/thumbnails/${digest(own, text).toString('base64url')}${text}`;
}

const refused = (why) => new TelarError('E_SIGNATURE', why);

/** Whose signatures a service takes. */
export class Signatures {
  #keys;

  /** @param {{key: Buffer, salt: Buffer}[]} keys of readSigningKeys() */
  constructor(keys) {
    this.#keys = keys;
  }

  /** Whether references are taken from signed addresses alone. */
  get areNeeded() {
    return this.#keys.length > 0;
  }

  /**
   * @param {string} path "SIGNATURE/OPTIONS/SOURCE"
   * @param {number} now milliseconds since 1970
   * @returns {{query: [string, string][], expires?: number}} parameters of a request; nothing of them is read before the signature is known to be right
   * @throws {TelarError} E_SIGNATURE; E_REQUEST where a key signed what is no request
   */
  open(path, now) {
    if (!this.areNeeded) throw refused('this service takes no signed addresses');
    const parts = path.split('/');
    if (parts.length !== 3 || !parts.every((part) => BASE64URL.test(part))) throw refused('the address is not /v1/thumbnails/SIGNATURE/OPTIONS/SOURCE');
    const [signature, options, source] = parts;
    if (!this.#isSigned(Buffer.from(signature, 'base64url'), `/${options}/${source}`)) throw refused('no key of this service has signed the address');
    const { expires, ...asked } = parsed(Buffer.from(options, 'base64url').toString());
    if (expires !== undefined && !(expires * 1000 > now)) throw refused('the time of the address is over');
    const query = Object.entries({ ...asked, model: Buffer.from(source, 'base64url').toString() });
    return { query: query.map(([name, value]) => [name, typeof value === 'string' ? value : JSON.stringify(value)]), expires };
  }

  /** Takes as long whichever key has signed, and however much of the signature is right. */
  #isSigned(given, text) {
    const matches = this.#keys.map((pair) => {
      const own = digest(pair, text);
      return given.length === own.length && timingSafeEqual(given, own);
    });
    return matches.includes(true);
  }
}

function parsed(text) {
  try {
    const asked = JSON.parse(text);
    if (isObject(asked)) return asked;
  } catch {
    // told below
  }
  throw new TelarError('E_REQUEST', 'the options of the address are no JSON object');
}
