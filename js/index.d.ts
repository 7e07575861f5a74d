import type { TelarError } from './error/index.js';
import type { AnimationFact, CameraFact, PartFact, Vec3 } from './shot/index.js';
import type { Quantity, ResolvedShot, Shot } from './shot/shot.js';

export type { AnimationFact, CameraFact, Quantity, ResolvedShot, Shot, Vec3 };
export type { Box, PartFact, ShotFacts } from './shot/index.js';

export { TelarError, toTelarError } from './error/index.js';
export type { ErrorCode, ErrorKind, LimitFact, PlainError } from './error/index.js';

export type Backend = 'egl-device' | 'egl-surfaceless' | 'osmesa';

/** What an input may cost; js/docs/errors.md lists the L_* names. */
export type Limits = Partial<Record<`L_${string}`, number>>;

/** A path, a file: URL, or the bytes of a .glb or .gltf. */
export type Source = string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer;

/**
 * Gives the files that a model names. `uri` is the model's own relative reference, percent-decoded. Schemes, absolute paths and
 * ".." are refused before it is called. null or undefined: there is no such file. `signal` is that of the call.
 * @example
 * const resolve: Resolve = (uri, { signal }) => fetch(`https://models.example/${uri}`, { signal }).then((answer) => answer.arrayBuffer());
 */
export type Resolve = (uri: string, options: { signal?: AbortSignal }) => ResolvedBytes | Promise<ResolvedBytes>;
export type ResolvedBytes = ArrayBufferView | ArrayBuffer | SharedArrayBuffer | null | undefined;

/** How a model is loaded. A call without an option takes the renderer's. */
export interface LoadingOptions {
  /**
   * What makes a call fail.
   * - "error": anything that cannot be drawn as the file says.
   * - "warning": any warning too, as E_WARNING.
   * - "none": a texture that is missing, denied or damaged, and an unknown extension that the model requires, are only warnings
   *   (W_TEXTURE, W_EXT_REQUIRED). The picture is what three.js shows without them.
   *
   * A loaded model keeps what it was loaded with.
   * @default 'error'
   */
  failOn?: 'error' | 'warning' | 'none';
  /**
   * Gives the files that the model names. No file beside the model is opened then. The limits apply to what it gives. What it throws
   * is the cause of an X_RESOLVE.
   * @default undefined: files are read beside the model; a model given as bytes has none
   */
  resolve?: Resolve;
  /**
   * Milliseconds of work on one image, its loading included, before it ends with X_TIMEOUT; null = no bound. Each image of
   * renderAll has its own time, and so has the loading. Time spent waiting for a turn does not count. Where neither the call nor
   * the renderer gives it, quality "high", quality "reference", more than 4 samples and a goal have no bound.
   * @default 20000
   */
  timeoutMs?: number | null;
  /**
   * Finds by rays what each vertex sees of its surroundings, and darkens what the shading "fabric" draws of light from everywhere
   * there: folds, the inside of sleeves (js/docs/visibility.md). In place of what the file says of it. `rays`: of each side of a
   * vertex, 16 to 4096. Needs libembree3-3.
   * @default false: the file's attributes count, where it has them; true stands for { rays: 256 }
   */
  ambientVisibility?: boolean | { rays?: number };
}

export interface RendererOptions extends LoadingOptions {
  /**
   * Which GL draws. "auto" takes the first that works: "egl-device" (GPU, else software), "egl-surfaceless", "osmesa" (software).
   * @default 'auto'
   */
  backend?: 'auto' | Backend;
  /**
   * Folder of prefiltered environments and of ambient visibility, named by SHA-256; null = none.
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

export interface CallOptions {
  /**
   * Stops the work. The promise then rejects with the signal's reason.
   * @default undefined
   */
  signal?: AbortSignal;
}

export interface LoadOptions extends CallOptions, LoadingOptions {}

export interface DrawOptions extends LoadOptions {
  /**
   * Is called with the part that is done, 0..1. It never falls and ends with 1. Quality "reference" tells each row; "high", where the
   * path tracer draws it, each doubling of its paths; the others each frame. What it throws stops the work and rejects the promise.
   * @default undefined
   */
  onProgress?: (part: number) => void;
}

/** A picture as far as it is. */
export interface Preview {
  width: number;
  height: number;
  /** 8: sRGB-encoded, straight alpha. 32: linear floats, premultiplied, for shots whose output has floats. */
  bitDepth: 8 | 32;
  /** That a pixel has taken so far, at most. */
  samples: number;
  /** RGBA without padding, row 0 on top. */
  data: Buffer;
}

export interface RenderOptions extends DrawOptions {
  /**
   * Is called with the picture so far at each doubling of its samples, where it takes more than one pass: more than 4 samples, and the path tracer.
   * One that is overtaken by the next is left out; the finished picture is only returned. The bytes of that stay the same. What it throws stops
   * the work and rejects the promise, as an abort does.
   * @default undefined
   */
  onPreview?: (preview: Preview) => void;
}

export interface GrowingOptions extends RenderOptions {
  /**
   * Ends the work with the best that there is: where it fires, the promise resolves with the picture as it is, of at least one pass or path; `info.ended`
   * tells its samples, and its key is another one. `AbortSignal.timeout(2000)` is a picture within 2 s. A picture of one pass is finished first.
   * @default undefined
   */
  enough?: AbortSignal;
}

export interface DrawAllOptions extends DrawOptions {
  /**
   * false: the first shot that fails ends the others. true: the others are drawn, and each shot has an outcome as
   * Promise.allSettled gives it.
   * @default false
   */
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
    /** Of TELAR_materials_fabric; null where it names none. */
    preset: string | null;
    /** What only the shading "fabric" reads, with the material's preset (js/docs/fabric.md); null where there is nothing. */
    fabric: {
      diffuseTransmission?: number;
      flatness?: number;
      /** Coverages, and yarns in one unit of u and v. */
      weave?: { warp: number; weft: number; threadsPerUv: [number, number] };
      back?: true;
    } | null;
    /**
     * Metres that one unit of u and one of v cover, in TEXCOORD_0: medians by area over the file's surfaces of this material; null where they
     * have none. Of inspect alone.
     */
    metresPerUv?: [number, number] | null;
    /** The cloth that the name suggests, for a look at it by `materials` of a shot; it is never applied by itself. Of inspect alone. */
    proposedPreset?: string | null;
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
  /** Of each variant, the indices of the materials that it draws, those of most triangles first, at most 8. */
  variantMaterials: number[][];
  extensionsUsed: string[];
  generator: string;
  copyright: string;
  warnings: Warning[];
}

/** What a render compiles and runs. That of `inspect` tells the wish: where the path tracer is to draw quality "high" and Embree is not there, the raster does. */
export interface Plan {
  features: string[];
  programs: Array<{ features: string[] }>;
  passes: string[];
  /** Of one pass over the picture and its shadow maps, hidden ones too, at most; counting stops beyond L_FRAGMENTS. Of inspect alone. */
  fragments?: number;
}

/** A part of a model: all that is beneath the nodes of a name, or all that is drawn with the materials of a name; or one of them by index. */
export type PartName = { node: string | number } | { material: string | number };

/** Metres in world space, moved to the nearest point of the surface; or a place of a node's mesh. */
export type MeasuredPoint =
  | Readonly<Vec3>
  | { node: string | number; primitive?: number; triangle: number; /** Barycentric, of the triangle's corners in drawing order. */ weights: Readonly<Vec3> }
  | { node: string | number; primitive?: number; vertex: number };

export interface MeasureOptions extends CallOptions {
  /**
   * The surface that is measured on. Ways along the surface stay on it.
   * @default undefined: all that is drawn
   */
  part?: PartName;
  /**
   * Metres, 0 to 1: corners nearer than this to one another are one, which closes gaps between parts that the file does not join.
   * @default 0: only what rounding has parted is joined
   */
  join?: number;
  /**
   * A KHR_materials_variants name, by which parts are found by material.
   * @default '': the file's own materials
   */
  variant?: string;
  /**
   * As the shot has it.
   * @default undefined: as the file stands
   */
  pose?: Shot['pose'];
  /**
   * As LoadingOptions has it.
   * @default 20000
   */
  timeoutMs?: number | null;
}

export interface MeasurePointsOptions extends MeasureOptions {
  /** 2 to 1024, in order. */
  points: ReadonlyArray<MeasuredPoint>;
  /**
   * Through the air, or the shortest way over the surface (exact on the triangles: Chen and Han 1990, Xin and Wang 2009).
   * @default 'straight'
   */
  along?: 'straight' | 'surface';
  /**
   * Whether the last point is joined to the first.
   * @default false
   */
  closed?: boolean;
}

export interface MeasureGirthOptions extends MeasureOptions {
  /** Around the part: of the loops in which this plane cuts the surface, the one nearest to the point. */
  girth: {
    point: Readonly<Vec3>;
    /** @default [0, 1, 0] */
    normal?: Readonly<Vec3>;
    /**
     * Draws the loop tight over the surface: to the closed geodesic that it can be moved to.
     * @default false
     */
    tight?: boolean;
  };
}

export interface MeasureBorderOptions extends MeasureOptions {
  /** The open edges of the surface that is measured on: of a part, its border. */
  border: true;
}

/** What Model.measure() takes, without what belongs to the call. */
export type MeasureAsk = Omit<MeasurePointsOptions, CallKeys> | Omit<MeasureGirthOptions, CallKeys> | Omit<MeasureBorderOptions, CallKeys>;
type CallKeys = 'pose' | 'signal' | 'timeoutMs';

/** What was measured between points. All lengths are metres, all points world space. */
export interface PointsMeasure {
  length: number;
  /** From each point to the next. */
  lengths: number[];
  /** Where each point is on the surface; `moved` is how far that is from where it was asked for. */
  points: Array<{ position: Vec3; moved: number; node: number; nodeName: string; material: number; primitive: number; triangle: number; weights: Vec3 }>;
  /** To draw it: its straight pieces lie on the surface, or are the straight way. */
  polyline: Vec3[];
}

/** `polyline` of a closed one does not end with its first point. */
export interface LoopMeasure {
  length: number;
  closed: boolean;
  polyline: Vec3[];
}

export interface GirthMeasure extends LoopMeasure {
  /** Length in the plane; where `tight` was asked for. */
  section?: number;
  /** The other loops in the plane, nearest first. */
  others: Array<{ length: number; closed: boolean }>;
}

export interface BorderMeasure {
  /** Of all loops. */
  length: number;
  /** Longest first. */
  loops: LoopMeasure[];
}

/**
 * What a line of a flat stands for: the outline before the background; a surface before another; a border of parts or materials; a seam
 * of a part that is named as stitched, or a primitive that draws lines; a fold of the surface.
 */
export type FlatKind = 'silhouette' | 'contour' | 'seam' | 'stitch' | 'crease';

export interface FlatOptions extends CallOptions {
  /**
   * What is drawn. Nothing else hides it.
   * @default undefined: all
   */
  part?: PartName;
  /**
   * As MeasureOptions has it.
   * @default 0
   */
  join?: number;
  /**
   * n of the scale 1:n that the SVG has in millimetres; for an orthographic camera. The strokes stay in pixels.
   * @default undefined: a pixel is one of CSS, 1/96 inch
   */
  scale?: number;
  /**
   * Degrees, 1 to 180: where two triangles bend more, there is a crease.
   * @default 60
   */
  creaseAngle?: number;
  /**
   * Metres: a surface that lies less before another is a fold that is not drawn. Where parts meet, it is their seam.
   * @default 0.008
   */
  foldDepth?: number;
  /**
   * Contours and creases within one part that are shorter are not drawn, in parts of the height of the picture, 0 to 1.
   * @default 0.02
   */
  foldLength?: number;
  /**
   * Pixels that a line may leave the exact one, to have fewer points.
   * @default 0.3
   */
  tolerance?: number;
  /**
   * Parts whose seams are stitches, which are dashed.
   * @default []
   */
  stitched?: ReadonlyArray<PartName>;
  /**
   * Of the lines in the SVG, in millimetres; 0 leaves a kind out.
   * @default { silhouette: 0.7, contour: 0.5, seam: 0.35, stitch: 0.25, crease: 0.25 }
   */
  weights?: Partial<Record<FlatKind, number>>;
  /**
   * Of the lines in the SVG: a CSS name or #rrggbb.
   * @default 'black'
   */
  color?: string;
  /**
   * As LoadingOptions has it.
   * @default 20000
   */
  timeoutMs?: number | null;
}

/** A technical flat: the lines of one view, hidden ones left out. */
export interface Flat {
  /** Pixels. */
  width: number;
  height: number;
  /** Of an orthographic camera; else null. */
  millimetresPerPixel: number | null;
  /** The most important kind first. Points are pixels from the top left corner; a closed one does not end with its first point. */
  strokes: Array<{ kind: FlatKind; closed: boolean; points: Array<[number, number]> }>;
  /** As FrameInfo has it. */
  worldToPixel: number[];
  /** That were looked at. */
  triangles: number;
  shot: ResolvedShot;
  /** The strokes as an SVG file, one path a kind with its name as class. */
  svg: string;
}

export interface SwatchOptions extends CallOptions {
  /** A material; or a node, of which the material that covers most of it is meant. */
  part: PartName;
  /**
   * Name of a material variant.
   * @default ''
   */
  variant?: string;
  /**
   * Side of the square in metres, 0.001 to 10.
   * @default 0.1
   */
  size?: number;
  /**
   * Whether it hangs from its upper edge in folds that grow downwards. Its rows keep their length.
   * @default false
   */
  draped?: boolean;
  /**
   * As LoadingOptions has it.
   * @default 20000
   */
  timeoutMs?: number | null;
}

/** A decoded model: draw many views of it. */
export interface Model {
  readonly facts: ModelFacts;

  /**
   * Measures on what the model draws, in metres. Needs no GL.
   * @param options - points, along, closed; or girth; or border; and part, join, variant, pose, timeoutMs, signal.
   * @throws {TelarError} E_OPTION, E_MEASURE, E_VARIANT, L_MEASURE, L_TRIANGLES, X_TIMEOUT
   * @example
   * const chest = await model.measure({ points: [[-0.25, 0.45, 0.1], [0.25, 0.45, 0.1]], along: 'surface', part: { node: 'front' } });
   * const hem = await model.measure({ border: true, part: { node: 'hem_bottom' } });
   * const waist = await model.measure({ girth: { point: [0, 0.3, 0.1], tight: true } });
   * console.log(chest.length, hem.loops.map(({ length }) => length), waist.polyline);
   */
  measure(options: MeasurePointsOptions): Promise<PointsMeasure>;
  measure(options: MeasureGirthOptions): Promise<GirthMeasure>;
  measure(options: MeasureBorderOptions): Promise<BorderMeasure>;

  /**
   * Draws a technical flat: the lines of a view as vectors. Needs no GL. Of the shot, it takes the size, camera, pose and variant; lines
   * are found to half a pixel of that size.
   * @param options - part, join, scale, creaseAngle, foldDepth, foldLength, tolerance, stitched, weights, color, timeoutMs, signal.
   * @throws {TelarError} E_OPTION, E_SHOT, E_MEASURE, L_TRIANGLES, X_TIMEOUT
   * @example
   * const view: Shot = { size: { width: 1600, height: 1600 }, camera: { view: 'front', projection: 'orthographic' } };
   * const flat = await model.flat(view, { scale: 10, stitched: [{ node: 'hem_bottom' }] });
   * await writeFile('front.svg', new TextEncoder().encode(flat.svg));
   */
  flat(shot?: Shot | ResolvedShot, options?: FlatOptions): Promise<Flat>;

  /**
   * The model with its parts apart: the mesh of each node moves along its mean normal, or away from the middle of the model where its
   * normals cancel out, as those of a sleeve do. It shares the data of this one; a shot's pose shows it whole again.
   * @param distance - Metres, 0 or more.
   * @throws {TelarError} E_OPTION, X_TIMEOUT
   * @example
   * const apart = await model.explode(0.15);
   * const { data } = await renderer.render(apart, { camera: { view: 'three-quarter' } });
   */
  explode(distance: number, options?: LoadOptions): Promise<Model>;

  /**
   * A square of one material in true size, as a model of its own: it stands upright about the origin, its face to +Z. Textures repeat on it
   * as often in a metre as they do on the garment, along u and along v, by the mean over its triangles. Occlusion maps and the file's lights and
   * cameras are left out. It shares its images with this model. Needs no GL.
   * @param options - part, variant, size, draped, timeoutMs, signal.
   * @throws {TelarError} E_OPTION, E_MEASURE, E_VARIANT, L_TRIANGLES, X_TIMEOUT
   * @example
   * const jersey = await model.swatch({ part: { material: 'jersey' }, size: 0.1 });
   * const image = await renderer.render(jersey, { size: { width: 800, height: 800 } });
   */
  swatch(options: SwatchOptions): Promise<Model>;
}

/** Settings that were chosen for a goal of error or time, and why: js/docs/trade.md. */
export interface QualityGoal {
  maxError?: number;
  budgetMs?: number;
  /** Name of the settings among those that were measured. */
  setting: string;
  /** FLIP that 85 of 100 scenes of the class do not pass, so that 95 of 100 goals hold; CPU milliseconds that are likely, and those that 9 of 10 pictures do not pass. */
  predicted: { flip: number; cpuMs: number; mostMs: number };
  /** false: nothing is predicted to hold it; W_QUALITY. */
  holds: boolean;
  /** What the prediction is from. */
  basis: string;
}

/** What a frame was made of. Native code may add keys. */
export interface FrameInfo extends Plan {
  width: number;
  height: number;
  format: ResolvedShot['output']['format'];
  /** "reference": the path tracer, without GL. It draws quality "high" too, where that costs less and Embree is there: js/docs/reference.md. */
  backend: Backend | 'reference';
  /** Strings of the GL context. */
  gl: Record<string, unknown>;
  quality: ResolvedShot['quality'];
  /**
   * The release of three.js that the shading is of, N of 0.N, and the releases that draw as it does, both inclusive. Left out for
   * shadings of another base.
   */
  three?: { revision: number; family: { from: number; to: number } };
  /**
   * Of what the picture is made of: the model's bytes and its parts', the environment's, the shot, telar's version. 64 hex
   * digits, fit for an ETag. What pictureKey() gives. Hosts with and without Embree give one key to pictures of quality "high" that
   * differ a little: W_LIBRARY_MISSING tells the latter.
   */
  key: string;
  /** Wall-clock milliseconds of each stage. */
  milliseconds: Record<string, number> & { load: number; pose: number; resolve: number; queue: number; draw: number; encode: number; total: number };
  warnings: Warning[];
  /**
   * What the picture shows of the model, parts 0..1: `coverage` of all pixels; of those that the model covers wholly, `dark`
   * (no channel above 2/255), `bright` (none below 250/255) and `saturated` (each at one of these ends). Left out where the
   * raster draws the environment as the background without perspective. W_EMPTY and W_EXPOSURE go by it.
   */
  picture?: { coverage: number; dark: number; bright: number; saturated: number };
  /** Triangles that the picture draws, instances counted each; of the path tracer, those that rays meet. Absent for flats. */
  triangles?: number;
  /** So many of them were left out before they were shaded, for they are hidden at every sample; no byte differs. Of the first pass. */
  hiddenTriangles?: number;
  /** Fragments that were shaded in dense rows, where what is seen was found first (js/docs/figures.md, Visibility buffer), of all passes; absent where it was not. */
  shadedFragments?: number;
  /** Texels of the largest mip levels that were not uploaded, for no fragment reads them; no byte differs. Absent where there are none. */
  unreadTexels?: number;
  /** Largest resident memory of the process so far. */
  peakBytes: number;
  /** Column-major 4 x 4: (X, Y, Z, W) = M (x, y, z, 1); the pixel is (X / W, Y / W) from the top left corner. */
  worldToPixel: number[];
  /** Millimetres of the model on a pixel, exact; null in perspective. */
  millimetresPerPixel: number | null;
  /** Factor that `metering` of the shot came to; absent without it. */
  meteredExposure?: number;
  /** Of a shot whose quality is a goal. `quality` and `shot` have the settings that were chosen for it. */
  goal?: QualityGoal;
  /** Samples of a pixel, at most, when the caller had enough: the option `enough`. Absent of what was finished before. */
  ended?: number;
  /** Of a shot with layers. */
  layers?: LayerFacts;
  shot: ResolvedShot;
  [key: string]: unknown;
}

/** A node or a material by its number in a layer; `node` and `material` are indices in the file, null of glTF's default material. */
export interface LegendEntry {
  id: number;
  name: string;
  node?: number;
  material?: number | null;
}

/** What the layers of a frame hold beside their pixels. */
export interface LayerFacts {
  depth?: { /** Least and largest depth, metres: what PNG spreads its numbers over. */ range: [number, number] };
  partId?: { legend: LegendEntry[] };
  materialId?: { legend: LegendEntry[] };
  [layer: string]: Record<string, unknown> | undefined;
}

export interface Image {
  /** The encoded file. */
  data: Buffer;
  /** The encoded layers that the shot asks for, by name; left out where there are none, or where `data` holds them (`output.layers.together`). */
  layers?: Partial<Record<Exclude<ResolvedShot['layers'][number], 'beauty'>, Buffer>>;
  info: FrameInfo;
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

export interface InspectOptions extends LoadOptions {
  /**
   * The shot to plan for.
   * @default {}
   */
  shot?: Shot | ResolvedShot;
  /**
   * What to measure on the model in the shot's pose, as Model.measure() takes it.
   * @default []
   */
  measure?: ReadonlyArray<MeasureAsk>;
  /**
   * What an input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
}

/**
 * Tells what is in a model, and what a render of it would compile and run. Needs no GL.
 * @param options - shot, measure, limits, failOn, resolve, timeoutMs, ambientVisibility, signal.
 * @returns The facts; `plan` is null where there is nothing to draw, `measures` are in the order of options.measure.
 * @throws {TelarError} What Renderer.load() throws, E_SHOT
 * @example
 * const { triangles, materials, plan } = await inspect('shirt.glb', { shot: { quality: 'high' } });
 * console.log(triangles, materials.map(({ name }) => name), plan?.passes);
 */
export function inspect(source: Source, options?: InspectOptions): Promise<Inspection>;

/** What inspect() gives. */
export interface Inspection extends ModelFacts {
  /** In the order that `measure` has. */
  measures?: Array<PointsMeasure | GirthMeasure | BorderMeasure>;
  /** What a render would compile and run; null where there is nothing to draw. */
  plan: Plan | null;
}

export interface PictureKeyOptions extends CallOptions {
  /**
   * What an input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
  /**
   * As LoadingOptions has it.
   * @default undefined: files are read beside the model
   */
  resolve?: Resolve;
  /**
   * As LoadingOptions has it.
   * @default false
   */
  ambientVisibility?: boolean | { rays?: number };
}

/**
 * Gives the key that a picture will have as `info.key`. It neither draws the picture nor decodes the model. A service can answer
 * "not modified" by it, and a batch can leave out what has not changed.
 * @param options - limits, resolve, ambientVisibility, signal.
 * @returns 64 hex digits
 * @throws {TelarError} E_SHOT, E_OPTION
 * @example
 * const etag = await pictureKey('shirt.glb', { camera: { view: 'back' } });
 */
export function pictureKey(source: Source, shot?: Shot | ResolvedShot, options?: PictureKeyOptions): Promise<string>;

export interface BakeOptions extends CallOptions, Pick<LoadingOptions, 'failOn' | 'resolve'> {
  /**
   * Rays of each side of a vertex, 16 to 4096.
   * @default 256
   */
  rays?: number;
  /**
   * Folder of what rays have found, by the content of the file; null = none.
   * @default telar's folder in the user's cache
   */
  cacheDirectory?: string | null;
  /**
   * Bytes that the folder may hold. The files that were used longest ago are deleted first.
   * @default 268435456
   */
  cacheBytes?: number;
  /**
   * What the input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
  /**
   * Milliseconds before it ends with X_TIMEOUT; null = no bound.
   * @default null
   */
  timeoutMs?: number | null;
}

export interface BakedFile {
  /** The file with its new attributes. */
  data: Buffer;
  info: {
    format: 'glb' | 'gltf';
    /** The files that it names, beside which it has to lie. */
    parts: string[];
    /** That have got attributes. */
    primitives: number;
    vertices: number;
    rays: number;
    warnings: Warning[];
  };
}

/**
 * Writes the ambient visibility of a model into its vertices (js/docs/visibility.md), for the shading "fabric" on the server and in
 * browsers. Everything else in the file stays as it is. Needs no GL, but libembree3-3.
 * @param options - rays, limits, failOn, resolve, timeoutMs, signal.
 * @throws {TelarError} What Renderer.load() throws, L_VISIBILITY_RAYS, X_LIBRARY_MISSING
 * @example
 * const { data } = await bake('shirt.glb', { rays: 64 });
 */
export function bake(source: Source, options?: BakeOptions): Promise<BakedFile>;

/** Light by lobe, linear [r, g, b]; `total` is the sum of the other four. */
export type Lobes = Record<'diffuse' | 'specular' | 'sheen' | 'coat' | 'total', Vec3>;

export interface EvaluateShadingOptions extends CallOptions {
  /** A material as glTF writes it, without textures; or the index of one in `model`. */
  material: object | number;
  /**
   * The loaded model that `material` is an index into.
   * @default undefined
   */
  model?: Model;
  /**
   * As the shot has it.
   * @default 'three'
   */
  shading?: Shot['shading'];
  /**
   * Radians from the normal towards the tangent, 0 up to but not including pi / 2.
   * @default 0
   */
  viewAngle?: number;
  /**
   * Unit vectors to the light, at most 65536; z = normal, x = tangent.
   * @default []
   */
  directions?: ReadonlyArray<Readonly<Vec3>>;
  /**
   * Integrates over all directions too.
   * @default false
   */
  albedo?: boolean;
}

/**
 * Evaluates the shading of a material, lobe by lobe, in double and without GL. Textures are left out, as if they were white and
 * normal maps flat.
 * @param options - material, model, shading, viewAngle, directions, albedo, signal.
 * @returns `radiance`: of each direction, under a light that gives the irradiance 1 on a surface that faces it (the BSDF times the
 *   cosine). `albedo`: the part of uniform light that is reflected. `albedoError`: a bound of its error that 999 of 1000 keep.
 * @throws {TelarError} E_OPTION, and what Renderer.load() throws
 * @example
 * const material = { pbrMetallicRoughness: { baseColorFactor: [0.5, 0.1, 0.1, 1], metallicFactor: 0, roughnessFactor: 0.6 } };
 * const { radiance, albedo } = await evaluateShading({ material, shading: 'fabric', directions: [[0, 0, 1]], albedo: true });
 * console.log(radiance[0]?.diffuse, albedo?.total);
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
  /** CPU milliseconds of two small pictures, by GL, as measured here for `quality: {budgetMs}`; empty before its first picture. tracer: 0 without Embree. */
  calibration: Record<string, { raster: number; tracer: number }>;
  /** Whether .hdr, .exr, TIFF and ICC profiles can be had; PNG, JPEG, WebP and KTX2 always can. */
  imageFiles: { works: true } | { works: false; failure: string };
  /** What a worker of telar/pool gives up, what this kernel refuses, and whether failed allocations are noticed; empty where the native part is missing. */
  isolation: IsolationStep[];
}

/** A right that a worker of telar/pool gives up, or what it watches of itself; `failure`: what the kernel said, as "EPERM", or why else not; null where it did. */
export interface IsolationStep {
  step: string;
  failure: string | null;
}

/**
 * Tells which GL backends this machine has, which one "auto" chooses and why, and the cure for those that are missing. It does not
 * throw for what it finds.
 * @example
 * const { ok, chosen, reason } = await doctor();
 * if (!ok) console.error(reason);
 */
export function doctor(): Promise<DoctorReport>;

export interface Versions {
  telar: string;
  node: string;
  napi: string;
}

export const versions: Readonly<Versions>;

/**
 * An animated WebP file out of still ones of one size, which keep every byte of their pictures.
 * @example
 * const shots = turntable({ output: { format: 'webp' } }, 36).map(({ shot }) => shot);
 * const frames = await renderer.renderAll('shirt.glb', shots);
 * const file = animateWebp(frames.map(({ data }) => data), { frameMs: 80 });
 */
export function animateWebp(frames: readonly Uint8Array[], options?: { /** @default 100 */ frameMs?: number; /** 0 = for ever. @default 0 */ loops?: number }): Buffer;
