import type { TelarError } from './error/index.js';
import type { AnimationFact, CameraFact, PartFact, Vec3 } from './shot/index.js';
import type { ResolvedShot, Shot } from './shot/shot.js';

export type { AnimationFact, CameraFact, ResolvedShot, Shot, Vec3 };
export type { Box, PartFact, ShotFacts } from './shot/index.js';

export { TelarError, toTelarError } from './error/index.js';
export type { ErrorCode, ErrorKind, LimitFact, PlainError } from './error/index.js';

export type Backend = 'egl-device' | 'egl-surfaceless' | 'osmesa';

/** What an input may cost; js/docs/errors.md lists the L_* names. */
export type Limits = Partial<Record<`L_${string}`, number>>;

/** A path, a file: URL, or the bytes of a .glb or .gltf. */
export type Source = string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer;

/**
 * Gives the files that a model names. `uri` is the model's own relative reference, percent-decoded: schemes, absolute paths and ".." are
 * refused before it is asked. null or undefined: there is no such file. `signal` is that of the call.
 */
export type Resolve = (uri: string, options: { signal?: AbortSignal }) => ResolvedBytes | Promise<ResolvedBytes>;
export type ResolvedBytes = ArrayBufferView | ArrayBuffer | SharedArrayBuffer | null | undefined;

export interface LoadingOptions {
  /**
   * "error": what cannot be drawn as the file says is an error. "warning": so is any warning (E_WARNING). "none": a texture that is missing,
   * denied or damaged, and an unknown extension that the model requires, are warnings (W_TEXTURE, W_EXT_REQUIRED), and the picture is what
   * three.js shows without them. A loaded model keeps what it was loaded with.
   * @default 'error', or the renderer's
   */
  failOn?: 'error' | 'warning' | 'none';
  /**
   * In place of files beside the model, of which none is opened then. Limits apply to what it gives; what it throws is the cause of an X_RESOLVE.
   * @default none, or the renderer's
   */
  resolve?: Resolve;
  /**
   * Milliseconds that the work on one image may take, its loading included, before it ends with X_TIMEOUT; null for any
   * time. Of renderAll each image has as much, and so has the loading. Waiting for a turn does not count. Where neither
   * the call nor the renderer says it, quality "high", "reference" and all with more than 4 samples draw for any time.
   * @default 20000, or the renderer's
   */
  timeoutMs?: number | null;
}

export interface RendererOptions extends LoadingOptions {
  /** @default 'auto' */
  backend?: 'auto' | Backend;
  /** Where prefiltered environments are kept by content hash; default telar's folder in the user's cache, null = nowhere. */
  cacheDirectory?: string | null;
  /** Bytes of what is kept there; what was used longest ago goes first. @default 268435456 */
  cacheBytes?: number;
  limits?: Limits;
  /** Jobs that may wait; one more rejects with X_BUSY. @default 1024 */
  maxWaiting?: number;
  /** Every feature in every shader: for benchmarks. @default false */
  allFeatures?: boolean;
  signal?: AbortSignal;
}

export interface CallOptions {
  signal?: AbortSignal;
}

export interface LoadOptions extends CallOptions, LoadingOptions {}

export interface DrawOptions extends LoadOptions {
  /**
   * Called with 0..1, never falling, and with 1 when all is done: row by row for quality "reference", once a frame for the
   * others. What it throws cancels the work and rejects the promise.
   */
  onProgress?: (part: number) => void;
}

export interface DrawAllOptions extends DrawOptions {
  /** Draw the other shots where one fails, and give each its outcome, as of Promise.allSettled. @default false */
  settled?: boolean;
}

/** Outcome of one shot; `reason.index` says which. */
export type SettledImage = { status: 'fulfilled'; value: Image } | { status: 'rejected'; reason: TelarError };

export interface Warning {
  code: string;
  message: string;
  /** JSON pointer into the glTF. */
  pointer?: string;
}

/** What is in a model file. */
export interface ModelFacts {
  name: string;
  /** Metres, world space; null when there is nothing to draw. */
  bounds: { min: Vec3; max: Vec3 } | null;
  /** Width, height, depth in metres. */
  size: Vec3;
  nodes: number;
  meshes: number;
  drawCalls: number;
  vertices: number;
  triangles: number;
  fileBytes: number;
  /** Of the file and of the external parts that it names: 64 hex digits. */
  sha256: string;
  materials: Array<{
    name: string;
    alphaMode: 'OPAQUE' | 'MASK' | 'BLEND';
    doubleSided: boolean;
    unlit: boolean;
    metallic: number;
    roughness: number;
    textures: string[];
    /** What only the shading "fabric" reads, with the material's preset (js/docs/fabric.md); null where there is nothing. */
    fabric: {
      diffuseTransmission?: number;
      flatness?: number;
      /** Coverages, and yarns in one unit of u and v. */
      weave?: { warp: number; weft: number; threadsPerUv: [number, number] };
      back?: true;
    } | null;
  }>;
  /** Width 0: no drawn material uses it, so it was not decoded. */
  images: Array<{
    width: number;
    height: number;
    /** What the file is: "PNG", "KTX2 UASTC zstd". */
    format?: string;
    /** Mip levels that a KTX2 file brings; of other files they are generated. */
    levels?: number;
  }>;
  lights: Array<{
    name: string;
    type: 'directional' | 'point' | 'spot';
    /** Linear Rec.709. */
    color: Vec3;
    intensity: number;
    position: Vec3;
    range: number;
    innerConeAngle?: number;
    outerConeAngle?: number;
  }>;
  cameras: CameraFact[];
  /** In the file's order. */
  animations: AnimationFact[];
  variants: string[];
  extensionsUsed: string[];
  generator: string;
  copyright: string;
  warnings: Warning[];
}

/** What a render compiles and runs. */
export interface Plan {
  features: string[];
  programs: Array<{ features: string[] }>;
  passes: string[];
  /** Of one pass over the picture and its shadow maps, hidden ones too, at most; counting stops beyond L_FRAGMENTS. Of inspect alone. */
  fragments?: number;
}

/** A decoded model: draw many views of it. */
export interface Model {
  readonly facts: ModelFacts;
}

/** What a frame was made of. Native code may add keys. */
export interface FrameInfo extends Plan {
  width: number;
  height: number;
  format: ResolvedShot['output']['format'];
  /** "reference": the path tracer, without GL. */
  backend: Backend | 'reference';
  /** Strings of the GL context. */
  gl: Record<string, unknown>;
  quality: ResolvedShot['quality'];
  /**
   * Of what the picture is made of: the model's bytes and its parts', the environment's, the shot, telar's version. 64 hex
   * digits, fit for an ETag. What pictureKey() gives.
   */
  key: string;
  /** Wall-clock milliseconds of each stage. */
  milliseconds: Record<string, number> & { load: number; pose: number; resolve: number; queue: number; draw: number; encode: number; total: number };
  warnings: Warning[];
  /**
   * What the picture shows of the model, parts 0..1: `coverage` of all pixels; of those that the model covers wholly, `dark`
   * (no channel above 2/255), `bright` (none below 250/255) and `saturated` (each at one of these ends). Left out where the
   * environment is the background in quality "reference" or without perspective. W_EMPTY and W_EXPOSURE go by it.
   */
  picture?: { coverage: number; dark: number; bright: number; saturated: number };
  /** Largest resident memory of the process so far. */
  peakBytes: number;
  /** Column-major 4 x 4: (X, Y, Z, W) = M (x, y, z, 1); the pixel is (X / W, Y / W) from the top left corner. */
  worldToPixel: number[];
  shot: ResolvedShot;
  [key: string]: unknown;
}

export interface Image {
  /** The encoded file. */
  data: Buffer;
  info: FrameInfo;
}

/** n: shading normal in view space; NoV: its cosine with the viewer; dfg: scale and bias of the split sum; colours linear. */
export type Quantity = 'n' | 'baseColor' | 'alpha' | 'metallic' | 'perceptualRoughness' | 'f0' | 'NoV' | 'dfg' | 'radiance' | 'irradiance'
  | 'direct' | 'indirect' | 'transmitted' | 'linear' | 'encoded';

/** One GL context on a thread of its own. All methods reject with TelarError, or with the signal's reason. */
export interface Renderer {
  readonly backend: Backend;
  readonly gl: Record<string, unknown>;
  load(source: Source, options?: LoadOptions): Promise<Model>;
  render(source: Source | Model, shot?: Shot | ResolvedShot, options?: DrawOptions): Promise<Image>;
  /** The first shot that fails ends the others; the error's `index` says which it was. */
  renderAll(source: Source | Model, shots: ReadonlyArray<Shot | ResolvedShot>, options?: DrawAllOptions & { settled?: false }): Promise<Image[]>;
  /** Rejects only where no shot can be drawn: the model, the signal, onProgress. */
  renderAll(source: Source | Model, shots: ReadonlyArray<Shot | ResolvedShot>, options: DrawAllOptions & { settled: true }): Promise<SettledImage[]>;
  /** Draws a quantity of the shading in place of the colour: RGBA, top row first; alpha 0 where nothing is drawn. */
  renderQuantity(source: Source | Model, shot: Shot | ResolvedShot, quantity: Quantity, options?: LoadOptions): Promise<{ width: number; height: number; data: Float32Array }>;
  /** What resolveShot needs to know of a model for this shot: its facts in the shot's pose, and what the part measures that it frames. */
  factsOf(source: Source | Model, shot?: Shot | ResolvedShot, options?: LoadOptions): Promise<ModelFacts & { part?: PartFact }>;
  /** Frees what the GPU holds of a model. */
  release(model: Model): Promise<void>;
  /** Number of GL names that live in the context. */
  liveObjects(): Promise<number>;
  /** Finishes what was asked for, then frees the context. */
  close(): Promise<void>;
  [Symbol.asyncDispose](): Promise<void>;
}

/** @throws {TelarError} E_OPTION, X_NATIVE_MISSING, X_GL */
export function createRenderer(options?: RendererOptions): Promise<Renderer>;

export interface InspectOptions extends LoadOptions {
  shot?: Shot | ResolvedShot;
  limits?: Limits;
}

/** What is in a model, and what a render of it would compile and run; plan is null when there is nothing to draw. */
export function inspect(source: Source, options?: InspectOptions): Promise<ModelFacts & { plan: Plan | null }>;

/**
 * The key that a picture will have as `info.key`, without drawing it or decoding the model: so that a service can answer
 * "not modified", and a batch can leave out what has not changed.
 */
export function pictureKey(source: Source, shot?: Shot | ResolvedShot, options?: { limits?: Limits; resolve?: Resolve; signal?: AbortSignal }): Promise<string>;

/** Light by lobe, linear [r, g, b]; `total` is the sum of the other four. */
export type Lobes = Record<'diffuse' | 'specular' | 'sheen' | 'coat' | 'total', Vec3>;

export interface EvaluateShadingOptions extends CallOptions {
  /** A material as glTF writes it, without textures; or the index of one in `model`. */
  material: object | number;
  model?: Model;
  /** @default 'three' */
  shading?: Shot['shading'];
  /** Radians from the normal towards the tangent, below pi / 2. @default 0 */
  viewAngle?: number;
  /** Unit vectors to the light, at most 65536; z = normal, x = tangent. */
  directions?: ReadonlyArray<Readonly<Vec3>>;
  /** Integrate over all directions too. @default false */
  albedo?: boolean;
}

/**
 * What a material reflects, by lobe, in double and without GL. `radiance`: of each direction, under a light that gives the
 * irradiance 1 on a surface that faces it (the BRDF times the cosine). `albedo`: the share of light from everywhere, by integration.
 * `albedoError`: how far each of its numbers may be from the integral; 999 of 1000 are closer.
 */
export function evaluateShading(options: EvaluateShadingOptions): Promise<{ radiance: Lobes[]; albedo: Lobes | null; albedoError: Lobes | null }>;

export type BackendReport =
  | { backend: Backend; works: true; vendor?: string; renderer?: string; version?: string; software?: boolean }
  | { backend: Backend; works: false; failure: string; cure?: string };

export interface DoctorReport {
  ok: boolean;
  versions: Versions;
  system: string;
  native: { path: string } | { error: import('./error/index.js').PlainError };
  chosen: Backend | null;
  reason: string;
  backends: BackendReport[];
  /** Whether quality "reference" can be drawn. */
  reference: { works: true; version: string } | { works: false; failure: string };
}

/** Which GL backends this machine has, which one is chosen and why, and how to cure a missing one. */
export function doctor(): Promise<DoctorReport>;

export interface Versions {
  telar: string;
  node: string;
  napi: string;
}

export const versions: Readonly<Versions>;
