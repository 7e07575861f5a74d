import type { PartFact } from '../shot/index.js';
import type { Quantity, ResolvedShot, Shot } from '../shot/shot.js';
import type { ModelFacts } from './facts.js';
import type { Backend, Limits, LoadOptions, LoadingOptions, Source } from './loading.js';
import type { Model } from './model.js';
import type { DrawAllOptions, GrowingOptions, Image, SettledImage } from './picture.js';

export interface RendererOptions extends LoadingOptions {
  /**
   * Which GL draws. "auto" takes the first that works: "egl-device" (GPU, else software), "egl-surfaceless", "osmesa" (software).
   * @default 'auto'
   */
  backend?: 'auto' | Backend;
  /**
   * Folder of prefiltered environments and of ambient visibility, named by SHA-256, and of the shaders that workers of a pool compile; null = none.
   * @default telar's folder in the user's cache
   */
  cacheDirectory?: string | null;
  /**
   * Bytes that the folder may hold. The files that were used longest ago are deleted first.
   * @default 268435456
   */
  cacheBytes?: number;
  /**
   * What an input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
  /**
   * Jobs that may wait for a turn. One more rejects with X_BUSY.
   * @default 1024
   */
  maxWaiting?: number;
  /**
   * Compiles every feature into every shader. For benchmarks.
   * @default false
   */
  allFeatures?: boolean;
  /**
   * Stops the opening of the context.
   * @default undefined
   */
  signal?: AbortSignal;
}

/**
 * One GL context on a thread of its own. All methods reject with a TelarError, or with the signal's reason.
 *
 * `source` is a path, a file: URL, the bytes of a file, or a loaded model. `shot` says what to draw; js/docs/options.md lists its keys.
 */
export interface Renderer {
  /** Which GL gave the context. */
  readonly backend: Backend;
  /** Strings of the context: vendor, renderer, version, ... */
  readonly gl: Record<string, unknown>;

  /**
   * Loads a model once, to draw it many times. It is freed with the last reference to it.
   * @param source - Path, file: URL or bytes of a .glb or .gltf.
   * @param options - failOn, resolve, timeoutMs, ambientVisibility, signal.
   * @throws {TelarError} E_* and L_* of the file, X_TIMEOUT, X_BUSY, X_CLOSED
   * @example
   * const model = await renderer.load('shirt.glb', { failOn: 'warning' });
   * console.log(model.facts.size, model.facts.variants);
   */
  load(source: Source, options?: LoadOptions): Promise<Model>;

  /**
   * Draws one picture.
   * @param source - A loaded model, or what load() takes.
   * @param shot - What to draw; {} is the front view, 512 by 512 pixels, as PNG.
   * @param options - onProgress, failOn, resolve, timeoutMs, ambientVisibility, signal.
   * @returns The encoded file and what is known of the picture.
   * @throws {TelarError} E_SHOT, and what load() throws
   * @example
   * const shot: Shot = { size: { width: 800, height: 800 }, camera: { view: 'back' }, output: { format: 'webp' } };
   * const { data, info } = await renderer.render('shirt.glb', shot, { timeoutMs: 5000 });
   * await writeFile('shirt.webp', data);
   * console.log(info.milliseconds.total, info.warnings);
   */
  render(source: Source | Model, shot?: Shot | ResolvedShot, options?: GrowingOptions): Promise<Image>;

  /**
   * Draws several pictures of one model. While one is drawn, the one before is encoded.
   * @param shots - One each picture; the result has their order.
   * @param options - settled, onProgress, failOn, resolve, timeoutMs, ambientVisibility, signal.
   * @throws {TelarError} Of the first shot that fails, with its `index`. With `settled` it rejects only where no shot can be drawn:
   *   the model, the signal, onProgress.
   * @example
   * const shots: Shot[] = [{ camera: { view: 'front' } }, { camera: { view: 'back' } }];
   * const images = await renderer.renderAll('shirt.glb', shots, { onProgress: (part) => console.log(`${100 * part} %`) });
   * for (const outcome of await renderer.renderAll('shirt.glb', shots, { settled: true })) {
   *   if (outcome.status === 'rejected') console.error(outcome.reason.index, outcome.reason.message);
   * }
   */
  renderAll(source: Source | Model, shots: ReadonlyArray<Shot | ResolvedShot>, options?: DrawAllOptions & { settled?: false }): Promise<Image[]>;
  renderAll(source: Source | Model, shots: ReadonlyArray<Shot | ResolvedShot>, options: DrawAllOptions & { settled: true }): Promise<SettledImage[]>;

  /**
   * Draws a quantity of the shading in place of the colour. It shows what a picture is made of: to find the cause of a difference, or
   * to mask parts of it. Not for quality "high", which draws in several passes.
   * @param options - failOn, resolve, timeoutMs, ambientVisibility, signal.
   * @returns RGBA, top row first; alpha 0 where nothing is drawn
   * @throws {TelarError} E_OPTION, and what render() throws
   * @example
   * const { width, height, data } = await renderer.renderQuantity('shirt.glb', {}, 'baseColor');
   * console.log(width * height * 4 === data.length);
   */
  renderQuantity(source: Source | Model, shot: Shot | ResolvedShot, quantity: Quantity, options?: LoadOptions): Promise<{ width: number; height: number; data: Float32Array }>;

  /**
   * What resolveShot() needs to know of a model for a shot: its facts in the shot's pose, bounds and outline without what its `ghost`
   * leaves out, and the extent of the part that the shot frames. render() resolves a shot with it.
   * @param options - failOn, resolve, timeoutMs, ambientVisibility, signal.
   * @throws {TelarError} What load() throws, E_SHOT
   * @example
   * const shot: Shot = { pose: { animation: 'walk', time: 0.5 } };
   * const resolved = resolveShot(shot, await renderer.factsOf('person.glb', shot));
   */
  factsOf(source: Source | Model, shot?: Shot | ResolvedShot, options?: LoadOptions): Promise<ModelFacts & { part?: PartFact }>;

  /**
   * Frees what the GPU holds of a model. The next drawing of it uploads it again.
   * @throws {TelarError} E_OPTION, X_CLOSED
   * @example
   * await renderer.release(model);
   */
  release(model: Model): Promise<void>;

  /**
   * Counts the GL names in the context: a leak would raise it.
   * @example
   * console.log(await renderer.liveObjects());
   */
  liveObjects(): Promise<number>;

  /**
   * Finishes what was asked for, then frees the context and its thread. `await using` calls it.
   * @example
   * await renderer.close();
   */
  close(): Promise<void>;
  [Symbol.asyncDispose](): Promise<void>;
}

/**
 * Opens a GL context on a thread of its own.
 * @param options - See RendererOptions.
 * @throws {TelarError} E_OPTION, X_NATIVE_MISSING, X_GL
 * @example
 * await using renderer = await createRenderer({ backend: 'auto', limits: { L_FILE_BYTES: 50e6 }, maxWaiting: 100 });
 */
export function createRenderer(options?: RendererOptions): Promise<Renderer>;
