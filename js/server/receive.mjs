import { createHash } from 'node:crypto';
import { handOver } from '../api/handed_over.mjs';
import { TelarError } from '../error/index.mjs';
import { onAbort } from '../api/on_abort.mjs';

/** Bodies of requests: bounded in bytes and in time. */

/** Milliseconds that what is left of a refused body is thrown away, so that its sender reads the answer; then the connection is cut. */
const LINGER_MS = 2000;

export const tooLarge = (name, max, actual, what = 'the body of the request') =>
  new TelarError(name, `${what} has more than ${max} bytes`, { limit: { name, max, actual } });

/** @returns {number | undefined} as the header says, which may be a lie */
const declaredBytes = ({ headers }) => (/^\d{1,15}$/.test(headers['content-length'] ?? '') ? Number(headers['content-length']) : undefined);

/**
 * Hands the body over in pieces.
 * @param {import('node:http').IncomingMessage} message
 * @param {object} bounds
 * @param {number} bounds.maxBytes
 * @param {string} [bounds.limit] its name
 * @param {number} bounds.ms
 * @param {import('./admission.mjs').Held} bounds.held counts the bytes among those of all requests
 * @param {AbortSignal} bounds.signal
 * @param {(chunk: Buffer) => void} take
 * @returns {Promise<number>} bytes
 * @throws {TelarError} L_REQUEST_BYTES or that limit, X_BUSY, X_UPLOAD_TIME, X_CANCELLED; what `take` throws; the signal's reason
 */
export function receive(message, { maxBytes, limit = 'L_REQUEST_BYTES', ms, signal, held }, take) {
  signal.throwIfAborted();
  const declared = declaredBytes(message);
  if (declared > maxBytes) throw tooLarge(limit, maxBytes, declared);
  held.grow(declared ?? 0);
  return new Promise((resolve, reject) => {
    let bytes = 0;
    const stop = (settle, value) => {
      clearTimeout(timer);
      stopListening();
      message.off('data', onData).off('end', onEnd).off('close', onGone).off('error', onGone);
      // What still comes is thrown away.
      message.resume();
      settle(value);
    };
    const onGone = () => stop(reject, new TelarError('X_CANCELLED', 'the connection ended before the body of the request did'));
    const onEnd = () => stop(resolve, bytes);
    const onData = (chunk) => {
      bytes += chunk.length;
      try {
        if (bytes > maxBytes) throw tooLarge(limit, maxBytes, bytes);
        held.grow(bytes);
        take(chunk);
      } catch (error) {
        stop(reject, error);
      }
    };
    const stopListening = onAbort(signal, (reason) => stop(reject, reason));
    const timer = setTimeout(() => stop(reject, new TelarError('X_UPLOAD_TIME', `the body of the request is not there after ${ms} ms`)), ms);
    message.on('data', onData).once('end', onEnd).once('close', onGone).once('error', onGone);
  });
}

/**
 * The body in one piece; other arguments and errors as of receive().
 * @param {(chunk: Buffer) => void} [look] at each piece
 * @returns {Promise<Buffer>}
 */
export async function receiveBytes(message, bounds, look) {
  const declared = declaredBytes(message);
  // In place of a copy of all at the end. A declared length that never comes costs no memory: the system gives pages when they are written to.
  const whole = declared !== undefined && declared <= bounds.maxBytes ? Buffer.allocUnsafeSlow(declared) : undefined;
  const chunks = [];
  let at = 0;
  const bytes = await receive(message, bounds, (chunk) => {
    if (whole) chunk.copy(whole, at);
    else chunks.push(chunk);
    at += chunk.length;
    look?.(chunk);
  });
  return whole ? whole.subarray(0, bytes) : Buffer.concat(chunks);
}

/** A body whose SHA-256 is wanted: found piece by piece as it comes, which holds up nobody and copies nothing. @returns {Promise<Buffer>} */
export async function receiveHashed(message, bounds) {
  const hash = createHash('sha256');
  const bytes = await receiveBytes(message, bounds, (chunk) => hash.update(chunk));
  return handOver(bytes, hash.digest('hex'));
}

/**
 * After the answer to a request whose body was not read: its sender may still be writing, and would not read an answer on a connection that is reset.
 * @param {import('node:http').IncomingMessage} message
 */
export function linger(message) {
  if (message.complete) return;
  message.resume();
  setTimeout(() => {
    if (!message.complete) message.socket?.destroy();
  }, LINGER_MS).unref();
}
