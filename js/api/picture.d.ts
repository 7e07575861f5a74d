import type { TelarError } from '../error/index.js';
import type { ResolvedShot } from '../shot/shot.js';
import type { Plan, Warning } from './facts.js';
import type { Backend, LoadOptions } from './loading.js';

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
  /**
   * Of a quality of `{maxError}`: whether the error that was reached is measured after the picture is drawn, in its `timeoutMs`, for `info.goal.reached`: a window
   * of it is drawn by the same settings and by path tracing. Some tenths of a second of CPU, seconds for cloth of rough relief.
   * @default false
   */
  reached?: boolean;
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

/** Settings that were chosen for a goal of error or time, and why: js/docs/trade.md. */
export interface QualityGoal {
  maxError?: number;
  budgetMs?: number;
  /** Name of the settings among those that were measured. */
  setting: string;
  /** FLIP that 92 of 100 scenes of the class do not pass, so that 95 of 100 goals hold; CPU milliseconds that are likely, and those that 9 of 10 pictures do not pass. */
  predicted: { flip: number; cpuMs: number; mostMs: number };
  /** false: nothing is predicted to hold it; W_QUALITY. */
  holds: boolean;
  /** What the prediction is from. */
  basis: string;
  /**
   * What it came to. Of `budgetMs` always: `cpuMs` that this process spent while it drew, all threads and other work of it together. Of `maxError` where the
   * option `reached` asks for it: mean FLIP of the model in a window of so many pixels, against traced paths; null where the path tracer is not there.
   */
  reached?: { cpuMs: number } | { flip: number; pixels: number } | null;
}

/**
 * What a picture leaves out, for its scene does not need it, against all forced on; no byte differs. The raster's first pass.
 * `features`: of programs; `passes`: kinds of them; `triangles`: hidden at every sample; `texels`: of the largest mip levels of
 * textures that no fragment reads, or beyond `textureSize`; `lights`: black ones, and point and spot lights whose range ends before what is shaded; `shadowMaps`: of such
 * lights, where no ground shows them.
 */
export interface SkippedPart {
  what: 'features' | 'passes' | 'triangles' | 'texels' | 'lights' | 'shadowMaps';
  /** Exact. */
  count: number;
  /** With those that are there. */
  of: number;
  /**
   * By how much longer the picture would have taken to draw, in parts of `milliseconds.draw`. Estimated: by what was measured of
   * other models (js/docs/figures.md), of triangles by the pixels that they cover.
   */
  estimatedPart?: number;
  /** GPU memory, of texels. Exact. */
  bytes?: number;
  /** Of shadow maps. Exact. */
  texels?: number;
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
  /** Wall-clock milliseconds of each stage. The stage that first needs texels of a file, mostly `upload`, holds the wait for them. */
  milliseconds: Record<string, number> & { load: number; pose: number; resolve: number; queue: number; draw: number; encode: number; total: number };
  warnings: Warning[];
  /**
   * What the picture shows of the model, parts 0..1: `coverage` of all pixels; of those that the model covers wholly, `dark`
   * (no channel above 2/255), `bright` (none below 250/255) and `saturated` (each at one of these ends). Left out where the
   * raster draws the environment as the background without perspective. W_EMPTY and W_EXPOSURE go by it.
   */
  picture?: { coverage: number; dark: number; bright: number; saturated: number };
  /** Triangles that the picture draws, those that quality.geometryError leaves, instances counted each; of the path tracer, those that rays meet. Absent for flats. */
  triangles?: number;
  /** So many of them were left out before they were shaded, for they are hidden at every sample; no byte differs. Of the first pass. */
  hiddenTriangles?: number;
  /** Fragments that were shaded in dense rows, where what is seen was found first (js/docs/figures.md, Visibility buffer), of all passes; absent where it was not. */
  shadedFragments?: number;
  /** Texels of the largest mip levels that were not uploaded, or not made as relief: no fragment reads them, or they are beyond quality.textureSize. Absent where there are none. */
  unreadTexels?: number;
  /** What was left out, and what that saves. Absent of the path tracer and of flats. */
  skipped?: SkippedPart[];
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
  /** Samples of a pixel, at most, when it was enough: by the option `enough`, or as its goal was reached. Absent of what was finished before. */
  ended?: number;
  /**
   * Of a quality of `{maxError}`: standard error of a pixel, in 1/255 of its encoded luma, mean over those that vary from sample to sample, at the
   * last doubling of samples but that which ends them all. Absent where there were fewer than 16.
   */
  standardError?: number;
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
