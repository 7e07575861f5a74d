import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import * as THREE from 'three';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { resolveShot } from '../../../js/shot/index.mjs';
import { applyShot, loadFabricMaterial } from '../../../js/three/index.mjs';
import { ENVIRONMENTS } from '../../fixtures/index.mjs';

const CAMERA = { position: [1, 2, 3], target: [0, 0.5, 0], near: 0.5, far: 9 };
const WIDTH = 16;
const HEIGHT = 8;
const RADIANCE = [3e5, 2e5, 100];

const texturesMade = () => {
  const parse = (type) => {
    const { data, width, height, flipY } = new HDRLoader().setDataType(type).parse(ENVIRONMENTS['bright-suns']().buffer);
    return Object.assign(new THREE.DataTexture(data, width, height, THREE.RGBAFormat, type), { flipY, colorSpace: THREE.LinearSRGBColorSpace });
  };
  return { floats: parse(THREE.FloatType), halves: parse(THREE.HalfFloatType) };
};

/** A sun in the second row from the top, column 12. */
function sunTexture(flipY) {
  const data = new Float32Array(WIDTH * HEIGHT * 4).fill(0.5);
  const row = flipY ? 1 : HEIGHT - 2;
  data.set([...RADIANCE, 1], (row * WIDTH + 12) * 4);
  return Object.assign(new THREE.DataTexture(data, WIDTH, HEIGHT, THREE.RGBAFormat, THREE.FloatType), { flipY });
}

async function apply(shot, environment, scene = new THREE.Scene()) {
  const renderer = { shadowMap: {}, setPixelRatio() {}, setSize() {}, setClearColor() {} };
  await applyShot(resolveShot({ environment: 'a.hdr', camera: CAMERA, ...shot }), { THREE, renderer, scene, environment });
  return scene;
}

const sunsIn = (scene) => scene.getObjectByName('telar lights').children.filter(({ isDirectionalLight }) => isDirectionalLight);

for (const flipY of [true, false]) {
  test(`a small light becomes a directional light, ${flipY ? 'the top' : 'the bottom'} row first`, async () => {
    const shot = { shading: 'fabric', environment: { map: 'a.hdr', intensity: 0.5, rotation: 90 } };
    const [sun, ...others] = sunsIn(await apply(shot, sunTexture(flipY)));
    assert.deepEqual(others, []);
    const angle = ((2 * Math.PI) / WIDTH) * (Math.cos(Math.PI / HEIGHT) - Math.cos((2 * Math.PI) / HEIGHT));
    // Up to a hundred times the mean, and what a half holds, it stays in the map.
    const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const mean = 0.5 + ((luminance(RADIANCE) - 0.5) * angle) / (4 * Math.PI);
    const share = 1 - Math.min((100 * mean) / luminance(RADIANCE), 65504 / RADIANCE[0]);
    const expected = RADIANCE.map((value) => 0.5 * angle * share * value);
    const light = sun.color.clone().multiplyScalar(sun.intensity).toArray();
    light.forEach((value, c) => assert.ok(Math.abs(value - expected[c]) < 1e-9 * expected[0], `${light} for ${expected}`));
    // Column 12.5 of 16 is 281.25 degrees from the map's left edge, which is -X; a quarter turn about +Y takes +X to -Z.
    const [phi, theta] = [(12.5 / WIDTH - 0.5) * 2 * Math.PI, (1.5 * Math.PI) / HEIGHT];
    const [x, y, z] = [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)];
    assert.ok(sun.position.distanceTo(new THREE.Vector3(z, y, -x)) < 1e-12, sun.position.toArray().join(' '));
    assert.equal(sun.castShadow, false);
  });
}

test('the materials of cloth know the suns of the scene that they are drawn in by their colours', async () => {
  const material = new (await loadFabricMaterial(THREE))();
  const sunny = await apply({ shading: 'fabric', environment: { map: 'a.hdr', intensity: 0.5 } }, sunTexture(true));
  /** What its program is compiled with and gets. */
  const drawnIn = (scene) => {
    const { version } = material;
    material.onBeforeRender({}, scene);
    const { sunColors } = material.textUniforms();
    return { defined: material.textDefines().SUNS, colors: sunColors.value.map((color) => color.toArray()), compiled: material.version > version };
  };
  const [sun] = sunsIn(sunny);
  const uploaded = (light) => light.color.clone().multiplyScalar(light.intensity).toArray();
  assert.deepEqual(drawnIn(sunny), { defined: 1, colors: [uploaded(sun)], compiled: true });
  sun.intensity *= 0.3; // by a client
  assert.deepEqual(drawnIn(sunny), { defined: 1, colors: [uploaded(sun)], compiled: false });
  assert.deepEqual(drawnIn(new THREE.Scene()), { defined: 0, colors: [], compiled: true });
  await apply({ shading: 'fabric', environment: 'none' }, undefined, sunny);
  assert.deepEqual(drawnIn(sunny).colors, []);
});

test('the stock shading has no suns; another shot takes them out again', async () => {
  const environment = sunTexture(true);
  const scene = await apply({ shading: 'fabric' }, environment);
  assert.equal(sunsIn(scene).length, 1);
  const texture = scene.environment;
  await apply({ shading: 'three' }, environment, scene);
  assert.equal(sunsIn(scene).length, 0);
  assert.notEqual(scene.environment, texture, 'the whole map');
  await apply({ shading: 'fabric' }, environment, scene);
  assert.equal(scene.environment, texture, 'the same halves, prefiltered once');
  await apply({ shading: 'fabric', environment: 'none' }, environment, scene);
  assert.equal(sunsIn(scene).length, 0);
});

test('the halves are those that the loader gives by default', async () => {
  const { floats, halves } = texturesMade();
  const { environment } = await apply({}, floats);
  assert.deepEqual(environment.image.data, halves.image.data);
  for (const key of ['type', 'format', 'flipY', 'colorSpace', 'minFilter', 'magFilter', 'wrapS', 'wrapT', 'generateMipmaps'])
    assert.equal(environment[key], halves[key], key);
  assert.equal(environment.mapping, THREE.EquirectangularReflectionMapping);
});

test('a map of halves that was cut is told once, and not for the stock shading', async () => {
  const warn = mock.method(console, 'warn', () => {});
  const { halves } = texturesMade();
  await apply({ shading: 'three' }, halves);
  assert.equal(warn.mock.callCount(), 0);
  await apply({ shading: 'fabric' }, halves);
  await apply({ shading: 'fabric' }, halves);
  assert.equal(warn.mock.callCount(), 1);
  assert.match(warn.mock.calls[0].arguments[0], /setDataType\(THREE\.FloatType\)/);
  warn.mock.restore();
});

test('another shading than fabric has what halves do not hold as lights, and all else in the map', async () => {
  const [sun] = sunsIn(await apply({ shading: 'disney-2012', environment: { map: 'a.hdr', intensity: 1 } }, sunTexture(true)));
  const angle = ((2 * Math.PI) / WIDTH) * (Math.cos(Math.PI / HEIGHT) - Math.cos((2 * Math.PI) / HEIGHT));
  const light = sun.color.clone().multiplyScalar(sun.intensity).toArray();
  RADIANCE.forEach((value, c) => assert.ok(Math.abs(light[c] - angle * Math.max(value - 65504, 0)) < 1e-9 * light[0], `${light}`));
});

test('small lights that halves hold are suns too, their light leaves the lit map alone', async () => {
  const halves = () => {
    const data = new Uint16Array(WIDTH * HEIGHT * 4).fill(THREE.DataUtils.toHalfFloat(0.5));
    data.set([8192, 4096, 2048].map(THREE.DataUtils.toHalfFloat), (WIDTH + 12) * 4);
    return Object.assign(new THREE.DataTexture(data, WIDTH, HEIGHT, THREE.RGBAFormat, THREE.HalfFloatType), { flipY: true });
  };
  const whole = (await apply({ shading: 'three' }, halves())).environment;
  const scene = await apply({ shading: 'fabric', background: 'environment' }, halves());
  assert.equal(sunsIn(scene).length, 1);
  assert.deepEqual(scene.background.image.data, whole.image.data);
  const changed = Array.from(scene.environment.image.data.keys()).filter((i) => scene.environment.image.data[i] !== whole.image.data[i]);
  assert.deepEqual(
    changed,
    [0, 1, 2].map((c) => (WIDTH + 12) * 4 + c),
  );
});

test('many small lights stay in the map', async () => {
  const data = new Float32Array(WIDTH * HEIGHT * 4).fill(0.5);
  for (let i = 0; i < 4; i++) data.set([9e4, 9e4, 9e4, 1], (2 * WIDTH + 4 * i) * 4);
  const environment = Object.assign(new THREE.DataTexture(data, WIDTH, HEIGHT, THREE.RGBAFormat, THREE.FloatType), { flipY: true });
  const mean = (texture) => texture.image.data.reduce((sum, bits) => sum + THREE.DataUtils.fromHalfFloat(bits), 0);
  const [fabric, three] = [await apply({ shading: 'fabric' }, environment), await apply({ shading: 'three' }, environment)];
  assert.equal(mean(fabric.environment), mean(three.environment));
});

test('the halves go with their source', async () => {
  const environment = sunTexture(true);
  const scene = await apply({ shading: 'fabric' }, environment);
  let disposed = 0;
  scene.environment.addEventListener('dispose', () => disposed++);
  environment.dispose();
  assert.equal(disposed, 1);
});
