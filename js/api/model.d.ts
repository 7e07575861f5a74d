import type { ResolvedShot, Shot } from '../shot/shot.js';
import type { ModelFacts } from './facts.js';
import type { Flat, FlatOptions } from './flat.js';
import type { CallOptions, LoadingOptions } from './loading.js';
import type { BorderMeasure, GirthMeasure, MeasureBorderOptions, MeasureGirthOptions, MeasurePointsOptions, PartName, PointsMeasure } from './measure.js';

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
   * @param options - timeoutMs, signal.
   * @throws {TelarError} E_OPTION, X_TIMEOUT
   * @example
   * const apart = await model.explode(0.15);
   * const { data } = await renderer.render(apart, { camera: { view: 'three-quarter' } });
   */
  explode(distance: number, options?: CallOptions & Pick<LoadingOptions, 'timeoutMs'>): Promise<Model>;

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
