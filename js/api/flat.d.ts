import type { ResolvedShot } from '../shot/shot.js';
import type { CallOptions } from './loading.js';
import type { PartName } from './measure.js';

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
