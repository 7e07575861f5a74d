import type { ResolvedShot, Shot } from './shot.js';

export type { ResolvedShot, Shot };
export { TelarError } from '../error/index.js';

export type Vec3 = [number, number, number];

/** A camera of a model, degrees and metres, world space. */
export interface CameraFact {
  name: string;
  /** Number of the node in the file. */
  node: number;
  projection: 'perspective' | 'orthographic';
  fovY?: number;
  aspectRatio?: number;
  height?: number;
  width?: number;
  near: number;
  /** null = infinite */
  far: number | null;
  position: Vec3;
  target: Vec3;
  up: Vec3;
}

/** An animation of a model. */
export interface AnimationFact {
  name: string;
  /** Seconds. */
  duration: number;
}

/** What a part of a model measures that a camera frames: `camera.frame` with a node or a material. */
export interface PartFact {
  frame: { node: number | string } | { material: number | string };
  /** Whether the model has it. */
  found: boolean;
  /** null where it draws nothing. */
  bounds: Box | null;
  /** Its drawn vertices that lie farthest out. */
  outline?: readonly (readonly number[])[];
  /** Where it draws nothing: of what could be framed instead. */
  names?: readonly string[];
}

type Point = readonly [number, number, number] | readonly number[] | { x: number; y: number; z: number };

/** Axis-aligned box in metres; a THREE.Box3 fits. */
export interface Box {
  min: Point;
  max: Point;
}

/** What resolveShot needs to know of a model: its facts, or its box alone. */
export type ShotFacts = Box | {
  bounds: Box | null;
  cameras?: readonly Omit<CameraFact, 'node'>[];
  variants?: readonly string[];
  animations?: readonly AnimationFact[];
  /** Needed where the shot frames a part: `renderer.factsOf(model, shot)`, or factsOf of telar/three with `frame`. */
  part?: PartFact;
};

/**
 * Writes out every default of a shot. Pure and synchronous, the same bits in the browser and on the server; a resolved shot
 * resolves to itself. `facts` is needed unless the camera is explicit with near and far.
 * @throws {TelarError} E_SHOT with the path, the expected thing and the value given; E_CAMERA; E_FRAME; E_VARIANT;
 *   E_NO_GEOMETRY; E_EXTENT; E_OPTION
 * @example
 * const shot: Shot = { camera: { view: 'back' }, size: { width: 800, height: 800 } };
 * console.log(resolveShot(shot, model.facts).camera.position);
 */
export function resolveShot(shot?: Shot | ResolvedShot, facts?: ShotFacts | null): ResolvedShot;

/**
 * The moment that a shot shows. Facts depend on it: first the pose, then the facts of the model in that pose, then resolveShot.
 * @returns index into the model's animations and seconds; null = as the file stands
 * @throws {TelarError} E_SHOT, E_POSE
 * @example
 * const shot: Shot = { pose: { animation: 'walk', time: 0.5 } };
 * console.log(resolvePose(shot, { animations: model.facts.animations })?.time);
 */
export function resolvePose(shot: Shot | ResolvedShot, facts?: { animations?: readonly AnimationFact[] }): ResolvedShot['pose'];

/**
 * The part of the model that a shot frames; undefined where it frames the model. Facts depend on it, as on the pose.
 * @example
 * const shot: Shot = { camera: { frame: { node: 'Sleeve' } } };
 * console.log(resolvePart(shot)?.kind);
 */
export function resolvePart(shot: Shot | ResolvedShot): { kind: 'node' | 'material'; which: number | string; frame: PartFact['frame'] } | undefined;

/**
 * The ghosts of a shot that leaves out a part of the model; undefined where it leaves out nothing. Facts depend on it, as on the pose: what
 * is left out is not framed.
 * @example
 * const shot: Shot = { ghost: [{ node: 'Mannequin', opacity: 0 }] };
 * console.log(resolveLeftOut(shot)?.length);
 */
export function resolveLeftOut(shot: Shot | ResolvedShot): ResolvedShot['ghost'] | undefined;

/**
 * An opaque CSS colour as linear Rec.709, the bits of THREE.Color; undefined when the text is none.
 * @example
 * console.log(parseColour('#23324f'));
 */
export function parseColour(text: string): Vec3 | undefined;

/**
 * sRGB transfer function, encoded [0, 1] to linear [0, 1].
 * @example
 * console.log(srgbToLinear(0.5)); // 0.2140
 */
export function srgbToLinear(encoded: number): number;

/** Azimuth and elevation in degrees of each named view. */
export const VIEWS: Readonly<Record<'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'three-quarter', { azimuth: number; elevation: number }>>;

/**
 * The shots of a turntable, evenly spaced from the shot's own view on; all share one scale, one axis and one exposure: `metering` is left out.
 * @param shot its camera is a view
 * @param frames at least 1
 * @returns in order; name: "side-000", by degrees from the first
 * @example
 * for (const { name, shot } of turntable({ size: { width: 512, height: 512 } }, 8)) {
 *   const { data } = await renderer.render(model, shot);
 *   await writeFile(`${name}.png`, data);
 * }
 */
export function turntable(shot: Shot, frames: number): Array<{ name: string; angle: number; shot: Shot }>;
