/**
 * One call after the other, whatever becomes of the one before.
 * @template {unknown[]} A
 * @template R
 * @param {(...args: A) => Promise<R>} work
 * @returns {(...args: A) => Promise<R>}
 */
export function serial(work) {
  let last = Promise.resolve();
  return (...args) => {
    const job = last.then(() => work(...args));
    last = job.catch(() => {});
    return job;
  };
}
