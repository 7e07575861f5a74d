/**
 * Cameras of a shot made from others. Degrees and metres; every camera is one that resolveShot takes, without a default of
 * its own.
 */

const DEGREE = Math.PI / 180;

/** At the poles the azimuth would be lost. */
const MAX_ELEVATION = 89.9 * DEGREE;

/** How a view frames, whatever its direction. */
const FRAMING = ['fit', 'frame', 'fitTo'];

const lensOf = ({ projection, fovY, height }) => (projection === 'perspective' ? { projection, fovY } : { projection, height });

/** The resolved camera as one placed by the caller, with planes that are fitted again. */
const placed = (resolved) => ({ ...lensOf(resolved), position: resolved.position, target: resolved.target, up: resolved.up });

const isFramed = (camera) => camera?.position === undefined && camera?.gltf === undefined;

/**
 * A named view that frames the model as the camera before it did.
 * @param {object | undefined} camera of the shot
 * @param {object} resolved the same resolved
 * @param {string} view
 */
export function withView(camera, resolved, view) {
  const { projection, fovY } = resolved;
  const framing = FRAMING.filter((key) => camera?.[key] !== undefined).map((key) => [key, camera[key]]);
  return { view, projection, ...(projection === 'perspective' && { fovY }), ...Object.fromEntries(framing) };
}

/** The same camera with another projection; one that stands at a place keeps the size of its target in the picture. */
export function withProjection(camera, resolved, projection) {
  if (isFramed(camera)) {
    const { fovY, ...rest } = camera ?? {};
    return { ...rest, projection };
  }
  if (projection === resolved.projection) return camera;
  const { position, target, up } = resolved;
  const distance = Math.hypot(...position.map((p, i) => p - target[i]));
  const lens =
    projection === 'orthographic'
      ? { height: 2 * distance * Math.tan((resolved.fovY / 2) * DEGREE) }
      : { fovY: (2 * Math.atan(resolved.height / 2 / distance)) / DEGREE };
  return { projection, ...lens, position, target, up };
}

/** @param {number} fovY degrees; perspective only */
export const withFovY = (camera, resolved, fovY) => (isFramed(camera) ? { ...camera, fovY } : { ...placed(resolved), fovY });

/** @param {number} fit above 0; for a camera that frames the model */
export const withFit = (camera, fit) => ({ ...camera, fit });

/** @param {number} gltf index of a camera in the model */
export const withModelCamera = (gltf) => ({ gltf });

/** The camera in the hands of OrbitControls, upright. */
export function fromControls(resolved, { position, target, zoom }) {
  const lens = lensOf(resolved);
  if (lens.height !== undefined) lens.height /= zoom;
  return { ...lens, position: position.toArray(), target: target.toArray() };
}

/**
 * The camera moved about its target, upright.
 * @param {object} resolved
 * @param {{turn?: number, tilt?: number, zoom?: number}} by degrees to the right, degrees up, factor nearer
 */
export function orbited(resolved, { turn = 0, tilt = 0, zoom = 1 }) {
  const { position, target, projection } = resolved;
  const [x, y, z] = position.map((p, i) => p - target[i]);
  const distance = Math.hypot(x, y, z);
  const azimuth = Math.atan2(x, z) + turn * DEGREE;
  const elevation = Math.max(-MAX_ELEVATION, Math.min(MAX_ELEVATION, Math.asin(y / distance) + tilt * DEGREE));
  const reach = projection === 'perspective' ? distance / zoom : distance;
  const flat = reach * Math.cos(elevation);
  const lens = lensOf(resolved);
  if (lens.height !== undefined) lens.height /= zoom;
  const offset = [flat * Math.sin(azimuth), reach * Math.sin(elevation), flat * Math.cos(azimuth)];
  return { ...lens, position: offset.map((d, i) => target[i] + d), target };
}
