import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { resolveShot } from '../../../js/shot/index.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';
import { applyShading, applyShot, rendererParameters } from '../../../js/three/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';

const CAMERA = { position: [1, 2, 3], target: [0, 0.5, 0], near: 0.5, far: 9 };
const resolve = (shot = {}) => resolveShot({ environment: 'none', camera: CAMERA, ...shot });

/** The part of WebGLRenderer that a shot sets; a real one needs a browser (test/parity). */
function recorder() {
  const calls = {};
  const record =
    (name) =>
    (...args) =>
      (calls[name] = args);
  return { calls, shadowMap: {}, setPixelRatio: record('setPixelRatio'), setSize: record('setSize'), setClearColor: record('setClearColor') };
}

async function apply(shot, extra = {}) {
  const scene = extra.scene ?? new THREE.Scene();
  const renderer = recorder();
  const camera = await applyShot(resolve(shot), { THREE, renderer, scene, ...extra });
  return { scene, renderer, camera };
}

const load = async (name) => {
  const bytes = await MODELS[name]();
  return new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
};

test('size, tone mapping and exposure reach the renderer; the drawing buffer is cleared to nothing', async () => {
  const { renderer } = await apply({ size: { width: 320, height: 200 }, toneMapping: 'agx', exposure: 0.7 });
  assert.deepEqual(renderer.calls, { setPixelRatio: [1], setSize: [320, 200, false], setClearColor: [0, 0] });
  assert.equal(renderer.toneMapping, THREE.AgXToneMapping);
  assert.equal(renderer.toneMappingExposure, 0.7);
  assert.equal(renderer.outputColorSpace, THREE.SRGBColorSpace);
});

test('a lens exposes: a surface of 1.2 * 2^EV100 nit becomes 1', async () => {
  const lens = { aperture: 2.8, shutter: 1 / 60, iso: 400 };
  const ev100 = Math.log2((2.8 ** 2 * 60 * 100) / 400);
  const { renderer } = await apply({ exposure: 3, lens });
  assert.ok(Math.abs(renderer.toneMappingExposure / (3 / (1.2 * 2 ** ev100)) - 1) < 1e-12);
  assert.equal((await apply({ lens: { aperture: 2.8, focusDistance: 1 } })).renderer.toneMappingExposure, 1);
});

test('every tone mapping of the shot has its three.js constant', async () => {
  const names = {
    none: THREE.NoToneMapping,
    linear: THREE.LinearToneMapping,
    reinhard: THREE.ReinhardToneMapping,
    cineon: THREE.CineonToneMapping,
    aces: THREE.ACESFilmicToneMapping,
    agx: THREE.AgXToneMapping,
    neutral: THREE.NeutralToneMapping,
  };
  for (const [toneMapping, constant] of Object.entries(names)) assert.equal((await apply({ toneMapping })).renderer.toneMapping, constant);
  const drawn = await Promise.all(Object.keys(TONE_MAPPINGS).map(async (toneMapping) => (await apply({ toneMapping })).renderer.toneMapping));
  assert.ok(drawn.every(Number.isInteger) && new Set(drawn).size === drawn.length, `${drawn}`);
});

test('a perspective camera stands, looks and clips as the shot says', async () => {
  const { camera } = await apply({ size: { width: 300, height: 200 }, camera: { ...CAMERA, fovY: 25 } });
  assert.ok(camera.isPerspectiveCamera);
  assert.deepEqual([camera.fov, camera.aspect, camera.near, camera.far], [25, 1.5, 0.5, 9]);
  const seen = new THREE.Vector3(...CAMERA.target).project(camera);
  assert.ok(Math.hypot(seen.x, seen.y) < 1e-12);
});

test('an orthographic camera sees `height` metres; a given camera of that kind is used', async () => {
  const given = new THREE.OrthographicCamera();
  const { camera } = await apply({ size: { width: 300, height: 200 }, camera: { ...CAMERA, projection: 'orthographic', height: 4 } }, { camera: given });
  assert.equal(camera, given);
  assert.deepEqual([camera.left, camera.right, camera.top, camera.bottom], [-3, 3, 2, -2]);
  const other = await apply({}, { camera: given });
  assert.ok(other.camera.isPerspectiveCamera);
});

test('lights have linear colours, units and targets of the shot, and replace those of the last shot', async () => {
  const lights = [
    { type: 'ambient', color: [0.1, 0.2, 0.3], intensity: 2 },
    { type: 'hemisphere', color: [1, 1, 1], groundColor: [0.5, 0.25, 0], intensity: 3 },
    { type: 'directional', intensity: 4, position: [1, 2, 3], target: [0, 1, 0] },
    { type: 'point', intensity: 5, position: [4, 5, 6], range: 7 },
    { type: 'spot', intensity: 6, position: [1, 1, 1], target: [0, 0, 1], range: 8, angle: 0.4, penumbra: 0.3 },
  ];
  const { scene } = await apply({ lights });
  await apply({ lights }, { scene });
  const found = [];
  scene.traverse((object) => object.isLight && found.push(object));
  const [ambient, hemisphere, directional, point, spot] = found;
  assert.equal(found.length, 5);
  assert.deepEqual(ambient.color.toArray(), [0.1, 0.2, 0.3]);
  assert.deepEqual([hemisphere.groundColor.toArray(), hemisphere.intensity], [[0.5, 0.25, 0], 3]);
  assert.deepEqual(
    [directional.position.toArray(), directional.target.position.toArray()],
    [
      [1, 2, 3],
      [0, 1, 0],
    ],
  );
  assert.deepEqual([point.distance, point.decay, point.intensity], [7, 2, 5]);
  assert.deepEqual([spot.distance, spot.angle, spot.penumbra, spot.decay, spot.target.position.z], [8, 0.4, 0.3, 2, 1]);
});

test("a rect light looks at its target and gets three's tables, once", async () => {
  const rect = { type: 'rect', intensity: 7, position: [0, 2, 0], target: [0, 0, 0], width: 0.5, height: 1.5 };
  await assert.rejects(apply({ lights: [rect] }), /give applyShot areaLightTables, a function that imports three\/addons\/lights\/RectAreaLightUniformsLib/);
  await assert.rejects(apply({ lights: [rect] }, { areaLightTables: async () => ({ RectAreaLightUniformsLib: { init() {} } }) }), /another copy of three\.js/);
  let loads = 0;
  const areaLightTables = () => import('three/addons/lights/RectAreaLightUniformsLib.js').finally(() => loads++);
  await apply({ lights: [{ type: 'point' }] }, { areaLightTables });
  assert.equal(loads, 0);
  const { scene } = await apply({ lights: [rect] }, { areaLightTables });
  await apply({ lights: [rect] });
  assert.equal(loads, 1);
  const light = scene.getObjectByProperty('isRectAreaLight', true);
  assert.deepEqual([light.width, light.height, light.intensity], [0.5, 1.5, 7]);
  const shines = new THREE.Vector3(0, 0, -1).applyQuaternion(light.quaternion);
  assert.ok(shines.distanceTo(new THREE.Vector3(0, -1, 0)) < 1e-3, 'along its own -z');
});

test('the environment behind the model is blurred as the shot says, and sharp again after', async () => {
  const environment = new THREE.DataTexture(new Uint16Array(8 * 4 * 4), 8, 4);
  const { scene } = await apply({ environment: 'a.hdr', background: { blur: 0.4 } }, { environment });
  assert.equal(scene.background, environment);
  assert.equal(scene.backgroundBlurriness, 0.4);
  await apply({ environment: 'a.hdr', background: 'environment' }, { environment, scene });
  assert.equal(scene.backgroundBlurriness, 0);
});

test('environment: equirectangular, intensity and rotation in radians, for light and background alike', async () => {
  const environment = new THREE.DataTexture(new Uint16Array(8 * 4 * 4), 8, 4);
  const shot = { environment: { map: 'a.hdr', intensity: 0.5, rotation: 90 }, background: 'environment' };
  const { scene } = await apply(shot, { environment });
  assert.equal(environment.mapping, THREE.EquirectangularReflectionMapping);
  assert.equal(scene.environment, environment);
  assert.equal(scene.background, environment);
  assert.deepEqual([scene.environmentIntensity, scene.backgroundIntensity], [0.5, 0.5]);
  assert.deepEqual([scene.environmentRotation.y, scene.backgroundRotation.y], [Math.PI / 2, Math.PI / 2]);
  await apply({}, { scene });
  assert.deepEqual([scene.environment, scene.background], [null, null]);
});

test('a shot with an environment needs its texture', async () => {
  await assert.rejects(apply({ environment: 'studio' }), /give applyShot the loaded equirectangular texture/);
});

test('a background colour is linear', async () => {
  const { scene } = await apply({ background: 'rgb(128, 0, 255)' });
  assert.ok(Math.abs(scene.background.r - 0.2158605) < 1e-6);
});

test('lights of the model are shown or hidden', async () => {
  const model = await load('model-lights');
  const visible = () => {
    const list = [];
    model.scene.traverse((object) => object.isLight && list.push(object.visible));
    return list;
  };
  await apply({ modelLights: false }, { model });
  assert.deepEqual(visible(), [false, false, false]);
  await apply({}, { model });
  assert.deepEqual(visible(), [true, true, true]);
});

test("a variant changes the meshes that it maps, and an empty one gives the file's own materials back", async () => {
  const model = await load('variants');
  const roughness = () => {
    const list = [];
    model.scene.traverse((object) => object.isMesh && list.push(object.material.roughness));
    return list;
  };
  assert.deepEqual(roughness(), [0.5, 0.5]);
  for (const [variant, expected] of [
    ['blue', [0.8, 0.2]],
    ['red', [0.3, 0.5]],
    ['', [0.5, 0.5]],
    ['blue', [0.8, 0.2]],
  ]) {
    await apply({ variant }, { model });
    assert.deepEqual(
      roughness().map((value) => Number(value.toFixed(6))),
      expected,
      `variant "${variant}"`,
    );
  }
  await assert.rejects(apply({ variant: 'green' }, { model }), /the model has red, blue, not green/);
});

test('calls for one scene take effect in their order, also while an earlier one still loads', async () => {
  const model = await load('variants');
  const [scene, renderer] = [new THREE.Scene(), recorder()];
  const before = model.parser.getDependency.bind(model.parser);
  let calls = 0;
  model.parser.getDependency = async (...args) => {
    if (calls++ === 0) await new Promise((resolve) => setTimeout(resolve, 50));
    return before(...args);
  };
  const [{ name }] = model.parser.json.extensions.KHR_materials_variants.variants;
  const materials = () => {
    const found = [];
    model.scene.traverse(({ material }) => material && found.push(material.uuid));
    return found;
  };
  const own = materials();
  const asked = { THREE, renderer, scene, model };
  const first = applyShot({ ...resolve(), variant: name }, asked);
  const second = applyShot(resolve(), asked);
  await Promise.all([first, second]);
  assert.ok(calls > 0);
  assert.deepEqual(materials(), own, 'the last one asked for no variant');
  // One that fails does not hold up the next.
  await assert.rejects(applyShot({ ...resolve(), variant: 'none such' }, asked));
  await applyShot({ ...resolve(), variant: name }, asked);
  assert.notDeepEqual(materials(), own);
});

test('a mesh that was a ghost in the last shot casts a shadow in the next one', async () => {
  const model = await load('variants');
  const scene = new THREE.Scene();
  await apply({ ghost: [{ material: 0, opacity: 0.5 }] }, { scene, model });
  const casting = { environment: 'none', camera: CAMERA, lights: [{ type: 'directional', castShadow: true }] };
  await applyShot(resolveShot(casting, { min: [-1, -1, -1], max: [1, 1, 1] }), { THREE, renderer: recorder(), scene, model });
  const meshes = [];
  model.scene.traverse((object) => object.isMesh && meshes.push(object.castShadow));
  assert.ok(meshes.length > 0 && meshes.every(Boolean), `${meshes}`);
});

/** Materials of a model's meshes. */
function shownBy(model) {
  const found = [];
  model.scene.traverse(({ material }) => material && found.push(material));
  return found;
}

test('ghosts are kept from shot to shot, go with their material, and are of one model each', async () => {
  const model = await load('variants');
  const other = await load('variants');
  const own = shownBy(model);
  other.scene.traverse((object) => object.isMesh && (object.material = own[0]));
  const ghost = (opacity) => ({ ghost: [{ material: '*', opacity }] });
  await apply(ghost(0.5), { model });
  const ghosts = shownBy(model);
  assert.ok(ghosts.every((material) => !own.includes(material) && material.opacity === 0.5));
  own[0].roughness = 0.125;
  await apply(ghost(0.25), { model });
  assert.deepEqual(shownBy(model), ghosts);
  await apply(ghost(0.75), { model: other });
  assert.deepEqual([ghosts[0].opacity, ghosts[0].roughness, shownBy(other)[0].opacity], [0.25, 0.125, 0.75]);
  await apply({}, { model });
  assert.deepEqual(shownBy(model), own);
  const gone = [];
  for (const material of ghosts) material.addEventListener('dispose', () => gone.push(material));
  for (const material of new Set(own)) material.dispose();
  assert.deepEqual(new Set(gone), new Set(ghosts));
});

test('a ghost that a client has shaded is none in the next shot', async () => {
  const model = await load('variants');
  const own = shownBy(model);
  await apply({ ghost: [{ material: '*', opacity: 0.5 }] }, { model });
  await applyShading(model, 'fabric', { THREE });
  assert.ok(shownBy(model).every(({ isFabricMaterial }) => isFabricMaterial));
  await apply({}, { model });
  assert.deepEqual(shownBy(model), own);
});

test('nothing of a shot that is refused half-way is left in the next one', async () => {
  const model = await load('variants');
  const scene = new THREE.Scene().add(model.scene);
  const target = { scene, model };
  const shot = { variant: 'red', background: 'red', ghost: [{ material: '*', opacity: 0.5 }], lights: [{ type: 'directional', position: [1, 1, 1] }] };
  const state = () => {
    const found = [];
    scene.traverse(({ type, material, castShadow, visible }) => found.push([type, material?.uuid, material?.opacity, castShadow, visible]));
    return [found, scene.background.getHex(), scene.environment];
  };
  await apply(shot, target);
  const before = state();
  for (const refused of [
    { lights: [{ type: 'point' }, { type: 'disk' }] },
    { environment: 'studio' },
    { materials: { nothing: { color: 'red' } } },
    { materials: { '*': { preset: 'denim' } }, variant: 'blue' },
  ]) {
    await assert.rejects(apply(refused, target));
    await apply(shot, target);
    assert.deepEqual(state(), before, JSON.stringify(refused));
  }
});

test('one sample a pixel asks for a context without antialiasing', () => {
  assert.deepEqual(rendererParameters(resolve()), { antialias: true, alpha: true, premultipliedAlpha: true });
  assert.equal(rendererParameters(resolve({ quality: 'draft' })).antialias, false);
});
