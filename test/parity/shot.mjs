import { resolveShot } from '../../js/shot/index.mjs';

/** Looks at the cube [-1, 1] from the front, everything in view. */
const FRONT = { position: [0, 0, 4.6], target: [0, 0, 0] };
/** From the upper right, as a product picture does. */
const THREE_QUARTER = { position: [2.4, 1.5, 3.6], target: [0, 0, 0] };
const PERSPECTIVE = { projection: 'perspective', fovY: 30, near: 2.5, far: 7.5 };
const ORTHOGRAPHIC = { projection: 'orthographic', height: 2.3, near: 0.5, far: 8 };

export const CAMERAS = {
  front: { ...PERSPECTIVE, ...FRONT },
  quarter: { ...PERSPECTIVE, ...THREE_QUARTER },
  ortho: { ...ORTHOGRAPHIC, ...FRONT },
  'ortho-quarter': { ...ORTHOGRAPHIC, ...THREE_QUARTER },
  // The up vector is not perpendicular to the view.
  tilted: { ...PERSPECTIVE, position: [-1.8, 2.6, 3], target: [0.1, -0.1, 0], up: [0.3, 1, 0.1] },
};

/** Stands for the case's own environment file in a shot; each side puts the bytes in its place. */
export const CASE_ENVIRONMENT = 'case.hdr';

/**
 * A resolved shot.
 * @param {object} [overrides] - Keys of a shot; `size` may be a number of pixels, `camera` a name in CAMERAS.
 * @param {object} [bounds] - {min, max} of the model; needed where the camera is a view.
 */
export function shot({ size = 256, camera = 'quarter', ...rest } = {}, bounds = undefined) {
  return resolveShot(
    {
      environment: 'none',
      output: { format: 'raw' },
      ...rest,
      size: typeof size === 'number' ? { width: size, height: size } : size,
      camera: typeof camera === 'string' ? CAMERAS[camera] : camera,
    },
    bounds,
  );
}

/** Lights that the cases share; colours linear, candela, lux, radians, metres. */
export const LIGHTS = {
  ambient: { type: 'ambient', color: [1, 0.95, 0.9], intensity: 0.6 },
  hemisphere: { type: 'hemisphere', color: [0.8, 0.9, 1], groundColor: [0.5, 0.35, 0.2], intensity: 1.2 },
  directional: { type: 'directional', color: [1, 0.98, 0.95], intensity: 2.5, position: [2, 3, 2.5], target: [0, 0, 0] },
  point: { type: 'point', color: [1, 0.8, 0.6], intensity: 6, position: [-1.2, 1.1, 1.3], range: 0 },
  'point-range': { type: 'point', color: [0.6, 0.8, 1], intensity: 9, position: [1.1, 1.2, 1.4], range: 3 },
  spot: { type: 'spot', color: [1, 0.9, 0.7], intensity: 20, position: [1.5, 2, 2], target: [0, -0.2, 0], range: 0, angle: 0.35, penumbra: 0.4 },
  'spot-hard': { type: 'spot', color: [0.7, 1, 0.9], intensity: 20, position: [-1.5, 2, 2], target: [0.2, 0, 0.2], range: 6, angle: 0.3, penumbra: 0 },
};
