/**
 * Bytes in Redis itself: they take its memory.
 * @implements {import('./folder_store.mjs').Store}
 */
export class RedisStore {
  #client;
  #prefix;

  /** @param {import('ioredis').Redis} client @param {string} prefix of the names of its keys */
  constructor(client, prefix) {
    this.#client = client;
    this.#prefix = prefix;
  }

  async put(ref, data, ms) {
    await this.#client.set(this.#prefix + ref, Buffer.from(data.buffer, data.byteOffset, data.byteLength), 'PX', ms);
  }

  async get(ref) {
    return (await this.#client.getBuffer(this.#prefix + ref)) ?? undefined;
  }

  async drop(refs) {
    if (refs.length > 0) await this.#client.unlink(refs.map((ref) => this.#prefix + ref));
  }

  /** Redis removes them by itself. */
  async sweep() {}
}
