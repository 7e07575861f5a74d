import type { ResolvedShot } from '../shot/shot.js';

// three.js brings no types of its own: its objects pass through as they are.
type Three = any;

/** Parameters that a THREE.WebGLRenderer must be built with. */
export function rendererParameters(shot: ResolvedShot): { antialias: boolean; alpha: boolean; premultipliedAlpha: boolean };

/**
 * Sets up a stock three.js 0.187 scene from a resolved shot, so that browser and server draw the same picture.
 * @returns the camera to draw with
 */
export function applyShot(shot: ResolvedShot, target: {
  /** The client's own three.js module. */
  THREE: Three;
  renderer: Three;
  scene: Three;
  camera?: Three;
  /** What GLTFLoader gave: {scene, parser}. */
  model?: Three;
  /** Linear equirectangular texture; required where the shot has an environment. */
  environment?: Three;
  /**
   * Gives three's tables of rect lights, `() => import('three/addons/lights/RectAreaLightUniformsLib.js')`: called for the
   * first shot with such a light, required there.
   */
  areaLightTables?: () => Promise<Three>;
}): Promise<Three>;

/**
 * What resolveShot needs to know of a model that GLTFLoader gave, measured as the server measures it. Metres, world space.
 * The model takes the pose and keeps it.
 */
export function factsOf(model: { scene: Three; parser?: Three; animations?: Three[] }, options: {
  THREE: Three;
  /** As `resolvePose(shot, {animations: model.animations})` of telar/shot gives it; default null, as the file stands. */
  pose?: ResolvedShot['pose'];
}): {
  bounds: { min: number[]; max: number[] } | null;
  /** Drawn vertices that lie farthest out. */
  outline: number[][];
  /** As the shot's explicit camera, with a name; far is null where the file says infinite. */
  cameras: object[];
  variants: string[];
  /** Duration in seconds. */
  animations: Array<{ name: string; duration: number }>;
};

/** Puts a model into a pose, or back as the file stands. */
export function applyPose(model: { scene: Three; animations?: Three[] }, pose: ResolvedShot['pose'], three: { THREE: Three }): void;
