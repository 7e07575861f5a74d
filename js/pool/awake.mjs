/** The longest that a timer may be set to. */
const LONG = 2 ** 31 - 1;

let waiting = 0;
let timer;

/**
 * Keeps this process alive until the promise settles. Workers that wait for jobs do not, so a program without jobs ends by itself.
 * @param {Promise<T>} promise
 * @returns {Promise<T>}
 * @template T
 */
export async function awake(promise) {
  waiting += 1;
  timer ??= setInterval(() => {}, LONG);
  try {
    return await promise;
  } finally {
    waiting -= 1;
    if (waiting === 0) {
      clearInterval(timer);
      timer = undefined;
    }
  }
}
