import { TelarError } from '../error/index.mjs';

/** Results that go to addresses which their owner has signed, as S3 and its like have them. */

const failed = (host, what, cause) => new TelarError('X_QUEUE', `${host} does not take a file of the result: ${what}`, { cause });

/**
 * Sends each file to its address. The same file may be sent again: its address is written over.
 * @param {{name: string, type: string, data: Uint8Array}[]} files
 * @param {string[]} addresses in the order of the files
 * @param {{signal: AbortSignal, hosts?: string[]}} how hosts: the only ones that are sent to, as host:port; without them any
 * @returns {Promise<{name: string, type: string, bytes: number, url: string}[]>} url: without its signature
 * @throws {TelarError} X_QUEUE, E_OPTION
 */
export async function putFiles(files, addresses, { signal, hosts }) {
  if (addresses.length < files.length) throw new TelarError('E_OPTION', `options.put: expected ${files.length} addresses, got ${addresses.length}`);
  return Promise.all(files.map((file, i) => putFile(file, new URL(addresses[i]), { signal, hosts })));
}

/** Hosts as addresses write them: in lower case, and without the port that the scheme has by itself. */
const isOneOf = (hosts, { protocol, host }) => hosts.some((given) => URL.canParse(`${protocol}//${given}`) && new URL(`${protocol}//${given}`).host === host);

async function putFile({ name, type, data }, url, { signal, hosts }) {
  if (hosts && !isOneOf(hosts, url)) throw new TelarError('E_URI_DENIED', `options.put: results are not sent to ${url.host}`);
  let response;
  try {
    response = await fetch(url, { method: 'PUT', body: data, headers: { 'content-type': type }, redirect: 'error', signal });
    // What the host says beside its status may have no end.
    await response.body?.cancel();
  } catch (cause) {
    if (signal.aborted) throw signal.reason;
    throw failed(url.host, 'it cannot be reached', cause);
  }
  if (!response.ok) throw failed(url.host, `it answers ${response.status}`);
  return { name, type, bytes: data.byteLength, url: url.origin + url.pathname };
}
