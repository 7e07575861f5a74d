import { TelarError, fromNative } from '../error/index.mjs';
import { checkQuantity, checkShots, ofShot } from '../api/draw_request.mjs';
import { Gate } from '../api/gate.mjs';
import { isHandedOver } from '../api/handed_over.mjs';
import { loadNative } from '../api/native.mjs';
import { onAbort } from '../api/on_abort.mjs';
import { drawAllOptions, loadOptions, renderOptions, wrongOption } from '../api/options.mjs';
import { readShot, readSource } from '../api/source.mjs';
import { awake } from './awake.mjs';
import { PoolModel } from './model.mjs';
import { poolOptions } from './options.mjs';
import { compareOptions, inspectOptions, sheetOptions } from './options_of_calls.mjs';
import { unpackPicture } from './pictures.mjs';
import { Quarantine } from './quarantine.mjs';
import { Recipe } from './recipe.mjs';
import { crashed, overTime } from './verdicts.mjs';
import { WorkerEnded } from './worker_process.mjs';
import { Workers } from './workers.mjs';

/**
 * What readSource() copies bytes into here: the pool's own memory, as they cross a pipe later; what was handed over is not copied. What is too large is
 * refused by the addon, before it is copied and in the same words.
 */
const copying = (native) => ({
  Bytes: class {
    constructor(bytes, maxBytes) {
      if (bytes.byteLength > maxBytes) this.bytes = new native.Bytes(bytes, maxBytes);
      else this.bytes = isHandedOver(bytes) ? bytes : Buffer.from(bytes);
    }
  },
});

/** Workers that a job is given to, where those before ended without having taken it up. */
const TRIES = 3;

/** An error of one of the shots that were sent, as one of those that the caller gave. */
const moved = (error, index) => new TelarError(error.code, error.message.replace(/^shots\[\d+\]/, `shots[${index}]`), { ...error.toJSON(), index });

/** js/pool/index.d.ts documents the public methods. */
class Pool {
  #native;
  #maxBytes;
  #loading;
  #gate;
  #workers;
  #quarantine;
  #pending = new Set();
  #closed;
  /** Models that nobody can name any more are let go. */
  #lost = new FinalizationRegistry((id) => this.#forget(id));

  constructor(native, workers, { backend, gl }, { renderer, size, quarantineMs }) {
    this.#native = { limits: native.limits, ...copying(native) };
    this.#maxBytes = renderer.limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
    this.#loading = renderer.loading;
    this.#gate = new Gate(size, renderer.maxWaiting, 'pool');
    this.#workers = workers;
    this.#quarantine = new Quarantine(quarantineMs);
    this.backend = backend;
    this.gl = Object.freeze(gl);
  }

  get workers() {
    return this.#workers.all.map(({ pid, facts, isBusy, jobs, glObjects }) => ({
      pid,
      state: facts ? (isBusy ? 'busy' : 'idle') : 'starting',
      jobs,
      glObjects,
      isolation: facts?.isolation ?? [],
    }));
  }

  async load(source, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    const recipe = new Recipe({ input: this.#readInput(source), loading });
    const { timeoutMs } = loading;
    return this.#model(recipe, await this.#ask({ method: 'load', recipe, timeoutMs, unpack: (facts) => facts }, signal));
  }

  async render(source, shot = {}, options = {}) {
    this.#assertOpen();
    const { signal, onProgress, onPreview, reached, ...loading } = renderOptions(options, this.#loading);
    const of = this.#readSource(source);
    const read = this.#readShot(shot);
    const unpack = (value, parts) => unpackPicture(value, parts, read.map);
    return this.#ask({ method: 'render', ...of, shots: [read], onProgress, onPreview, reached, ...this.#times(loading), unpack }, signal);
  }

  async renderQuantity(source, shot, quantity, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    checkQuantity(quantity);
    const of = this.#readSource(source);
    const read = this.#readShot({ ...shot });
    const unpack = ({ width, height }, [{ buffer }]) => ({ width, height, data: new Float32Array(buffer) });
    return this.#ask({ method: 'renderQuantity', ...of, shots: [read], quantity, ...this.#times(loading), unpack }, signal);
  }

  async renderAll(source, shots, options = {}) {
    this.#assertOpen();
    const { signal, onProgress, settled, ...loading } = drawAllOptions(options, this.#loading);
    checkShots(shots);
    const of = this.#readSource(source);
    const read = shots.map((shot, index) => this.#readShotOf(shot, index, settled));
    const sent = read.filter(({ failure }) => !failure);
    const unpack = (values, parts) => {
      const left = [...values];
      const next = ({ map }, index) => {
        const value = left.shift();
        if (!settled) return unpackPicture(value, parts, map);
        if (value.reason) return { status: 'rejected', reason: moved(fromNative(value.reason), index) };
        return { status: 'fulfilled', value: unpackPicture(value.value, parts, map) };
      };
      return read.map((each, index) => (each.failure ? { status: 'rejected', reason: ofShot(each.failure, index) } : next(each, index)));
    };
    return this.#ask({ method: 'renderAll', ...of, shots: sent, settled, onProgress, ...this.#times(loading), unpack }, signal);
  }

  async factsOf(source, shot = {}, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    const of = this.#readSource(source);
    return this.#ask({ method: 'factsOf', ...of, shots: [this.#readShot(shot)], ...this.#times(loading), unpack: (facts) => facts }, signal);
  }

  async inspect(source, options = {}) {
    this.#assertOpen();
    const { shot, measure, loading, signal } = inspectOptions(options, this.#loading);
    const input = this.#readInput(source);
    return this.#ask(
      { method: 'inspect', input, shots: [this.#readShot(shot)], args: [{ measure }], ...this.#times(loading), unpack: (facts) => facts },
      signal,
    );
  }

  async compare(expected, actual, options = {}) {
    this.#assertOpen();
    const { asked, timeoutMs, signal } = compareOptions(options, this.#loading);
    const [input, other] = [actual, expected].map((image) => this.#readInput(image));
    const unpack = (answer, [map]) => ({ ...answer, ...(asked.heatMap && { heatMap: map }) });
    return this.#ask({ method: 'compare', input, others: [['expected', other]], args: [asked], timeoutMs, unpack }, signal);
  }

  async sheet(source, spec, options = {}) {
    this.#assertOpen();
    const { asked, others, shot, loading, onProgress, signal } = sheetOptions(spec, options, this.#loading);
    const of = this.#readSource(source);
    const unpack = (answer, files) => ({ ...answer, files });
    return this.#ask({ method: 'sheet', ...of, others, shots: [this.#readShot(shot)], args: [asked], onProgress, ...this.#times(loading), unpack }, signal);
  }

  async release(model) {
    this.#assertOpen();
    if (!PoolModel.isModel(model)) throw wrongOption('model', 'a loaded model', model);
    this.#forget(PoolModel.recipeOf(model).id);
  }

  close() {
    this.#closed ??= awake(this.#close());
    return this.#closed;
  }

  [Symbol.asyncDispose]() {
    return this.close();
  }

  async #close() {
    while (this.#pending.size > 0) await Promise.allSettled(this.#pending);
    await this.#workers.close();
  }

  #assertOpen() {
    if (this.#closed) throw new TelarError('X_CLOSED', 'the pool was closed; make a new one with createPool()');
  }

  #times(loading) {
    return { loading, timeoutMs: loading.timeoutMs };
  }

  #readInput(source) {
    const input = readSource(this.#native, source, this.#maxBytes);
    return typeof input === 'string' ? { path: input } : input;
  }

  #readSource(source) {
    return PoolModel.isModel(source) ? { recipe: PoolModel.recipeOf(source) } : { input: this.#readInput(source) };
  }

  #readShot(shot) {
    return readShot(this.#native, shot, this.#maxBytes);
  }

  #readShotOf(shot, index, settled) {
    try {
      return this.#readShot(shot);
    } catch (failure) {
      if (settled) return { failure };
      throw ofShot(failure, index);
    }
  }

  #model(recipe, facts) {
    recipe.know(facts);
    const ask = (request, signal) => {
      this.#assertOpen();
      return this.#ask(request, signal);
    };
    const model = new PoolModel(recipe, facts, { ask, readShot: (shot) => this.#readShot(shot), model: (of, found) => this.#model(of, found) });
    this.#lost.register(model, recipe.id);
    return model;
  }

  #forget(id) {
    for (const worker of this.#workers.all) if (worker.held.has(id)) worker.forget([id]);
  }

  /** Makes close() wait for a job. */
  async #ask(request, signal) {
    const job = this.#gate.run(() => this.#perform(request, signal), signal);
    this.#pending.add(job);
    try {
      return await awake(job);
    } finally {
      this.#pending.delete(job);
    }
  }

  async #perform(request, signal) {
    const inputs = inputsOf(request);
    await this.#quarantine.check(inputs);
    for (let tries = 1; ; ++tries) {
      try {
        const value = await this.#try(request, inputs, signal);
        await this.#quarantine.clear(inputs);
        return value;
      } catch (error) {
        if (!(error instanceof WorkerEnded)) throw error;
        // One that was ended while it waited for work, and whose end was not seen yet.
        const isInnocent = !error.hadBegun && !error.verdict;
        if (!isInnocent || tries === TRIES) throw error.verdict ?? crashed(error.facts, error.input);
      }
    }
  }

  /** In one worker. @throws {WorkerEnded} with the digest of a file that is remembered */
  async #try(request, inputs, signal) {
    signal?.throwIfAborted();
    const worker = await this.#workers.take(({ held }) => held.has(request.recipe?.id), signal);
    if (signal?.aborted) {
      void this.#workers.give(worker);
      throw signal.reason;
    }
    const { outcome, free } = worker.run(request, signal);
    // Whoever aborts does not wait for it: a worker that had to be ended then counts all the same.
    const remembered = free.then((ended) => {
      this.#workers.give(worker);
      return ended && this.#remember(ended, inputs);
    });
    remembered.catch(() => {});
    try {
      return await outcome;
    } catch (error) {
      if (error instanceof WorkerEnded) error.input = await remembered;
      throw error;
    }
  }

  /** The files of a worker that ended are remembered unless a bound of the pool ended it, which goes by the shot too. @returns its digest */
  async #remember({ verdict, hadBegun }, inputs) {
    const isOfFile = hadBegun && (!verdict || verdict.code === overTime(0).code);
    return isOfFile ? this.#quarantine.record(inputs) : undefined;
  }
}

/** The files of a job: its model, or the picture that is compared, and what came with it. */
const inputsOf = ({ recipe, input, others = [], shots = [] }) => [
  recipe?.root.input ?? input,
  ...others.map(([, other]) => other),
  ...shots.flatMap(({ environment }) => environment ?? []),
];

/** Starts the workers. js/pool/index.d.ts documents it, its options and the methods of Pool. */
export async function createPool(options = {}) {
  const native = loadNative();
  const rest = poolOptions(options, Object.keys(native.limits));
  const { signal, backend, cacheDirectory, cacheBytes, limits, allFeatures } = rest.renderer;
  signal?.throwIfAborted();
  const renderer = { backend, cacheDirectory: cacheDirectory || null, cacheBytes, limits, allFeatures };
  const workers = new Workers({ ...rest, renderer });
  let stopListening;
  try {
    const aborted = signal && new Promise((_, reject) => (stopListening = onAbort(signal, reject)));
    const facts = await awake(Promise.race([workers.open(), ...(aborted ? [aborted] : [])]));
    return new Pool(native, workers, facts, rest);
  } catch (error) {
    await awake(workers.close());
    throw error;
  } finally {
    stopListening?.();
  }
}
