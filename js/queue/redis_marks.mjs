import { fromNative } from '../error/index.mjs';

/** What a worker writes that has a job's end and is about to tell it. */
const ENDING = 'ending';

/**
 * Who ends a job: whoever cancels it, or the worker that has its end. Each writes the job's mark where there is none, so that a job which was told to be
 * cancelled is never done afterwards.
 */
export class RedisMarks {
  #client;
  #keyOf;

  /** @param {import('ioredis').Redis} client @param {(id: string) => string} keyOf */
  constructor(client, keyOf) {
    this.#client = client;
    this.#keyOf = keyOf;
  }

  /** @param {object} state as it is told @param {number} ms for which it is known @returns {Promise<boolean>} false: its worker was first */
  async cancel(id, state, ms) {
    return (await this.#client.set(this.#keyOf(id), JSON.stringify(state), 'PX', ms, 'NX')) !== null;
  }

  /** @param {number} ms in which the end is told; a worker that ends meanwhile leaves the job to another one @returns {Promise<boolean>} false: it was cancelled */
  async end(id, ms) {
    if ((await this.#client.set(this.#keyOf(id), ENDING, 'PX', ms, 'NX')) !== null) return true;
    return (await this.cancelled(id)) === undefined;
  }

  /** @returns {Promise<object | undefined>} the state of a job that was cancelled */
  async cancelled(id) {
    return stateOf(await this.#client.get(this.#keyOf(id)));
  }

  /** @param {string[]} ids @returns {Promise<string[]>} those that were cancelled */
  async cancelledOf(ids) {
    const marks = await this.#client.mget(ids.map(this.#keyOf));
    return ids.filter((_, i) => stateOf(marks[i]) !== undefined);
  }

  /** Before a job is asked for again. */
  async clear(id) {
    await this.#client.unlink(this.#keyOf(id));
  }
}

function stateOf(mark) {
  if (!mark || mark === ENDING) return undefined;
  const { error, ...state } = JSON.parse(mark);
  return { ...state, error: fromNative(error) };
}
