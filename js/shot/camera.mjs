import { TelarError } from '../error/index.mjs';
import { nearest, shown, wrongValue } from './complain.mjs';
import { VIEWS, cross, depthRangeOf, frameBounds, length, subtract, viewBasis } from './frame.mjs';
import { boundsOfPart, isPart } from './part.mjs';
import { DEFAULT_FOV_Y, camera as CAMERA } from './table/camera.mjs';
import { copied, inOrder } from './table/resolved.mjs';
import { TINY } from './table/rows.mjs';

/** Sine of the angle between `up` and the view axis below which the frame has no defined roll. */
const PARALLEL = 1e-9;

/** What a camera must show beside the model. */
const NOTHING = Object.freeze({ corners: [], shadow: [] });

/**
 * @param {object} camera as the schema parsed it: a view, an explicit camera or {gltf}
 * @param {number} aspect width / height
 * @param {ReturnType<import('./facts.mjs').readFacts>} facts
 * @param {{corners: import('./frame.mjs').Vec3[], shadow: import('./frame.mjs').Vec3[], trueHeight?: number}} [ground] its corners, which
 *   must lie between near and far, and those of the shadow on it, which must be in the frame, as far as one of `trueHeight` metres holds it
 * @returns {object} explicit camera: {projection, position, target, up, fovY | height, near, far}
 */
export function resolveCamera(camera, aspect, facts, ground = NOTHING) {
  if (camera.gltf !== undefined) return complete(modelCamera(camera.gltf, facts), facts, ground.corners);
  if (camera.position !== undefined) return complete(camera, facts, ground.corners);
  return frameView(camera, aspect, facts, ground);
}

/** The box with further points in it. */
const widened = ({ min, max }, extras) => ({
  min: min.map((low, axis) => Math.min(low, ...extras.map((point) => point[axis]))),
  max: max.map((high, axis) => Math.max(high, ...extras.map((point) => point[axis]))),
});

function frameView(camera, aspect, facts, ground) {
  const { view, azimuth, elevation, projection, fit, fitTo, frame } = camera;
  if (view !== undefined && (azimuth !== undefined || elevation !== undefined)) {
    throw wrongValue(['camera', 'view'], 'a named view, or azimuth and elevation, not both', view);
  }
  const fovY = lensOf(camera, projection).fovY;
  const angles = azimuth === undefined && elevation === undefined ? VIEWS[view ?? 'front'] : { azimuth: azimuth ?? 0, elevation: elevation ?? 0 };
  const whole = needBounds(facts, 'camera');
  const seen = isPart(frame) ? boundsOfPart(frame, facts) : whole;
  const place = (shadow) =>
    frameBounds(seen, { ...angles, projection, fovY, fit, fitTo }, aspect, { shadow, ground: ground.corners, whole, trueHeight: ground.trueHeight });
  const alone = place([]);
  const placed = frame === 'scene' && seesGround(alone, ground, { ...angles, projection, fitTo }) ? place(ground.shadow) : alone;
  const planes = ground.corners.length > 0 ? depthRangeOf(widened(whole, ground.corners), { ...placed, projection }, [whole, seen]) : {};
  const framed = { ...camera, fovY, ...placed, ...planes };
  refuseTiny(seen, projection === 'perspective' ? framed.near : framed.height);
  return ordered(framed);
}

/** What is smaller than any camera can draw. @throws {TelarError} E_EXTENT */
function refuseTiny(bounds, distance) {
  if (distance >= TINY) return;
  const diagonal = length(subtract(bounds.max, bounds.min)).toPrecision(3);
  throw new TelarError(
    'E_EXTENT',
    `what is framed is ${diagonal} m across, too small to be drawn; glTF is in metres: check the unit and the scale of the export`,
  );
}

/** Whether there is a shadow to be seen: from beneath, the ground is not. Views in all directions share what one of them needs. */
function seesGround({ position }, { shadow }, { azimuth, elevation, projection, fitTo }) {
  if (shadow.length === 0) return false;
  if (fitTo === 'all') return true;
  return projection === 'perspective' ? position[1] > shadow[0][1] : viewBasis(azimuth, elevation).back[1] > 0;
}

/** fovY or height, whichever the projection has; the other one is refused. */
function lensOf({ fovY, height }, projection) {
  if (projection === 'perspective') {
    if (height !== undefined) throw wrongValue(['camera', 'height'], 'no height with the perspective projection', height);
    return { fovY: fovY ?? DEFAULT_FOV_Y };
  }
  if (fovY !== undefined) throw wrongValue(['camera', 'fovY'], 'no fovY with the orthographic projection', fovY);
  return { height };
}

/** An explicit camera with everything written out. */
function complete(camera, facts, extras) {
  const { position, target, up } = camera;
  const projection = camera.projection ?? (camera.height === undefined ? 'perspective' : 'orthographic');
  const { fovY, height } = lensOf(camera, projection);
  if (projection === 'orthographic' && height === undefined) {
    throw wrongValue(['camera', 'height'], 'a height in metres for the orthographic projection', height);
  }
  const axis = subtract(target, position);
  if (!(length(axis) > 0)) throw wrongValue(['camera', 'target'], 'a point other than the position', target);
  if (!(length(cross(axis, up)) > PARALLEL * length(axis) * length(up))) {
    throw wrongValue(['camera', 'up'], 'a direction that is not along the view', up);
  }
  const isFitted = camera.near === undefined || camera.far === undefined;
  const fitted = isFitted ? fittedPlanes({ position, target, projection }, needBounds(facts, 'camera.near and camera.far'), extras) : {};
  if (isFitted && projection === 'perspective' && camera.near === undefined) refuseTiny(facts.bounds, fitted.near);
  const { near = Math.min(fitted.near, camera.far / 2 || Infinity), far = Math.max(fitted.far, 2 * camera.near || 0) } = camera;
  if (projection === 'perspective' && !(near > 0)) throw wrongValue(['camera', 'near'], 'a distance above 0', near);
  if (!(far > near)) throw wrongValue(['camera', 'far'], `a distance beyond near (${near})`, far);
  return ordered({ ...camera, projection, fovY, height, near, far });
}

/** A ground may push far out, and never near into the model. */
const fittedPlanes = (camera, bounds, extras) => depthRangeOf(widened(bounds, extras), camera, [bounds]);

function needBounds({ bounds }, what) {
  if (bounds) return bounds;
  throw new TelarError('E_NO_GEOMETRY', `shot.${what}: the model has nothing to frame; give an explicit camera with near and far`);
}

/** A camera of the model as an explicit one. A missing or zero far plane is infinite in glTF: it is fitted then. */
function modelCamera(wanted, { cameras = [] }) {
  const found = typeof wanted === 'number' ? cameras[wanted] : cameras.find(({ name }) => name === wanted);
  if (!found) throw new TelarError('E_CAMERA', missingCamera(wanted, cameras), { pointer: '/camera/gltf' });
  const { projection, position, target, up, fovY, height, near, far } = found;
  if (projection === 'orthographic' && !(height >= TINY)) {
    throw new TelarError('E_CAMERA', `shot.camera.gltf: the model's camera ${shown(wanted)} shows ${height} m; expected at least ${TINY}`, {
      pointer: '/camera/gltf',
    });
  }
  return {
    projection,
    position,
    target,
    up,
    ...(projection === 'perspective' ? { fovY } : { height }),
    ...(near && { near }),
    ...(far && { far }),
  };
}

function missingCamera(wanted, cameras) {
  if (cameras.length === 0) return `shot.camera.gltf: the model has no camera ${shown(wanted)}; it has none`;
  const names = cameras
    .slice(0, 8)
    .map(({ name }, index) => `${index}${name ? ` ${shown(name)}` : ''}`)
    .join(', ');
  const near =
    typeof wanted === 'string'
      ? nearest(
          wanted,
          cameras.map(({ name }) => name ?? ''),
        )
      : undefined;
  return `shot.camera.gltf: the model has no camera ${shown(wanted)}; ${near ? `did you mean ${shown(near)}?` : `it has ${names}`}`;
}

const ordered = (camera) => copied(inOrder(CAMERA.resolved.of[camera.projection], camera));
