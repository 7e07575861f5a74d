import { toTelarError } from '../error/index.mjs';
import { writeFileAtomically } from '../api/atomic_file.mjs';
import { layerFiles } from './layer_files.mjs';

/** Draws the pictures of a command line. A picture that fails does not stop the others. */

/** Models on their way at once, and pictures of each; the renderer draws one at a time, loading and encoding run beside it. */
const IN_FLIGHT = 4;

/** Runs `run` on every item, so many at once; takes no more when the signal has fired, so that one at least tells of it. */
async function eachOf(items, { signal, atOnce = 0 }, run) {
  const next = items.values();
  const work = async () => {
    for (const item of next) {
      await run(item);
      if (signal?.aborted) return;
    }
  };
  await Promise.all(Array.from({ length: Math.min(Math.max(IN_FLIGHT, atOnce), items.length) }, work));
}

/** Indices of the jobs by model, so that each model is decoded once. */
function byModel(jobs) {
  const groups = new Map();
  jobs.forEach(({ source }, index) => {
    if (!groups.has(source)) groups.set(source, []);
    groups.get(source).push(index);
  });
  return [...groups.values()];
}

/**
 * @typedef {object} Result of one picture
 * @property {import('./jobs.mjs').Job} job
 * @property {string} file
 * @property {boolean} [unchanged] it was there already
 * @property {string} [key]
 * @property {number} [bytes]
 * @property {Record<string, string>} [layers] files of the layers by name
 * @property {object} [info] where it was drawn
 * @property {import('../error/index.mjs').TelarError} [error]
 */
export class Drawing {
  #context;
  #results;

  /**
   * @param {object} context
   * @param {import('./jobs.mjs').Job[]} context.jobs
   * @param {Array<{file: string, format: string}>} context.outputs of the jobs
   * @param {object} context.renderer
   * @param {(bytes: Uint8Array) => Promise<void>} context.toStdout
   * @param {(source: string | Uint8Array, shot: object) => Promise<string>} context.keyOf
   * @param {number} [context.atOnce] pictures that the renderer draws at once, where it is a pool
   * @param {{source: string, load: object}} [context.ahead] a source that is being loaded already, and what the renderer takes for it
   * @param {boolean} [context.reached] what goals of error came to is measured
   * @param {number} [context.explode] metres by which parts are moved apart
   * @param {import('./unchanged.mjs').KnownPictures} [context.known] to leave out what has not changed
   * @param {{step(name: string, index: number): void, reach?: (index: number, part: number) => void}} context.progress
   * @param {AbortSignal} [context.signal]
   */
  constructor(context) {
    this.#context = context;
    this.#results = new Array(context.jobs.length);
  }

  /** @returns {Promise<Result[]>} in the order of the jobs; those that an abort left out are missing */
  async run() {
    const { jobs } = this.#context;
    await eachOf(byModel(jobs), this.#context, (indices) => this.#drawModel(indices));
    return this.#results.filter(Boolean);
  }

  /** All pictures of one model. One that has several is decoded for all of them. */
  async #drawModel(indices) {
    const { signal, renderer, jobs } = this.#context;
    const changed = [];
    await eachOf(indices, this.#context, async (index) => {
      if (!(await this.#isUnchanged(index))) changed.push(index);
    });
    const { explode } = this.#context;
    if (changed.length < 2 && explode === undefined) {
      for (const index of changed) await this.#draw(index, jobs[index].source);
      return;
    }
    let model;
    try {
      model = await renderer.load(jobs[changed[0]].source, { signal });
      if (explode !== undefined) model = await model.explode(explode, { signal });
    } catch (thrown) {
      const error = toTelarError(thrown);
      for (const index of changed) this.#settle(index, { error });
      return;
    }
    await eachOf(
      changed.sort((a, b) => a - b),
      this.#context,
      (index) => this.#draw(index, model),
    );
    // What goes wrong with the renderer itself, its pictures have told.
    await renderer.release(model).catch(() => {});
  }

  async #isUnchanged(index) {
    const { known, keyOf, jobs, outputs } = this.#context;
    if (!known) return false;
    const { source, shot } = jobs[index];
    // A model that cannot be read tells so when it is drawn.
    const key = await keyOf(source, shot).catch(() => undefined);
    if (key === undefined) return false;
    const files = [outputs[index].file, ...Object.values(layerFiles(outputs[index].file, shot))];
    const same = await Promise.all(files.map((file) => known.has(file, key)));
    if (same.includes(false)) return false;
    this.#settle(index, { unchanged: true, key });
    return true;
  }

  async #draw(index, source) {
    const { jobs, outputs, renderer, known, signal, progress, toStdout, reached, ahead } = this.#context;
    const given = ahead?.source === source ? ahead.load : source;
    const { file } = outputs[index];
    const onProgress = progress.reach && ((part) => progress.reach(index, part));
    try {
      const { data, layers = {}, info } = await renderer.render(given, jobs[index].shot, { signal, onProgress, ...(reached && { reached }) });
      if (file === '-') await toStdout(data);
      else await writeFileAtomically(file, data, signal);
      known?.add(file, info.key, data);
      const files = layerFiles(file, jobs[index].shot);
      for (const [layer, bytes] of Object.entries(layers)) {
        await writeFileAtomically(files[layer], bytes, signal);
        known?.add(files[layer], info.key, bytes);
      }
      this.#settle(index, { bytes: data.length, key: info.key, info, ...(Object.keys(layers).length > 0 && { layers: files }) });
    } catch (thrown) {
      this.#settle(index, { error: toTelarError(thrown) });
    }
  }

  #settle(index, result) {
    const { jobs, outputs, progress } = this.#context;
    this.#results[index] = { job: jobs[index], file: outputs[index].file, ...result };
    progress.step(jobs[index].model, index);
  }
}
