import { VIEWS } from './frame.mjs';
import { parseShot, resolveWithoutModel } from './resolve.mjs';
import { filterOf } from './shadow.mjs';
import { DEFAULT_FOV_Y } from './table/camera.mjs';

/**
 * What a shot asks for, whatever the model: every default that does not depend on the model is written out, and what is the
 * same said in two ways is said in one. Two shots with the same identity give the same picture of the same model.
 * @param {object} shot not resolved
 * @returns {object} plain data; `environment.map` as given
 * @throws {import('../error/index.mjs').TelarError} E_SHOT
 */
export function shotIdentity(shot) {
  const parsed = parseShot(shot);
  return {
    ...parsed,
    ...resolveWithoutModel(parsed),
    ...(modelDecidesSize(shot, parsed) && { size: null }),
    camera: cameraIdentity(parsed.camera),
    lights: parsed.lights.map(lightIdentity),
    // As a list: the order in which cloths are put on counts.
    materials: Object.entries(parsed.materials),
  };
}

/** Whether the model decides the size, by its scale: the default in its place would be another picture. */
const modelDecidesSize = ({ size }, { scale, camera }) => scale !== 'none' && size === undefined && camera.position === undefined;

function cameraIdentity(camera) {
  if (camera.gltf !== undefined) return camera;
  const { view, azimuth, elevation, ...rest } = camera;
  const projection = camera.projection ?? (camera.height === undefined ? 'perspective' : 'orthographic');
  const lens = projection === 'perspective' && { fovY: camera.fovY ?? DEFAULT_FOV_Y };
  if (camera.position !== undefined) return { ...rest, projection, ...lens };
  // A view beside angles is refused when it is drawn: it is no other word for a picture that may be kept.
  const angles = azimuth === undefined && elevation === undefined ? VIEWS[view ?? 'front'] : { view, azimuth: azimuth ?? 0, elevation: elevation ?? 0 };
  return { ...rest, ...lens, ...angles };
}

/** `radius` alone is a shape: the shadow's own lies beneath `shadow`. */
const lightIdentity = (light) => (light.castShadow ? { ...light, shadow: { ...light.shadow, ...filterOf(light) } } : light);
