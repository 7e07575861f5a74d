import { onAbort } from './on_abort.mjs';
import { ProgressReport } from './progress.mjs';

/** How a caller follows a drawing, and ends it. */

/**
 * Runs jobs that end together: the first that fails, the caller's signal or a throwing callback cancels them all.
 * @param {AbortSignal | undefined} outer
 * @param {{onProgress?: (part: number) => void, onPreview?: (preview: object) => void}} callbacks
 * @param {number} jobs
 * @param {(signal: AbortSignal, report: ProgressReport | undefined) => Promise<T>} run
 * @returns {Promise<T>}
 * @template T
 */
export async function inScope(outer, { onProgress, onPreview }, jobs, run) {
  outer?.throwIfAborted();
  const scope = new AbortController();
  const stopListening = outer && onAbort(outer, (reason) => scope.abort(reason));
  const guarded = (callback) => (what) => {
    try {
      // What is on its way when the work ends is not told.
      if (!scope.signal.aborted) callback(what);
    } catch (error) {
      scope.abort(error);
    }
  };
  const report = (onProgress || onPreview) && new ProgressReport(guarded(onProgress ?? (() => {})), jobs, onPreview && guarded(onPreview));
  try {
    const result = await run(scope.signal, report);
    scope.signal.throwIfAborted();
    return result;
  } catch (error) {
    scope.abort(error);
    throw error;
  } finally {
    stopListening?.();
    report?.stop();
  }
}

/** Ends a job with the picture as it is when its caller has enough. Rounds double, so that there is one. @returns {() => void} stops listening */
export function untilEnough(enough, token) {
  token.askPreviews();
  if (!enough.aborted) return onAbort(enough, () => token.settle());
  token.settle();
  return () => {};
}
