import { lensExposure } from '../shot/lens_exposure.mjs';
import { meteredSize } from '../shot/metering.mjs';
import { TONE_MAPPINGS } from '../shot/table/tone_mappings.mjs';
import { isRelease } from '../shot/three_terms.mjs';
import { recallAssociations } from './associations.mjs';
import { putOnCloths, takeOffCloths } from './cloths.mjs';
import { applyOlderOutput, backgroundColor, dimEnvironment, environmentTurned } from './older_release.mjs';
import { applyGhosts, removeGhosts } from './ghost.mjs';
import { applyMetering } from './metering.mjs';
import { applyPose } from './pose.mjs';
import { matchRelease, revisionOf } from './release.mjs';
import { applyLightShadow, applyShadows } from './shadows.mjs';
import { applyShading, restoreMaterials } from './shading.mjs';
import { environmentOf, isCut, keepSuns } from './suns.mjs';
import { applyVariant } from './variant.mjs';

/**
 * Name of the group that holds the shot's own lights, so that the next shot can replace them.
 */
const LIGHT_GROUP = 'telar lights';

/** Last call that is not over, by scene: those of one scene follow each other, so that it shows the last. @type {WeakMap<object, Promise<unknown>>} */
const applying = new WeakMap();

/**
 * Parameters that a THREE.WebGLRenderer must be built with: a canvas cannot change them later.
 *
 * @param {object} shot - Resolved shot.
 * @returns {{antialias: boolean, alpha: boolean, premultipliedAlpha: boolean}} Spread into the constructor's argument.
 */
export function rendererParameters(shot) {
  return { antialias: shot.quality.samples !== 1, alpha: true, premultipliedAlpha: true };
}

/**
 * Sets up a scene of the client's own three.js, 0.150 or later, from the resolved shot that the server takes, so that both draw the
 * same picture. Adds no default of its own: every value comes from `shot`. Calling it again replaces what the last call set; calls for one scene take effect in
 * their order: one waits until the earlier ones have loaded their cloths.
 *
 * @param {object} shot - Resolved shot (`resolveShot`): explicit camera, linear Rec.709 colours, degrees for fovY and
 *   environment.rotation, radians for cone angles, metres.
 * @param {object} target
 * @param {typeof import('three')} target.THREE - The client's own three.js module.
 * @param {import('three').WebGLRenderer} target.renderer - Made with `rendererParameters(shot)`; gets size, tone mapping,
 *   exposure and a clear alpha of 0. Its pixel ratio becomes 1: a shot's size is in pixels of the drawing buffer.
 * @param {import('three').Scene} target.scene - Gets lights, ground, environment and background.
 * @param {import('three').Camera} [target.camera] - Camera to set; where it is missing or of the other projection, a new one
 *   is made. Use the returned one.
 * @param {object} [target.model] - What GLTFLoader gave ({scene, parser, animations}): for `variant`, `pose` and `modelLights`.
 * @param {import('three').Texture} [target.environment] - Linear equirectangular texture; required where the shot has one. Loaded
 *   as FloatType, what it has above 65504 lights every shading but "three", as on the server; halves do not hold that.
 * @param {() => Promise<{RectAreaLightUniformsLib: {init(): void}}>} [target.areaLightTables] - Gives three's tables of rect
 *   lights, `() => import('three/addons/lights/RectAreaLightUniformsLib.js')`; called for the first shot with such a light.
 * @param {(preset: string) => Promise<object>} [target.cloths] - Gives telar/cloths/PRESET.glb as GLTFLoader loads it; called for the presets of
 *   the shot's `materials`.
 * @param {'shot' | 'client'} [target.revision] - What to do where the shot names another release of three.js than `THREE` is and the
 *   two draw differently. "shot", the default, warns on the console. "client" writes the client's release into `shot`: the
 *   server, handed the same shot, then draws as this client does.
 * @returns {Promise<import('three').Camera>} The camera to draw with, matrices up to date.
 * @throws {Error} When the client's release lacks the tone mapping, or the shot needs an environment or the tables of rect lights, and none was given, or names a variant
 *   that the model lacks.
 */
export async function applyShot(shot, target) {
  const { scene } = target;
  const before = applying.get(scene);
  const done = before ? before.then(() => apply(shot, target)) : apply(shot, target);
  const over = done.catch(() => {});
  applying.set(scene, over);
  over.then(() => applying.get(scene) === over && applying.delete(scene));
  return done;
}

async function apply(shot, { THREE, renderer, scene, camera, model, environment, areaLightTables, cloths, revision = 'shot' }) {
  matchRelease(shot, THREE, revision);
  if (model) recallAssociations(model);
  applyOutput(shot, THREE, renderer);
  if (shot.lights.some(({ type }) => type === 'rect')) await prepareAreaLights(THREE, areaLightTables);
  const isStock = isRelease(shot.shading);
  const mapOf = (smallToo) => (shot.environment.map !== 'none' && environment ? environmentOf(THREE, environment, smallToo) : null);
  const lighting = mapOf(shot.shading === 'fabric');
  applyLights(shot, THREE, scene, model, isStock ? [] : lighting?.suns);
  if (lighting && !isStock) warnIfCut(environment);
  // A mesh that was a ghost has its own shadow again.
  if (model) removeGhosts(model.scene);
  applyShadows(shot, THREE, { renderer, scene, model });
  applyEnvironment(shot, THREE, scene, lighting?.texture);
  applyBackground(shot, THREE, scene, () => mapOf(false).texture);
  if (model) applyPose(model, shot.pose, { THREE });
  if (model) await applyMaterials(shot, model, { THREE, cloths });
  dimEnvironment(THREE, scene, shot.environment.intensity);
  const placed = applyCamera(shot, THREE, camera);
  // Its sides are those of the small picture, as on the server: rounded, they have another ratio.
  if (shot.metering) applyMetering(shot, { THREE, renderer, scene, camera: applyCamera({ ...shot, size: meteredSize(shot) }, THREE) });
  return placed;
}

/**
 * The constant of three.js.
 * @param {typeof import('three')} THREE
 * @param {string} name
 */
function toneMappingOf(THREE, name) {
  if (!Object.hasOwn(TONE_MAPPINGS, name)) throw new Error(`shot.toneMapping: expected one of ${Object.keys(TONE_MAPPINGS).join(' ')}, got ${name}`);
  const constant = THREE[TONE_MAPPINGS[name].three];
  if (constant === undefined) throw new Error(`shot.toneMapping: three.js 0.${revisionOf(THREE)} has no tone mapping ${name}`);
  return constant;
}

/** The materials of the variant and the cloths over them, shaded as the shot says. */
async function applyMaterials(shot, model, { THREE, cloths }) {
  restoreMaterials(model.scene);
  // Those that a client has shaded since by applyShading().
  removeGhosts(model.scene);
  takeOffCloths(model.scene);
  await applyVariant(model, shot.variant);
  await putOnCloths(shot, model, { THREE, cloths });
  await applyShading(model, shot.shading, { THREE });
  applyGhosts(model, shot);
}

function applyOutput(shot, THREE, renderer) {
  renderer.setPixelRatio(1);
  renderer.setSize(shot.size.width, shot.size.height, false);
  renderer.outputColorSpace = THREE.SRGBColorSpace;
  applyOlderOutput(THREE, renderer);
  renderer.toneMapping = toneMappingOf(THREE, shot.toneMapping);
  renderer.toneMappingExposure = shot.exposure * lensExposure(shot.lens);
  renderer.setClearColor(0x000000, 0);
}

function applyCamera(shot, THREE, camera) {
  const { projection, position, target, up, fovY, height, near, far } = shot.camera;
  const aspect = shot.size.width / shot.size.height;
  let result = camera;
  if (projection === 'orthographic') {
    if (!camera?.isOrthographicCamera) result = new THREE.OrthographicCamera();
    Object.assign(result, { left: (-height / 2) * aspect, right: (height / 2) * aspect, top: height / 2, bottom: -height / 2 });
  } else {
    if (!camera?.isPerspectiveCamera) result = new THREE.PerspectiveCamera();
    Object.assign(result, { fov: fovY, aspect });
  }
  Object.assign(result, { near, far, zoom: 1 });
  result.position.fromArray(position);
  result.up.fromArray(up);
  result.lookAt(...target);
  result.updateProjectionMatrix();
  result.updateMatrixWorld(true);
  return result;
}

/** A colour of the shot is linear Rec.709, which is three's working space. */
function linearColor(THREE, [r, g, b]) {
  return new THREE.Color().setRGB(r, g, b, THREE.LinearSRGBColorSpace);
}

/** Environments that were looked at. */
const lookedAt = new WeakSet();

function warnIfCut(environment) {
  if (lookedAt.has(environment)) return;
  lookedAt.add(environment);
  if (isCut(environment))
    console.warn(
      'telar: the environment has texels that half floats cut at 65504: load it with setDataType(THREE.FloatType), so that its suns light as on the server',
    );
}

function applyLights(shot, THREE, scene, model, suns = []) {
  const last = scene.getObjectByName(LIGHT_GROUP);
  last?.removeFromParent();
  last?.traverse((object) => object.dispose?.());
  const group = new THREE.Group();
  group.name = LIGHT_GROUP;
  for (const light of shot.lights) addLight(THREE, group, light);
  keepSuns(
    scene,
    suns.map((sun) => addLight(THREE, group, sunLight(THREE, sun, shot.environment))),
  );
  scene.add(group);
  model?.scene.traverse((object) => {
    if (object.isLight) object.visible = shot.modelLights;
  });
}

/** three's physical decay: radiance falls with the square of the distance. */
const INVERSE_SQUARE = 2;

const AREA_LIGHT_TABLES = 'three/addons/lights/RectAreaLightUniformsLib.js';

/** three.js keeps the tables of rect lights in an add-on, and draws such lights black without them. */
async function prepareAreaLights(THREE, areaLightTables) {
  if (THREE.UniformsLib.LTC_FLOAT_1) return;
  if (!areaLightTables)
    throw new Error(
      `shot.lights: a rect light needs tables that three.js keeps apart: give applyShot areaLightTables, a function that imports ${AREA_LIGHT_TABLES}`,
    );
  (await areaLightTables()).RectAreaLightUniformsLib.init();
  if (!THREE.UniformsLib.LTC_FLOAT_1) throw new Error('shot.lights: areaLightTables belongs to another copy of three.js than THREE');
}

/** A sun of the environment as a light of the shot. */
function sunLight(THREE, { direction, irradiance }, { intensity, rotation }) {
  const brightest = Math.max(...irradiance);
  const position = new THREE.Vector3(...direction).applyAxisAngle(new THREE.Vector3(0, 1, 0), THREE.MathUtils.degToRad(rotation));
  return {
    type: 'directional',
    color: irradiance.map((value) => value / brightest),
    intensity: brightest * intensity,
    position: position.toArray(),
    target: [0, 0, 0],
    castShadow: false,
  };
}

function addLight(THREE, group, light) {
  const color = linearColor(THREE, light.color);
  const { intensity, range, angle, penumbra, width, height } = light;
  const make = {
    ambient: () => new THREE.AmbientLight(color, intensity),
    hemisphere: () => new THREE.HemisphereLight(color, linearColor(THREE, light.groundColor), intensity),
    directional: () => new THREE.DirectionalLight(color, intensity),
    point: () => new THREE.PointLight(color, intensity, range, INVERSE_SQUARE),
    spot: () => new THREE.SpotLight(color, intensity, range, angle, penumbra, INVERSE_SQUARE),
    rect: () => new THREE.RectAreaLight(color, intensity, width, height),
  }[light.type];
  if (!make) throw new Error(`shot.lights: stock three.js has no light for the type ${light.type}`);
  const object = make();
  if (light.position) object.position.fromArray(light.position);
  if (object.shadow) applyLightShadow(object, light);
  group.add(object);
  if (object.isRectAreaLight) object.lookAt(...light.target);
  else if (light.target) {
    object.target.position.fromArray(light.target);
    group.add(object.target);
  }
  return object;
}

function applyEnvironment(shot, THREE, scene, environment) {
  const { map, intensity, rotation } = shot.environment;
  if (map === 'none') {
    scene.environment = null;
    return;
  }
  if (!environment) throw new Error('shot.environment: give applyShot the loaded equirectangular texture as `environment`');
  const turned = turnedEnvironment(shot, THREE, environment);
  const y = THREE.MathUtils.degToRad(rotation);
  scene.environment = turned;
  scene.environmentIntensity = intensity;
  scene.environmentRotation?.set(0, y, 0);
  scene.backgroundIntensity = intensity;
  scene.backgroundRotation?.set(0, y, 0);
}

function turnedEnvironment(shot, THREE, environment) {
  const turned = environmentTurned(THREE, environment, shot.environment.rotation);
  turned.mapping = THREE.EquirectangularReflectionMapping;
  return turned;
}

/** scene.backgroundBlurriness of a background that is the environment as it is. */
const SHARP = 0;

/** @param {() => import('three').Texture} wholeMap - With all lights, which are seen in it. */
function applyBackground(shot, THREE, scene, wholeMap) {
  if (shot.background === 'transparent') scene.background = null;
  else if (shot.background === 'environment' || shot.background.type === 'environment') {
    if (!scene.environment) throw new Error('shot.background: "environment" needs an environment');
    scene.background = turnedEnvironment(shot, THREE, wholeMap());
    scene.backgroundBlurriness = shot.background.blur ?? SHARP;
  } else scene.background = backgroundColor(THREE, linearColor(THREE, shot.background));
}
