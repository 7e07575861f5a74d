/** By signal: what waits for it. One listener serves them all, as Node warns of a leak from the eleventh on. */
const waiting = new WeakMap();

function listenTo(signal) {
  const callbacks = new Set();
  const listener = () => {
    waiting.delete(signal);
    for (const callback of callbacks) callback(signal.reason);
  };
  signal.addEventListener('abort', listener, { once: true });
  return { callbacks, listener };
}

/**
 * Calls back once when the signal fires.
 * @param {AbortSignal} signal not aborted yet
 * @param {(reason: unknown) => void} callback
 * @returns {() => void} stops listening
 */
export function onAbort(signal, callback) {
  if (!waiting.has(signal)) waiting.set(signal, listenTo(signal));
  const { callbacks, listener } = waiting.get(signal);
  callbacks.add(callback);
  return () => {
    if (!callbacks.delete(callback) || callbacks.size > 0) return;
    signal.removeEventListener('abort', listener);
    waiting.delete(signal);
  };
}

/**
 * What a callback of the owner gives, until the signal fires: one that does not look at its signal is not waited for.
 * @param {AbortSignal} signal
 * @param {() => T | Promise<T>} use
 * @returns {Promise<T>}
 * @throws the signal's reason, and what it throws
 * @template T
 */
export async function orEnd(signal, use) {
  signal.throwIfAborted();
  let stopListening;
  const end = new Promise((_, reject) => {
    stopListening = onAbort(signal, reject);
  });
  try {
    return await Promise.race([use(), end]);
  } finally {
    stopListening();
  }
}
