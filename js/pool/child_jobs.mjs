import { inspect } from '../api/inspect.mjs';
import { TelarError, fromNative, toTelarError } from '../error/index.mjs';
import { packFlat, packPicture, withMap } from './pictures.mjs';
import { overOutput, untrusted } from './verdicts.mjs';

/** Loading options as the renderer takes them. */
const loadingOf = ({ failOn, timeoutMs, rays }) => ({ failOn, timeoutMs, ambientVisibility: rays ? { rays } : false });

const shotOf = ({ shot, environment }, parts) => (environment === undefined ? shot : withMap(shot, parts[environment]));

/** Whether the renderer's GL context is gone, of one picture or of one of several: it draws no other. */
const hasLostContext = ({ value, error }) =>
  [error, ...(Array.isArray(value) ? value.map(({ reason }) => reason) : [])].some((each) => each?.code === 'X_GL_LOST');

/** What a worker can be asked for: the answer's plain part, of an opened job. */
const METHODS = {
  load: async ({ source }) => source.facts,
  derive: async ({ source }) => source.facts,
  render: async ({ renderer, source, shots, options, parts }) => packPicture(await renderer.render(source, shots[0], options), parts),
  renderAll: async ({ renderer, source, shots, options, settled, parts }) => {
    const images = await renderer.renderAll(source, shots, { ...options, settled });
    if (!settled) return images.map((image) => packPicture(image, parts));
    return images.map(({ value, reason }) => (value ? { value: packPicture(value, parts) } : { reason: toTelarError(reason).toJSON() }));
  },
  renderQuantity: async ({ renderer, source, shots, options, quantity, parts }) => {
    const { width, height, data } = await renderer.renderQuantity(source, shots[0], quantity, options);
    parts.push(Buffer.from(data.buffer, data.byteOffset, data.byteLength));
    return { width, height };
  },
  factsOf: ({ renderer, source, shots, options }) => renderer.factsOf(source, shots[0], options),
  inspect: ({ source, shots, options, args, limits }) => inspect(source, { ...options, ...args[0], shot: shots[0], limits }),
  compare: async (job) => (await import('./compare_job.mjs')).compareJob(job),
  sheet: async (job) => (await import('./sheet_job.mjs')).sheetJob(job),
  measure: ({ source, args, signal }) => source.measure({ ...args[0], signal }),
  rangesAlong: ({ source, args, signal }) => source.rangesAlong(args[0], { ...args[1], signal }),
  flat: async ({ source, shots, args, signal }) => packFlat(await source.flat(shots[0], { ...args[0], signal })),
};

/** The jobs of one worker: one at a time, and the models that it has loaded. */
export class ChildJobs {
  #renderer;
  #limits;
  #bound;
  #answer;
  #isSpoiled;
  #models = new Map();
  #running;
  #glObjects = 0;
  #asked = new Map();

  /**
   * @param {import('../index.js').Renderer} renderer
   * @param {{outputBytes: number, limits: Record<string, number>}} bound limits: of models and pictures
   * @param {object} ends
   * @param {(message: object, parts?: Buffer[]) => void} ends.answer
   * @param {() => boolean} ends.isSpoiled whether an allocation of this process has failed
   */
  constructor(renderer, { limits, ...bound }, { answer, isSpoiled }) {
    this.#renderer = renderer;
    this.#limits = limits;
    this.#bound = bound;
    this.#answer = answer;
    this.#isSpoiled = isSpoiled;
  }

  /** A message of the parent: {job}, {cancel}, {part} or {forget}. */
  take({ job, cancel, part, forget }, parts) {
    if (forget) this.#forget(forget);
    if (job) void this.#run(job, parts);
    if (cancel !== undefined && this.#running?.id === cancel) this.#running.scope.abort();
    if (part) this.#give(part, parts);
  }

  async #run(job, given) {
    const scope = new AbortController();
    this.#running = { id: job.id, scope };
    const parts = [];
    try {
      if (job.folder !== undefined && job.folder !== process.cwd()) process.chdir(job.folder);
      const value = await METHODS[job.method](await this.#open(job, given, parts, scope.signal));
      const bytes = parts.reduce((sum, { byteLength }) => sum + byteLength, 0);
      if (bytes > this.#bound.outputBytes) throw overOutput(this.#bound.outputBytes, bytes);
      this.#end(job.id, { value }, parts);
    } catch (error) {
      this.#end(job.id, { error: toTelarError(error).toJSON() });
    } finally {
      this.#running = undefined;
      this.#asked.clear();
    }
    await this.#tellObjects();
  }

  /** How many GL names are alive after a job, where they are more or fewer than before: `pool.workers` shows it. A renderer that has ended has none to tell. */
  async #tellObjects() {
    const glObjects = await this.#renderer.liveObjects().catch(() => this.#glObjects);
    if (glObjects === this.#glObjects) return;
    this.#glObjects = glObjects;
    this.#answer({ glObjects });
  }

  /** Nothing of what comes after a failed allocation is told: GL drivers go on without looking, and parsers call it a fault of the file. */
  #end(id, outcome, parts) {
    if (!this.#isSpoiled()) this.#answer({ done: id, ...outcome, ...(hasLostContext(outcome) && { isSpoiled: true }) }, parts);
    else this.#answer({ done: id, error: outcome.error?.kind === 'memory' ? outcome.error : untrusted().toJSON(), isSpoiled: true });
  }

  /** A job's model, shots and options as the renderer takes them. */
  async #open(job, given, parts, signal) {
    const onProgress = job.progress ? (part) => this.#answer({ progress: part, of: job.id }) : undefined;
    const loading = (how) => ({ ...loadingOf(how), signal, ...(how.resolve && { resolve: (uri) => this.#ask(job.id, uri) }) });
    const inputOf = ({ path, part }) => path ?? given[part];
    const source = job.model ? await this.#modelOf(job.model, given, loading) : inputOf(job.input);
    const others = Object.fromEntries((job.others ?? []).map(([name, input]) => [name, inputOf(input)]));
    if (job.model) this.#answer({ beat: job.id });
    const onPreview = job.preview ? (preview) => this.#preview(job.id, preview) : undefined;
    const asked = { ...(onProgress && { onProgress }), ...(onPreview && { onPreview }), ...(job.reached && { reached: true }) };
    const options = job.loading && { ...loading(job.loading), ...asked };
    const shots = job.shots?.map((shot) => shotOf(shot, given));
    const { settled, quantity, args } = job;
    return { renderer: this.#renderer, limits: this.#limits, source, others, shots, options, settled, quantity, args, parts, signal };
  }

  #preview(of, { data, ...preview }) {
    if (!this.#isSpoiled()) this.#answer({ preview, of }, [data]);
  }

  /** A model that is held, or one that is loaded as it was the first time, or made of another. */
  async #modelOf({ id, input, loading, from, step, sha256 }, given, options) {
    if (this.#models.has(id)) return this.#models.get(id);
    const made = from ? this.#stepFrom(await this.#modelOf(from, given, options), step, options) : this.#load(input, given, options(loading));
    const model = await made;
    if (sha256 !== undefined && model.facts.sha256 !== sha256) {
      throw new TelarError('E_FILE', 'the model was loaded before, and its file or a part of it has changed since; load it again');
    }
    this.#models.set(id, model);
    return model;
  }

  #load(input, given, options) {
    return this.#renderer.load(input.path ?? given[input.part], options);
  }

  #stepFrom(model, { method, args, timeoutMs }, options) {
    const { signal } = options({});
    const last = { ...args.at(-1), timeoutMs, signal };
    return model[method](...args.slice(0, -1), last);
  }

  /** The caller's `resolve`, which is in the parent. */
  #ask(of, uri) {
    return new Promise((resolve, reject) => {
      const id = this.#asked.size;
      this.#asked.set(id, { resolve, reject });
      this.#answer({ ask: id, of, uri });
    });
  }

  #give({ id, of, absent, error }, [bytes]) {
    if (this.#running?.id !== of) return;
    const { resolve, reject } = this.#asked.get(id);
    if (error) reject(fromNative(error));
    else resolve(absent ? null : (bytes ?? Buffer.alloc(0)));
  }

  #forget(ids) {
    for (const id of ids) {
      const model = this.#models.get(id);
      this.#models.delete(id);
      // No news if it fails: the next frame says what is wrong with the renderer.
      if (model) this.#renderer.release(model).catch(() => {});
    }
  }
}
