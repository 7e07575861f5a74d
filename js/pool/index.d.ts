import type { Comparison, GateName, LimitedFigure, Region, Verdict } from '../compare/index.js';
import type {
  DrawAllOptions, Image, InspectOptions, Inspection, IsolationStep, LoadOptions, Model, RenderOptions, Renderer, RendererOptions, SettledImage, Source,
} from '../index.js';
import type { Sheet, SheetOptions, SheetSpec } from '../sheet/index.js';

/** Options of createPool: those of createRenderer, and what a worker may take. */
export interface PoolOptions extends RendererOptions {
  /**
   * Processes that draw, each one job at a time.
   * @default one for each core, as many as fit three quarters of the memory at memoryBytes each
   */
  size?: number;
  /**
   * Resident memory of a worker in bytes. It is looked at every 50 ms; a worker over it is ended, and its job rejects with X_MEMORY.
   * @default 2147483648
   */
  memoryBytes?: number;
  /**
   * Milliseconds of CPU, of all threads, that a job may take before its worker is ended, and it rejects with X_TIMEOUT; null = no bound.
   * @default null
   */
  cpuMs?: number | null;
  /**
   * Bytes of the pictures of a job, all of renderAll together. Over it the job rejects with L_OUTPUT_BYTES.
   * @default 1073741824
   */
  outputBytes?: number;
  /**
   * Milliseconds for which a file that ended a worker is remembered. One that ended two in a row is refused for so long, with X_QUARANTINE; 0 = never.
   * @default 86400000
   */
  quarantineMs?: number;
  /**
   * Jobs after which a worker is replaced by a new one.
   * @default 500
   */
  recycleJobs?: number;
  /**
   * Resident bytes above which a worker is replaced when its job is done; at most half of memoryBytes.
   * @default 838860800
   */
  recycleBytes?: number;
  /**
   * Bytes of loaded models that a worker keeps, about; those that were used longest ago go first, and are loaded again when a job names them.
   * @default 536870912
   */
  modelBytes?: number;
  /**
   * Path of a cgroup in which this process may make others: v2 with the memory controller and without processes of its own, or v1's memory controller. Each
   * worker gets one of its own there, in which the kernel bounds memory to memoryBytes, counting its own for that worker too; over it the worker is ended, and
   * its job rejects with X_MEMORY. null = none: what is resident is looked at, which it is with one too. A cgroup that cannot be used is an E_OPTION.
   * @default null
   */
  cgroup?: string | null;
}

/** A worker, as it is now. */
export interface WorkerFacts {
  pid: number | undefined;
  state: 'starting' | 'idle' | 'busy';
  /** That it was given. */
  jobs: number;
  /** GL names (textures, buffers, programs, ...) that it held after its last job: flat where nothing leaks. */
  glObjects: number;
  /** What it gave up, and what the kernel refused; empty while it starts. */
  isolation: IsolationStep[];
}

/** A model of a pool: the pool keeps its bytes or path, and workers load it when a job names it. Its methods are those of a renderer's models. */
export interface PoolModel extends Pick<Model, 'facts' | 'measure' | 'flat'> {
  /**
   * As Model.swatch(), in a worker.
   * @throws {TelarError} What Model.swatch() throws, X_CRASH
   * @example
   * const jersey = await poolModel.swatch({ part: { material: 'jersey' } });
   * const { data } = await pool.render(jersey, { size: { width: 200, height: 200 } });
   */
  swatch(...args: Parameters<Model['swatch']>): Promise<PoolModel>;
  /**
   * As Model.explode(), in a worker.
   * @throws {TelarError} What Model.explode() throws, X_CRASH
   * @example
   * const apart = await poolModel.explode(0.15);
   */
  explode(...args: Parameters<Model['explode']>): Promise<PoolModel>;
}

/** Options of Pool.compare. */
export interface PoolCompareOptions {
  /**
   * Figures that must not be passed.
   * @default 'standard'
   */
  gate?: GateName;
  /**
   * Limits in place of the gate's or beside them, as {'object.flip.mean': 0.02}.
   * @default {}
   */
  thresholds?: Partial<Record<`${Region}.${LimitedFigure}`, number>>;
  /**
   * Shrink the larger picture to the size of the smaller one.
   * @default false
   */
  resize?: boolean;
  /**
   * Give FLIP of each pixel as a PNG.
   * @default false
   */
  heatMap?: boolean;
  /**
   * Milliseconds that the work may take; null = no bound.
   * @default undefined: the pool's
   */
  timeoutMs?: number | null;
  /**
   * Stops the work. The promise then rejects with the signal's reason.
   * @default undefined
   */
  signal?: AbortSignal;
}

/** What Pool.compare gives. */
export interface PoolComparison {
  /** As of compareImages(), without the pixels of FLIP. */
  comparison: Omit<Comparison, 'flipMap'>;
  verdict: Verdict;
  hints: Array<{ cause: 'background' | 'premultiplied' | 'alpha'; message: string }>;
  /** A PNG, where it is asked for. */
  heatMap?: Buffer;
}

/** Options of Pool.sheet: those of createSheet, but images that the spec names are given as bytes. */
export interface PoolSheetOptions extends Omit<SheetOptions, 'renderer' | 'resolve' | 'limits'> {
  /**
   * Bytes of the images that the spec names, by name.
   * @default undefined: a spec that names an image is refused
   */
  images?: Record<string, Uint8Array>;
  /**
   * Name of the style, where the spec is made from the model.
   * @default ''
   */
  name?: string;
}

/**
 * Workers that draw: processes of their own. All methods take what those of a Renderer take, and give the same, byte for byte. A file that
 * ends a worker ends that one job, with X_CRASH. js/docs/pool.md says what is promised.
 */
export interface Pool {
  /** Which GL gave the contexts. */
  readonly backend: Renderer['backend'];
  /** Strings of the first worker's context. */
  readonly gl: Renderer['gl'];
  /** The workers now. */
  readonly workers: WorkerFacts[];

  /**
   * As Renderer.load(). The model is loaded again in each worker that draws it; a file that has changed meanwhile is an E_FILE.
   * @throws {TelarError} What Renderer.load() throws, X_CRASH, X_MEMORY, X_QUARANTINE, X_WORKERS
   * @example
   * const shirt = await pool.load('shirt.glb');
   * const [front, back] = await Promise.all((['front', 'back'] as const).map((view) => pool.render(shirt, { camera: { view } })));
   */
  load(source: Source, options?: LoadOptions): Promise<PoolModel>;

  /**
   * As Renderer.render(), in a worker.
   * @throws {TelarError} What Renderer.render() throws, X_CRASH, X_MEMORY, X_QUARANTINE, X_WORKERS, L_OUTPUT_BYTES
   * @example
   * const { data, info } = await pool.render('shirt.glb', { size: { width: 512, height: 512 } }, { timeoutMs: 5000 });
   * console.log(data.length, info.warnings);
   */
  render(source: Source | PoolModel, shot?: Parameters<Renderer['render']>[1], options?: RenderOptions): Promise<Image>;

  /**
   * As Renderer.renderAll(): one job of one worker.
   * @throws {TelarError} What Renderer.renderAll() throws, X_CRASH, X_MEMORY, X_QUARANTINE, X_WORKERS, L_OUTPUT_BYTES
   * @example
   * const images = await pool.renderAll('shirt.glb', [{ camera: { view: 'front' } }, { camera: { view: 'back' } }]);
   */
  renderAll(source: Source | PoolModel, shots: Parameters<Renderer['renderAll']>[1], options?: DrawAllOptions & { settled?: false }): Promise<Image[]>;
  renderAll(source: Source | PoolModel, shots: Parameters<Renderer['renderAll']>[1], options: DrawAllOptions & { settled: true }): Promise<SettledImage[]>;

  /**
   * As Renderer.renderQuantity(), in a worker.
   * @throws {TelarError} What Renderer.renderQuantity() throws, X_CRASH
   * @example
   * const { data } = await pool.renderQuantity('shirt.glb', {}, 'baseColor');
   */
  renderQuantity(
    source: Source | PoolModel, shot: Parameters<Renderer['renderQuantity']>[1], quantity: Parameters<Renderer['renderQuantity']>[2], options?: LoadOptions,
  ): ReturnType<Renderer['renderQuantity']>;

  /**
   * As Renderer.factsOf(), in a worker.
   * @throws {TelarError} What Renderer.factsOf() throws, X_CRASH
   * @example
   * const { bounds } = await pool.factsOf('person.glb', { pose: { animation: 'walk', time: 0.5 } });
   */
  factsOf(source: Source | PoolModel, shot?: Parameters<Renderer['factsOf']>[1], options?: LoadOptions): ReturnType<Renderer['factsOf']>;

  /**
   * As inspect(), in a worker.
   * @throws {TelarError} What inspect() throws, X_CRASH, X_MEMORY, X_QUARANTINE, X_WORKERS
   * @example
   * const { triangles, plan } = await pool.inspect('shirt.glb', { shot: { quality: 'high' } });
   */
  inspect(source: Source, options?: Omit<InspectOptions, 'limits'>): Promise<Inspection>;

  /**
   * Decodes two pictures (PNG, JPEG, WebP) in a worker, compares them there, and holds them against a gate.
   * @throws {TelarError} What readImage(), compareImages() and judge() throw, X_CRASH, X_MEMORY, X_TIMEOUT
   * @example
   * const { verdict } = await pool.compare('expected.png', 'actual.png', { gate: 'parity' });
   */
  compare(expected: Source, actual: Source, options?: PoolCompareOptions): Promise<PoolComparison>;

  /**
   * As createSheet(), in a worker: the pages are set there too. Without a spec (null) that of firstSpec() is taken.
   * @throws {TelarError} What createSheet() throws, X_CRASH, X_MEMORY, L_OUTPUT_BYTES
   * @example
   * const { files } = await pool.sheet('shirt.glb', { header: { style: 'TL-01' } });
   * await writeFile('shirt.pdf', files[0]);
   */
  sheet(source: Source | PoolModel, spec: SheetSpec | null, options?: PoolSheetOptions): Promise<Sheet>;

  /**
   * Workers let the model go. The next drawing of it loads it again.
   * @throws {TelarError} E_OPTION, X_CLOSED
   * @example
   * await pool.release(poolModel);
   */
  release(model: PoolModel): Promise<void>;

  /**
   * Finishes what was asked for, then ends the workers. `await using` calls it.
   * @example
   * await pool.close();
   */
  close(): Promise<void>;
  [Symbol.asyncDispose](): Promise<void>;
}

/**
 * Starts workers, and resolves when the first of them is ready.
 * @param options - See PoolOptions.
 * @throws {TelarError} E_OPTION, X_NATIVE_MISSING, X_GL
 * @example
 * await using pool = await createPool({ size: 4, timeoutMs: 10_000, memoryBytes: 1.5 * 2 ** 30 });
 */
export function createPool(options?: PoolOptions): Promise<Pool>;
