import { TelarError, toTelarError } from '../error/index.mjs';
import { checkQuantity, checkShots, ofShot, quantityShot } from './draw_request.mjs';
import { refuseWarnings } from './fail_on.mjs';
import { Gate } from './gate.mjs';
import { frameInfo, shotWarnings } from './frame_info.mjs';
import { LastUse } from './last_use.mjs';
import { hasLongShot, isLongShot } from './long_shot.mjs';
import { nativeCall } from './native_call.mjs';
import { identityOf, keyOfDrawn } from './picture_key.mjs';
import { drawAllOptions, growingOptions, loadOptions, rendererOptions, STRICT, wrongOption } from './options.mjs';
import { inScope, untilEnough } from './scope.mjs';
import { Work } from './work.mjs';
import { shotJson } from './shot_json.mjs';
import { readShot, readSource } from './source.mjs';
import { Model, SharedModels, loadModel, measuredFor, shownModel, goalModule, meteringModule, qualityModule, shotModule } from './model.mjs';
import { loadNative } from './native.mjs';
import { BegunLoad, openingRequest } from './opening.mjs';
import { calibrationOf } from './calibration.mjs';
import { versions } from './versions.mjs';

/** Frames on their way at once: one is drawn while others load or are encoded. More would only hold memory. */
const FRAMES_IN_FLIGHT = 4;

/** Of a picture in the format raw with 32 bits a channel; a copy, as its bytes need not lie on a boundary of 4. */
const floatsOf = (data) => new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength));

/** Whether the shot is exposed by its picture: a flat has no light, and a quantity no exposure. */
const isMetered = ({ metering, style }, quantity) => metering !== null && style !== 'flat' && !quantity;

/** js/api/renderer.d.ts documents the public methods. */
class Renderer {
  #native;
  #handle; // a promise: what is asked of the GL waits until it is open
  #limits;
  #loading;
  #gate;
  #cloths = new Map();
  #cache;
  #machine;
  #pending = new Set();
  #closed;

  constructor(native, opening, { limits, loading, maxWaiting, cacheDirectory, cacheBytes }) {
    this.#native = native;
    this.#handle = opening.then(({ renderer, facts }) => {
      const { backend, ...gl } = JSON.parse(facts);
      this.backend = backend;
      this.gl = Object.freeze(gl);
      return renderer;
    });
    this.#limits = limits;
    this.#loading = loading;
    this.#cache = { directory: cacheDirectory, bytes: cacheBytes };
    this.#gate = new Gate(FRAMES_IN_FLIGHT, maxWaiting);
  }

  /** @internal */
  static beginLoad(renderer, source, signal) {
    const loading = renderer.#loading;
    const work = renderer.#begin(signal, loading);
    const input = readSource(renderer.#native, source, renderer.#maxBytes);
    return new BegunLoad(renderer.#track(renderer.#load(input, { ...loading, decodesLater: true }, work)), work);
  }

  /** Resolves when the GL is open, rejects where it does not open. @internal */
  static async opened(renderer) {
    await renderer.#handle;
  }

  get #maxBytes() {
    return this.#limits.L_FILE_BYTES ?? this.#native.limits.L_FILE_BYTES;
  }

  async load(source, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    const input = readSource(this.#native, source, this.#maxBytes);
    const work = this.#begin(signal, loading);
    return this.#track(this.#gate.run(() => this.#load(input, loading, work), signal));
  }

  async render(source, shot = {}, options = {}) {
    this.#assertOpen();
    const { signal, onProgress, onPreview, enough, reached, ...loading } = growingOptions(options, this.#loading);
    const request = { ...this.#readRequest(source, shot), loading, enough, reached };
    const begin = (scope) => request.begun?.work.under(this.#native, scope) ?? this.#begin(scope, loading);
    if (!onProgress && !onPreview) return this.#track(this.#gate.run(() => this.#render(request, begin(signal)), signal));
    return this.#track(
      inScope(signal, { onProgress, onPreview }, 1, (scope, report) => this.#gate.run(() => this.#render(request, begin(scope), report), scope)),
    );
  }

  async renderQuantity(source, shot, quantity, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    checkQuantity(quantity);
    const request = this.#readRequest(source, quantityShot(shot));
    const { data, info } = await this.#track(this.#gate.run(() => this.#render({ ...request, loading, quantity }, this.#begin(signal, loading)), signal));
    return { width: info.width, height: info.height, data: floatsOf(data) };
  }

  async renderAll(source, shots, options = {}) {
    this.#assertOpen();
    const { signal, onProgress, settled, ...loading } = drawAllOptions(options, this.#loading);
    checkShots(shots);
    const input = this.#readInput(source);
    const requests = shots.map((shot, job) => this.#readShotOf(shot, job, settled));
    const all = { requests, settled, loading };
    return this.#track(inScope(signal, { onProgress }, shots.length, (scope, report) => this.#renderAll(input, all, scope, report)));
  }

  async factsOf(source, shot = {}, options = {}) {
    this.#assertOpen();
    const { signal, ...loading } = loadOptions(options, this.#loading);
    const { input, model } = this.#readInput(source);
    const work = this.#begin(signal, loading);
    return this.#track(
      this.#gate.run(async () => {
        const loaded = model ?? (await this.#load(input, loading, work));
        return measuredFor(this.#native, await shownModel(this.#native, loaded, shot, { work, forget: !model, cloths: this.#cloths }), shot, work);
      }, signal),
    );
  }

  async release(model) {
    this.#assertOpen();
    if (!Model.isModel(model)) throw wrongOption('model', 'a loaded model', model);
    await this.#releaseScene(model);
  }

  async liveObjects() {
    this.#assertOpen();
    return this.#track(nativeCall(this.#native, undefined, async () => (await this.#handle).liveObjects()));
  }

  close() {
    this.#closed ??= this.#close();
    return this.#closed;
  }

  [Symbol.asyncDispose]() {
    return this.close();
  }

  async #close() {
    while (this.#pending.size > 0) await Promise.allSettled(this.#pending);
    const handle = await this.#handle.catch(() => undefined);
    if (handle) await nativeCall(this.#native, undefined, () => handle.close());
  }

  #assertOpen() {
    if (this.#closed) throw new TelarError('X_CLOSED', 'the renderer was closed; make a new one with createRenderer()');
  }

  #load(input, loading, work) {
    return loadModel(this.#native, input, this.#limits, { ...loading, work, cache: this.#cache });
  }

  /** Makes close() wait for a job. */
  async #track(job) {
    this.#pending.add(job);
    try {
      return await job;
    } finally {
      this.#pending.delete(job);
    }
  }

  /** One piece of work: of its loading, posing and drawing. */
  #begin(signal, { timeoutMs }) {
    return new Work(this.#native, signal, timeoutMs);
  }

  #readInput(source) {
    if (source instanceof BegunLoad) return { begun: source };
    return Model.isModel(source) ? { model: source } : { input: readSource(this.#native, source, this.#maxBytes) };
  }

  #readRequest(source, shot) {
    return { ...this.#readInput(source), ...readShot(this.#native, shot, this.#maxBytes) };
  }

  /** @returns {object} of readShot; {failure} of a shot that is wrong, where the others are drawn */
  #readShotOf(shot, job, settled) {
    try {
      return readShot(this.#native, shot, this.#maxBytes);
    } catch (error) {
      if (settled) return { failure: error };
      throw ofShot(error, job);
    }
  }

  async #renderAll({ input, model }, { requests, settled, loading }, signal, report) {
    const begin = () => this.#begin(signal, loading);
    const shots = requests.filter(({ failure }) => !failure).map(({ shot }) => shot);
    // Of what several need each may take what the longest of them may.
    const isLong = await hasLongShot(shots);
    const beginShared = () => {
      const work = begin();
      if (isLong) work.allowLong();
      return work;
    };
    let loaded = model;
    try {
      loaded ??= await this.#gate.run(() => this.#load(input, loading, beginShared()), signal);
      const shared = new SharedModels(this.#native, loaded, shots, () => ({ work: beginShared(), cloths: this.#cloths }));
      const draw = async ({ failure, ...request }, job) => {
        try {
          if (failure) throw failure;
          return await this.#gate.run(() => this.#render({ ...request, loading, model: loaded, shared, job }, begin(), report), signal);
        } catch (thrown) {
          report?.finish(job);
          throw ofShot(settled ? toTelarError(thrown) : thrown, job);
        }
      };
      return await (settled ? Promise.allSettled(requests.map(draw)) : Promise.all(requests.map(draw)));
    } finally {
      // Not waited for, and no news if it fails: the frames have said what is wrong with the renderer.
      if (!model && loaded) this.#releaseScene(loaded, true).catch(() => {});
    }
  }

  /** After the frames that wait in the queue; close() waits for it. */
  #releaseScene(model, forget = false) {
    return this.#track(nativeCall(this.#native, undefined, async () => (await this.#handle).release(Model.sceneOf(model), forget)));
  }

  async #render({ input, begun, model: given, loading, ...request }, work, report) {
    const { shot, shared } = request;
    const start = begun?.start ?? performance.now();
    // What is asked for tells: a goal may come to settings of one pass.
    if (await isLongShot(shot)) work.allowLong();
    const model = given ?? (await (begun?.model ?? this.#load(input, { ...loading, decodesLater: true }, work)));
    const loaded = performance.now();
    const shown = await (shared ? shared.of(shot) : shownModel(this.#native, model, shot, { work, forget: !given, cloths: this.#cloths }));
    const times = { start, load: loaded - start, pose: performance.now() - loaded };
    const use = new LastUse(() => (shared ? shared.isLast(shot) : !given || shown !== model));
    try {
      return await this.#draw({ ...request, shown, sha256: model.facts.sha256, loading, times, use }, work, report);
    } finally {
      if (use.isLeft()) this.#releaseScene(shown, true).catch(() => {});
    }
  }

  async #draw({ shown, sha256, loading, times, use, job = 0, shot, environment, map, quantity, enough, reached }, work, report) {
    const shownAt = performance.now();
    const scene = Model.sceneOf(shown);
    const { resolved, seen, warnings, metered, goal, end } = await this.#resolve({ shot, quantity, environment, map }, shown, loading, work);
    const { endBy, reachedBy } = goal ? await goalModule() : {};
    const measures = reached && goal?.maxError !== undefined;
    const resolvedAt = performance.now();
    const drawing = nativeCall(this.#native, work, async (token) => {
      const handle = await this.#handle;
      report?.begin(job, token);
      endBy?.(end, token);
      const stopListening = enough && untilEnough(enough, token);
      const request = { scene, shot: shotJson(quantity ? { ...seen, debugOutput: quantity } : seen), environment, releaseScene: !measures && use.end() };
      return handle.render(request, token).finally(stopListening);
    });
    // While it is drawn, this thread has nothing else to do.
    const [frame, identity] = await Promise.all([drawing, identityOf(shot)]);
    report?.finish(job);
    const ended = goal || enough?.aborted ? JSON.parse(frame.info).ended : undefined;
    // Nothing ends the pictures of its window.
    if (measures) goal.reached = await reachedBy(this.#native, seen, ended, this.#lookAt({ scene, environment }, work));
    const key = await keyOfDrawn(this.#native, {
      version: versions.telar,
      model: sha256,
      identity,
      environment,
      drawn: frame.environmentSha256,
      limits: this.#limits,
      // Where an error ended it, the goal alone says when.
      ended: enough?.aborted || goal?.budgetMs !== undefined ? ended : undefined,
    });
    const { start, load, pose } = times;
    const milliseconds = { load, pose, resolve: resolvedAt - shownAt, total: performance.now() - start };
    const info = frameInfo({ frame, resolved, milliseconds, renderer: this, key, warnings, metered, goal });
    refuseWarnings(loading.failOn, info.warnings);
    const layers = Object.keys(frame.layers).length > 0 && { layers: frame.layers };
    return { data: frame.data, ...layers, info };
  }

  /** The factor of the shot's `metering`, by a small picture of the model alone. @throws {TelarError} */
  async #meter(resolved, { scene, environment }, work) {
    const { meteredExposure, meteringShot } = await meteringModule();
    const request = { scene, shot: shotJson(meteringShot(resolved)), environment, releaseScene: false };
    const { data } = await nativeCall(this.#native, work, async (token) => (await this.#handle).render(request, token));
    return meteredExposure(resolved, floatsOf(data));
  }

  /**
   * The shot with every default, and what is known to be wrong before it is drawn. `seen`: the same as it is drawn, with the metered exposure.
   * @throws {TelarError} E_SHOT, E_WARNING, ...
   */
  async #resolve({ shot, quantity, environment, map }, shown, loading, work) {
    const { resolveShot } = await shotModule();
    const resolved = resolveShot(shot, await measuredFor(this.#native, shown, shot, work));
    if (map) resolved.environment.map = map;
    const metered = isMetered(resolved, quantity) ? await this.#meter(resolved, { scene: Model.sceneOf(shown), environment }, work) : undefined;
    const exposed = (of) => (metered === undefined ? of : { ...of, exposure: of.exposure * metered });
    // A dark window would hide errors that the picture shows.
    const goal = await this.#aim(exposed(resolved), { quantity, environment }, shown, work);
    if (goal) resolved.quality = goal.quality;
    const warnings = [...(shown.facts.warnings ?? []), ...(goal?.warnings ?? []), ...shotWarnings(resolved, shown.facts.extensionsUsed)];
    refuseWarnings(loading.failOn, warnings);
    return { resolved, seen: exposed(resolved), warnings, metered, goal: goal?.told, end: goal?.end };
  }

  /** Settings in place of a goal. @returns {Promise<{quality: object, told?: object, warnings?: object[], end?: object} | undefined>} undefined of other qualities */
  async #aim(resolved, { quantity, environment }, shown, work) {
    const { isGoal, resolveQuality } = await qualityModule();
    if (!isGoal(resolved.quality)) return undefined;
    // Neither has an error to reach.
    if (quantity || resolved.style === 'flat') return { quality: resolveQuality('standard') };
    const { goalWarnings, settingsFor } = await goalModule();
    const scene = Model.sceneOf(shown);
    const draw = this.#lookAt({ scene, environment }, work);
    const request = { resolved, scene, facts: shown.facts, limits: this.#limits, machine: () => this.#calibration(), draw };
    const { quality, goal, end } = await settingsFor(this.#native, request, work);
    return { quality, told: goal, warnings: goalWarnings(goal), end };
  }

  /**
   * Draws resolved shots of a scene for a look at their pixels, in the time of the picture: RGBA. How far they are is not how far the picture is, and what is enough of
   * that does not end them.
   */
  #lookAt({ scene, environment }, work) {
    const look = work.beside(this.#native);
    return async (shot) => {
      const request = { scene, shot: shotJson(shot), environment, releaseScene: false };
      return (await nativeCall(this.#native, look, async (token) => (await this.#handle).render(request, token))).data;
    };
  }

  /** How fast this machine draws. Its pictures go past the gate: the frame that waits for them has its place there. */
  #calibration() {
    this.#machine ??= (async () => {
      const { calibrate, hasTracer } = await goalModule();
      const draw = (source, shot) => this.#render({ ...this.#readRequest(source, shot), loading: STRICT }, this.#begin(undefined, { timeoutMs: null }));
      const has = { tracer: await hasTracer(this.#native) };
      return calibrationOf(this.#cache.directory, String(this.gl.renderer), has, () => calibrate(draw, has));
    })().catch((error) => {
      this.#machine = undefined;
      throw error;
    });
    return this.#machine;
  }
}

/** Opens a GL context. js/api/renderer.d.ts documents it, its options and the methods of Renderer. */
export async function createRenderer(options = {}) {
  return createRendererOn(loadNative(), options);
}

/**
 * The same on given exports of an addon.
 * @internal
 */
export async function createRendererOn(native, options = {}) {
  const renderer = begunRenderer(native, options);
  await Renderer.opened(renderer);
  return renderer;
}

/**
 * A renderer whose GL is not open yet: models are loaded beside that; pictures wait for it, and fail where it does not open.
 * @internal
 * @param {object} [options] of createRenderer
 * @param {object} [native] the addon's exports
 * @returns {{renderer: Renderer, opened: Promise<void>, beginLoad: (source: string, signal?: AbortSignal) => object}} opened: rejects where createRenderer()
 *   would; beginLoad: loads a source while its shot is still being read, for one call of render(), which takes what it gives in place of the source
 * @throws {TelarError} X_NATIVE_MISSING, E_OPTION
 */
export function beginRenderer(options = {}, native = loadNative()) {
  const renderer = begunRenderer(native, options);
  return { renderer, opened: Renderer.opened(renderer), beginLoad: (source, signal) => Renderer.beginLoad(renderer, source, signal) };
}

function begunRenderer(native, options) {
  const { signal, ...rest } = rendererOptions(options, Object.keys(native.limits));
  const request = openingRequest(rest);
  const closeLate = ({ renderer }) => void renderer.close();
  // Beside the context, so that the first frame need not wait for it. A failure is the first frame's to report.
  shotModule().catch(() => {});
  const opening = nativeCall(native, { signal }, (token) => native.createRenderer(request, token), closeLate);
  return new Renderer(native, opening, rest);
}
