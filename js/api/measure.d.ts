import type { Vec3 } from '../shot/index.js';
import type { Shot } from '../shot/shot.js';
import type { CallOptions } from './loading.js';

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
