import { stat } from 'node:fs';
import { ASSET_DIRECTORY, loadNative } from './native.mjs';
import { rendererOptions } from './options.mjs';

/** How a GL is opened, and what a command begins before it knows all that it is asked for. */

/** Frames and small requests in the GL thread's own queue. */
const MAX_QUEUED = 64;

/** What the addon's createRenderer takes. @param {object} options of rendererOptions */
export const openingRequest = ({ backend, cacheDirectory, cacheBytes, limits, allFeatures }) => ({
  backend,
  assetDirectory: ASSET_DIRECTORY,
  cacheDirectory,
  cacheBytes,
  limits,
  allFeatures,
  maxQueued: MAX_QUEUED,
});

/**
 * A GL with the default options that begins to open while a command line is still being read, which takes as long as to load the libraries of the GL. The
 * renderer takes it that would open the same; else it is closed.
 */
export class EarlyGl {
  #request;
  #opening;

  /**
   * @param {object} [native] the addon's exports
   * @throws {TelarError} X_NATIVE_MISSING
   */
  constructor(native = loadNative()) {
    const request = openingRequest(rendererOptions({}, Object.keys(native.limits)));
    // Node starts its threads for files with the first use of one, and who starts a thread waits while another loads libraries: before the GL, then.
    stat('.', () => {});
    this.#request = JSON.stringify(request);
    this.#opening = native.createRenderer(request, new native.CancelToken());
    // Whoever takes it tells.
    this.#opening.catch(() => {});
  }

  /** @returns {Promise<{renderer: object, facts: string}> | undefined} for a renderer of the same request, once */
  take(request) {
    if (JSON.stringify(request) !== this.#request) return undefined;
    const opening = this.#opening;
    this.#opening = undefined;
    return opening;
  }

  /** Closes what nobody has taken. */
  async close() {
    const opened = await this.#opening?.catch(() => undefined);
    await opened?.renderer.close();
  }
}

/** What one picture will be drawn of, on its way: render() takes it in place of a source, once. */
export class BegunLoad {
  constructor(model, work) {
    this.start = performance.now();
    this.model = model;
    this.work = work;
    // The picture tells what is wrong.
    model.catch(() => {});
  }
}
