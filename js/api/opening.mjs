import { ASSET_DIRECTORY } from './native.mjs';

/** What a renderer begins with. */

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
