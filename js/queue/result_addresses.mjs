import { orEnd } from '../api/on_abort.mjs';

/** Milliseconds that the owner's callback and another host get for a result. */
const MOST_MS = 5000;
const TYPE = 'application/octet-stream';

const asRequest = (given) => (typeof given === 'string' || given instanceof URL ? { url: given, headers: {} } : given);

/**
 * Results at addresses that the owner's callbacks give, as presigned ones of S3. Redirects are not followed.
 * @implements {import('./result_store.mjs').Place}
 */
export class ResultAddresses {
  #addresses;
  #maxBytes;

  /** @param {{get?: Function, put?: Function}} addresses js/server/index.d.ts documents them @param {number} maxBytes of a result */
  constructor(addresses, maxBytes) {
    this.#addresses = addresses;
    this.#maxBytes = maxBytes;
  }

  async get(name, signal) {
    const end = AbortSignal.any([signal, AbortSignal.timeout(MOST_MS)]);
    const given = await orEnd(end, () => this.#addresses.get?.(name));
    if (!given) return undefined;
    const { url, headers } = asRequest(given);
    const response = await fetch(url, { headers, redirect: 'manual', signal: end });
    // S3 says 403 of what is not there to whoever may not list.
    if (response.status !== 200) await response.body?.cancel();
    if (response.status === 404 || response.status === 403) return undefined;
    if (response.status !== 200) throw new Error(`the store answers with ${response.status}`);
    const chunks = [];
    let bytes = 0;
    for await (const chunk of response.body) {
      bytes += chunk.byteLength;
      if (bytes > this.#maxBytes) throw new Error('the store gives more than a result may have');
      chunks.push(chunk);
    }
    return Buffer.concat(chunks);
  }

  async put(name, bytes) {
    const signal = AbortSignal.timeout(MOST_MS);
    const given = bytes.byteLength <= this.#maxBytes && (await orEnd(signal, () => this.#addresses.put?.(name)));
    if (!given) return;
    const { url, headers } = asRequest(given);
    const init = { method: 'PUT', body: bytes, headers: { 'content-type': TYPE, ...headers }, redirect: 'manual', signal };
    const response = await fetch(url, init);
    await response.body?.cancel();
    if (!response.ok) throw new Error(`the store answers with ${response.status}`);
  }

  /** The owner's rules of the bucket say what goes. */
  async drop() {}
}
