import type { Limits } from '../index.js';

export { TelarError } from '../error/index.js';

/** RGBA8, sRGB-encoded, straight alpha, top row first: width * height * 4 bytes. */
export interface Image {
  width: number;
  height: number;
  data: Uint8Array | Uint8ClampedArray;
}

/** Figures of the pixels of one region. */
export interface Figures {
  pixels: number;
  /** Largest difference of any channel of premultiplied RGBA, in 1/255. */
  max: number;
  /** Mean over pixels of the largest channel difference, in 1/255. */
  mean: number;
  /** 99.9th percentile over pixels of the largest channel difference, in 1/255. */
  p999: number;
  /** Pixels that differ by 1/255 or more. */
  atLeast1: number;
  atLeast2: number;
  /** Pixel of `max`, counted from the top left. */
  worst: [number, number] | null;
  /** Root mean square difference of the colours, encoded, 0 to 1. */
  rmse: number;
  /** The same of linear light. */
  rmseLinear: number;
  /** FLIP for LDR pictures, 0 to 1; its quartiles weigh a pixel by its error. */
  flip: { mean: number; weightedMedian: number; weightedQuartile1: number; weightedQuartile3: number; max: number };
  /** CIEDE2000. */
  deltaE: { mean: number; p95: number; max: number };
}

export interface Comparison {
  width: number;
  height: number;
  /** Every pixel. */
  frame: Figures;
  /** Pixels that either picture covers; with a mask its own and the edge around. Null where there is none, as in the next two. */
  object: Figures | null;
  /** Pixels whose surroundings of 2 pixels both pictures cover (alpha above 0), and with a mask the background that both show. */
  interior: Figures | null;
  /** The rest of the object. */
  edge: Figures | null;
  /** Mean over the frame, 1 = equal; null for a picture smaller than 11 x 11. */
  ssim: number | null;
  /** FLIP of each pixel, 0 to 1. */
  flipMap: Float32Array;
}

/**
 * How far two pictures of one size are apart. Synchronous, up to three seconds for 512 x 512 pixels that all
 * differ, and the less the fewer differ.
 * `max`, `p999` and `worst` are of premultiplied RGBA; every other figure is of the colours seen over black and over white,
 * whichever shows a pixel worse.
 * @throws {TelarError} E_OPTION, E_IMAGE_SIZE
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * console.log(comparison.object?.flip.mean, comparison.frame.worst);
 */
export function compareImages(expected: Image, actual: Image, options?: {
  /** Viewing distance of FLIP, 1 to 1000. @default 67 */
  pixelsPerDegree?: number;
  /** Width * height bytes, not 0 where the object is: for pictures with a background, whose alpha does not tell. */
  mask?: Uint8Array;
  /** Width * height bytes, not 0 where the pictures are not compared. */
  ignore?: Uint8Array;
}): Comparison;

/**
 * What explains most of the difference of two pictures of one size, where it is alpha or the background; empty where the
 * drawing differs, or nothing does.
 * @throws {TelarError} E_OPTION, E_IMAGE_SIZE
 * @example
 * for (const { cause, message } of explainDifference(await readImage('shirt.png'), await readImage('golden/shirt.png'))) console.log(cause, message);
 */
export function explainDifference(expected: Image, actual: Image): Array<{ cause: 'background' | 'premultiplied' | 'alpha'; message: string }>;

/**
 * By how much one picture is larger in both directions, as screenshots of dense screens are; null where none is, or the shapes differ.
 * @example
 * console.log(sizeFactor({ width: 512, height: 512 }, { width: 1024, height: 1024 })?.factor); // 2
 */
export function sizeFactor(expected: { width: number; height: number }, actual: { width: number; height: number }):
  { larger: 'expected' | 'actual'; factor: number } | null;

/**
 * A smaller picture: each pixel is the mean of what it covers, of premultiplied encoded values.
 * @throws {TelarError} E_OPTION
 * @example
 * const icon = shrinkImage(await readImage('shirt.png'), { width: 64, height: 64 });
 * await writeFile('icon.png', await encodePng(icon));
 */
export function shrinkImage(image: Image, size: { width: number; height: number }): Image;

export type GateName = 'exact' | 'parity' | 'standard' | 'other-gl' | 'draft';

export type Region = 'frame' | 'object' | 'interior' | 'edge';
export type LimitedFigure = 'max' | 'p999' | 'mean' | 'rmse' | 'rmseLinear' | 'flip.mean' | 'flip.max' | 'deltaE.mean' | 'deltaE.p95' | 'deltaE.max';

export interface GateCheck {
  region: Region;
  figure: LimitedFigure;
  /** The largest value that passes. */
  limit: number;
}

export const GATES: Readonly<Record<GateName, readonly GateCheck[]>>;

export interface Verdict {
  gate: GateName;
  pass: boolean;
  /** value is null where the region has no pixels: only an edge passes then. Equal pictures pass every check. */
  checks: Array<GateCheck & { value: number | null; pass: boolean }>;
}

/**
 * Holds a comparison against a gate. `limits`, as {'object.flip.mean': 0.02}, stand in place of the gate's or beside them.
 * @default gate 'standard' @throws {TelarError} E_OPTION
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * const { pass, checks } = judge(comparison, 'standard', { 'object.flip.mean': 0.02 });
 * if (!pass) console.error(checks.filter((check) => !check.pass));
 */
export function judge(comparison: Comparison, gate?: GateName, limits?: Partial<Record<`${Region}.${LimitedFigure}`, number>>): Verdict;

/**
 * FLIP of each pixel as an opaque picture, black = 0, light yellow = 1.
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * await writeFile('flip.png', await encodePng(heatMap(comparison)));
 */
export function heatMap(comparison: Comparison): Image;

/**
 * CIEDE2000 of two CIELAB colours.
 * @example
 * console.log(ciede2000([50, 2.6772, -79.7751], [50, 0, -82.7485])); // 2.0425
 */
export function ciede2000(lab1: readonly [number, number, number], lab2: readonly [number, number, number]): number;

/**
 * Decodes a PNG, JPEG or WebP. Embedded colour profiles are not applied.
 * @throws {TelarError} E_OPTION, E_FILE, E_IMAGE_FORMAT, E_IMAGE_CORRUPT, L_FILE_BYTES, L_IMAGE_*
 * @example
 * const { width, height, data } = await readImage('shirt.webp', { limits: { L_IMAGE_PIXELS: 4e6 } });
 * console.log(width * height * 4 === data.length);
 */
export function readImage(source: string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer,
  options?: { limits?: Limits; signal?: AbortSignal }): Promise<Image>;

/**
 * Encodes a picture.
 * @throws {TelarError} E_OPTION
 * @example
 * const black = { width: 2, height: 1, data: Uint8Array.of(0, 0, 0, 255, 0, 0, 0, 255) };
 * await writeFile('black.png', await encodePng(black));
 */
export function encodePng(image: Image, options?: { signal?: AbortSignal }): Promise<Buffer>;

/**
 * A page with the pictures, the heat map, the verdict and all figures; `files` are its links.
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * const page = htmlReport(comparison, judge(comparison), { expected: 'shirt.png', actual: 'golden/shirt.png', heatMap: 'flip.png' });
 * await writeFile('report.html', new TextEncoder().encode(page));
 */
export function htmlReport(comparison: Comparison, verdict: Verdict,
  files: { expected: string; actual: string; heatMap: string; title?: string; hints?: ReadonlyArray<{ message: string }> }): string;

/** One of many comparisons. */
export interface Compared {
  name: string;
  status?: 'within' | 'over' | 'missing' | 'new' | 'failed' | 'updated';
  comparison?: Omit<Comparison, 'flipMap'>;
  verdict?: Verdict;
  hints?: ReadonlyArray<{ message: string }>;
  /** Why there is no verdict. */
  problem?: string;
  /** Pictures as the page links to them. */
  files?: { expected?: string; actual?: string; heatMap?: string };
}

/**
 * A page about many comparisons: those that are not within the gate with their pictures, and all in a table.
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * const verdict = judge(comparison, 'parity');
 * const rows: Array<Compared & { status: 'within' | 'over' }> = [{ name: 'shirt', status: verdict.pass ? 'within' : 'over', comparison, verdict }];
 * await writeFile('report.html', new TextEncoder().encode(foldersReport(rows, { gate: 'parity' })));
 */
export function foldersReport(compared: ReadonlyArray<Compared & { status: NonNullable<Compared['status']> }>, options: { title?: string; gate: string }): string;

/**
 * JUnit XML: a suite for each comparison, a test case for each check.
 * @example
 * const comparison = compareImages(await readImage('shirt.png'), await readImage('golden/shirt.png'));
 * const xml = junitReport([{ name: 'shirt', verdict: judge(comparison) }]);
 * await writeFile('report.xml', new TextEncoder().encode(xml));
 */
export function junitReport(comparisons: ReadonlyArray<Pick<Compared, 'name' | 'verdict' | 'hints' | 'problem' | 'status'>>): string;

/**
 * A copy of a PNG file with the shot that it shows inside (iTXt chunk `telar:shot`), in place of one that it has.
 * @throws {TelarError} E_IMAGE_FORMAT, E_IMAGE_CORRUPT, E_SHOT
 * @example
 * const { data, info } = await renderer.render('shirt.glb');
 * await writeFile('shirt.png', embedShot(data, info.shot));
 */
export function embedShot(png: Uint8Array, shot: object): Uint8Array;

/**
 * The shot inside a PNG, unchecked; null where there is none.
 * @throws {TelarError} E_IMAGE_CORRUPT
 * @example
 * const { data, info } = await renderer.render('shirt.glb');
 * console.log(readEmbeddedShot(embedShot(data, info.shot)));
 */
export function readEmbeddedShot(bytes: Uint8Array): object | null;
