import { TelarError } from '../error/index.mjs';

/**
 * Reads a stream to its end.
 * @param {AsyncIterable<Buffer>} stream
 * @param {number} maxBytes
 * @param {AbortSignal} [signal]
 * @returns {Promise<Buffer>}
 * @throws {TelarError} L_FILE_BYTES as soon as the limit is passed
 */
export async function readAll(stream, maxBytes, signal) {
  const chunks = [];
  let bytes = 0;
  const onAbort = () => stream.destroy?.(signal.reason);
  signal?.addEventListener('abort', onAbort, { once: true });
  try {
    signal?.throwIfAborted();
    for await (const chunk of stream) {
      bytes += chunk.length;
      if (bytes > maxBytes) {
        throw new TelarError('L_FILE_BYTES', `stdin holds more than the limit of ${maxBytes} bytes; raise it with --limit L_FILE_BYTES=N`, {
          limit: { name: 'L_FILE_BYTES', max: maxBytes, actual: bytes },
        });
      }
      chunks.push(chunk);
    }
  } finally {
    signal?.removeEventListener('abort', onAbort);
  }
  return Buffer.concat(chunks);
}

/**
 * Writes and waits until the data has left.
 * @param {import('node:stream').Writable} stream
 * @param {Buffer | string} data
 * @throws {TelarError} X_OUTPUT
 */
export function writeAll(stream, data) {
  return new Promise((resolve, reject) => {
    const fail = (cause) => reject(new TelarError('X_OUTPUT', `stdout takes no more data (${cause.code ?? cause.message})`, { cause }));
    stream.once('error', fail);
    stream.write(data, (error) => {
      if (error) return;
      stream.removeListener('error', fail);
      resolve();
    });
  });
}
