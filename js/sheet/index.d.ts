import type { Limits, Model, ModelFacts, Renderer, Source, Warning } from '../index.js';
import type { Shot } from '../shot/shot.js';
import type { SheetSpec } from './spec.js';

export type { SheetSpec };
export { TelarError } from '../error/index.js';

export interface SheetOptions {
  /** Draws the pictures, and measures. */
  renderer: Renderer;
  /**
   * One PDF, or one SVG or PNG a page.
   * @default 'pdf'
   */
  format?: 'pdf' | 'svg' | 'png';
  /**
   * Bytes of TrueType or OpenType fonts for scripts that Inter lacks.
   * @default []
   */
  fonts?: Uint8Array[];
  /**
   * Gives the bytes of an image that the spec names; null where there is none.
   * @default undefined: a spec that names an image is refused
   */
  resolve?: (name: string) => Uint8Array | null | Promise<Uint8Array | null>;
  /**
   * Folders of own templates, by the name that the spec's `template` has.
   * @default {}
   */
  templates?: Record<string, string>;
  /**
   * What the pictures share. Other keys of a shot are refused (E_OPTION): what the garment is, and where it is seen from, is the spec's.
   * @default {}
   */
  shot?: Pick<Shot, 'environment' | 'lights' | 'modelLights' | 'shading' | 'toneMapping' | 'exposure' | 'metering' | 'quality'>;
  /**
   * The spec of the last revision: what differs from it is marked.
   * @default undefined
   */
  previous?: SheetSpec;
  /**
   * What an image of the spec may cost, by the L_* names.
   * @default {}
   */
  limits?: Limits;
  /**
   * Milliseconds that each picture and each measure may take; null = no bound.
   * @default undefined: of pictures the renderer's, of measures 20000
   */
  timeoutMs?: number | null;
  /**
   * Stops the work. The promise then rejects with the signal's reason.
   * @default undefined
   */
  signal?: AbortSignal;
  /**
   * Is called with the part of the pictures that is drawn, 0..1.
   * @default undefined
   */
  onProgress?: (part: number) => void;
}

/** CIE Lab: L, a, b. */
export type Lab = [number, number, number];

export interface Sheet {
  format: 'pdf' | 'svg' | 'png';
  /** The PDF, or one file a page. */
  files: Buffer[];
  info: {
    /** How many pictures were drawn. */
    pictures: number;
    /**
     * What the model's file and the pictures are warned of, what stands elsewhere than wished, and what of the model does not fit the spec; each once.
     * `pointer` of W_SHEET_* is into the spec, of others as a picture's `info.warnings` has it.
     */
    warnings: Warning[];
    /** Lengths measured on the model. */
    measures: Array<{ code: string; millimetres: number }>;
    /** Colours of the spec's swatches: the mean albedo, without light; nearest of the list, with the distance CIEDE2000. */
    swatches: Array<{ title: string; srgb: string; labD50: Lab; labD65: Lab; nearest: Array<{ name: string; difference: number }> }>;
    /** Wall-clock milliseconds of each stage. */
    milliseconds: { layout: number; pictures: number; typeset: number; total: number };
  };
}

/**
 * Makes a tech sheet.
 * @param source - A loaded model, or what `renderer.load` takes.
 * @param spec - What the sheet says; js/docs/sheet.md lists its keys.
 * @throws {TelarError} E_SPEC with the JSON pointer, E_OPTION, X_LIBRARY_MISSING where Typst is not installed, X_SHEET of a template that fails, and what
 *   rendering and measuring throw
 * @example
 * const { files } = await createSheet('shirt.glb', { header: { style: 'TL-01' } }, { renderer });
 * await writeFile('shirt.pdf', files[0]);
 */
export function createSheet(source: Source | Model, spec: SheetSpec, options: SheetOptions): Promise<Sheet>;

/**
 * A first spec, made of what a model tells: its materials, variants and size.
 * @param options - name: of the style where the model has none; language: of the texts that it writes.
 * @example
 * const model = await renderer.load('shirt.glb');
 * const spec = firstSpec(model.facts, { name: 'shirt' });
 */
export function firstSpec(facts: ModelFacts, options?: { name?: string; language?: string }): SheetSpec;

/**
 * JSON pointers of what a spec has new or otherwise than the one before.
 * @example
 * changesBetween({ notes: 'a' }, { notes: 'b' }); // ['/notes']
 */
export function changesBetween(before: SheetSpec, after: SheetSpec): string[];

/**
 * Checks a spec and writes out its defaults.
 * @param facts - Of the model: names of its variants are checked.
 * @throws {TelarError} E_SPEC with the path, the expected thing and the value given
 * @example
 * readSpec({ paper: { size: 'A3' } }, { variants: [] });
 */
export function readSpec(spec: SheetSpec, facts?: { variants?: readonly string[] }): SheetSpec;
