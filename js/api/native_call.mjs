import { fromNative } from '../error/index.mjs';
import { onAbort } from './on_abort.mjs';

/** Runs `start`, which calls native code, and turns what it throws or rejects with into a TelarError. */
async function typed(start) {
  try {
    return await start();
  } catch (error) {
    throw fromNative(error);
  }
}

/**
 * A native job under an AbortSignal and a bound on its time. An abort rejects at once with the signal's reason; the job itself is told to stop
 * and does so within milliseconds, wherever it is: waiting, loading, drawing or encoding.
 * @param {object} native the addon's exports
 * @param {{signal?: AbortSignal, token?: object}} [work] token: of a Work; by default one that allows any time
 * @param {(token: object) => Promise<T>} start makes the native call with this cancel token
 * @param {(result: T) => void} [discard] takes a result that came after the abort
 * @returns {Promise<T>}
 * @template T
 */
export function nativeCall(native, { signal, token = new native.CancelToken() } = {}, start, discard = () => {}) {
  if (!signal) return typed(() => start(token));
  if (signal.aborted) return Promise.reject(signal.reason);
  return new Promise((resolve, reject) => {
    const stopListening = onAbort(signal, (reason) => {
      token.cancel();
      reject(reason);
    });
    typed(() => start(token))
      .then((result) => {
        if (signal.aborted) discard(result);
        resolve(result);
      }, reject)
      .finally(stopListening);
  });
}
