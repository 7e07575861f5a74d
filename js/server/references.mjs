import { TelarError } from '../error/index.mjs';
import { orEnd } from '../api/on_abort.mjs';
import { wrongOption } from '../api/option_check.mjs';
import { bytesOf } from '../api/source.mjs';
import { shown } from '../shot/complain.mjs';
import { tooLarge } from './receive.mjs';

/** Models that a request names: by the owner's callback, or from hosts that the owner allows. */

/** Without its parameters, which may hold a key or a signature, and without a name and password: messages go to logs. */
const named = (reference) => shown(reference.split(/[?#]/)[0].replace(/^(https?:\/\/)[^/]*@/i, '$1'));

const isAddress = (reference) => /^https?:\/\//i.test(reference);

/** @param {string} entry "models.example.com" means https; "http://store:9000" is an origin @throws {TelarError} E_OPTION */
function originOf(entry) {
  const address = isAddress(entry) ? entry : `https://${entry}`;
  const { origin, pathname, search, username, password } = URL.canParse(address) ? new URL(address) : {};
  if (!origin || pathname !== '/' || search || username || password)
    throw wrongOption('options.allowHosts', 'hosts, or origins as in http://store:9000', entry);
  return origin;
}

export class References {
  #resolve;
  #origins;
  #maxBytes;

  /** @param {{resolve?: Function, allowHosts: string[], maxBytes: number}} options */
  constructor({ resolve, allowHosts, maxBytes }) {
    this.#resolve = resolve;
    this.#origins = new Set(allowHosts.map(originOf));
    this.#maxBytes = maxBytes;
  }

  /**
   * @param {string} reference
   * @param {AbortSignal} signal
   * @param {{grow: (bytes: number) => void}} held what counts the bytes as they come
   * @returns {Promise<Uint8Array>}
   * @throws {TelarError} E_URI_DENIED, E_NOT_FOUND, L_FILE_BYTES, X_SOURCE, X_RESOLVE
   */
  async bytes(reference, signal, held) {
    const { origin, username, password } = isAddress(reference) && URL.canParse(reference) ? new URL(reference) : {};
    const hasName = Boolean(username || password);
    if (this.#origins.has(origin) && !hasName) return this.#fetch(reference, signal, held);
    if (this.#resolve) {
      const bytes = await this.#resolved(reference, signal);
      held.grow(bytes.byteLength);
      return bytes;
    }
    const whyNotAsked = hasName ? 'addresses with a name or a password are not' : 'its host is not allowed';
    const why = isAddress(reference) ? whyNotAsked : 'this service resolves no references';
    throw new TelarError('E_URI_DENIED', `request.model: ${named(reference)} is not opened, as ${why}; send the model in the request`, { pointer: '/model' });
  }

  async #resolved(reference, signal) {
    let given;
    try {
      given = await orEnd(signal, () => this.#resolve(reference, { signal, maxBytes: this.#maxBytes }));
    } catch (cause) {
      if (signal.aborted || cause instanceof TelarError) throw signal.reason ?? cause;
      throw new TelarError('X_RESOLVE', `the owner of the service could not resolve ${named(reference)}`, { cause });
    }
    if (given === null || given === undefined) throw this.#absent(reference);
    const bytes = bytesOf(given);
    if (!bytes) throw new TelarError('X_RESOLVE', `the owner of the service gave no bytes for ${named(reference)}`);
    if (bytes.byteLength > this.#maxBytes) throw tooLarge('L_FILE_BYTES', this.#maxBytes, bytes.byteLength, 'the model');
    return bytes;
  }

  #absent(reference) {
    return new TelarError('E_NOT_FOUND', `request.model: there is no model ${named(reference)}`, { pointer: '/model' });
  }

  /** No redirects, no credentials; as many bytes as a file may have, whatever the headers say. */
  async #fetch(address, signal, held) {
    const refused = (what, cause) => new TelarError('X_SOURCE', `${shown(new URL(address).host)} ${what}`, { cause });
    let response;
    try {
      response = await fetch(address, { signal, redirect: 'manual', credentials: 'omit', headers: { 'accept-encoding': 'identity' } });
    } catch (cause) {
      signal.throwIfAborted();
      throw refused('cannot be reached', cause);
    }
    const { status } = response;
    if (status !== 200 || !response.body) await response.body?.cancel();
    if (status === 404 || status === 410) throw this.#absent(address);
    if (status !== 200 || !response.body) throw refused(`answers with ${status}${status >= 300 && status < 400 ? ', and redirects are not followed' : ''}`);
    const chunks = [];
    let bytes = 0;
    try {
      for await (const chunk of response.body) {
        bytes += chunk.byteLength;
        if (bytes > this.#maxBytes) throw tooLarge('L_FILE_BYTES', this.#maxBytes, bytes, 'the model');
        held.grow(bytes);
        chunks.push(chunk);
      }
    } catch (cause) {
      signal.throwIfAborted();
      if (cause instanceof TelarError) throw cause;
      throw refused('breaks off', cause);
    }
    return Buffer.concat(chunks);
  }
}
