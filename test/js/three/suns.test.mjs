import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import * as THREE from 'three';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { resolveShot } from '../../../js/shot/index.mjs';
import { applyShot } from '../../../js/three/index.mjs';
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
  test(`what a half does not hold becomes a directional light, ${flipY ? 'the top' : 'the bottom'} row first`, async () => {
    const shot = { shading: 'fabric', environment: { map: 'a.hdr', intensity: 0.5, rotation: 90 } };
    const [sun, ...others] = sunsIn(await apply(shot, sunTexture(flipY)));
    assert.deepEqual(others, []);
    const angle = ((2 * Math.PI) / WIDTH) * (Math.cos(Math.PI / HEIGHT) - Math.cos((2 * Math.PI) / HEIGHT));
    const expected = RADIANCE.map((value) => 0.5 * angle * Math.max(value - 65504, 0));
    const light = sun.color.clone().multiplyScalar(sun.intensity).toArray();
    light.forEach((value, c) => assert.ok(Math.abs(value - expected[c]) < 1e-9 * expected[0], `${light} for ${expected}`));
    // Column 12.5 of 16 is 281.25 degrees from the map's left edge, which is -X; a quarter turn about +Y takes +X to -Z.
    const [phi, theta] = [(12.5 / WIDTH - 0.5) * 2 * Math.PI, (1.5 * Math.PI) / HEIGHT];
    const [x, y, z] = [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)];
    assert.ok(sun.position.distanceTo(new THREE.Vector3(z, y, -x)) < 1e-12, sun.position.toArray().join(' '));
    assert.equal(sun.castShadow, false);
  });
}

test('the stock shading has no suns; another shot takes them out again', async () => {
  const environment = sunTexture(true);
  const scene = await apply({ shading: 'fabric' }, environment);
  assert.equal(sunsIn(scene).length, 1);
  const texture = scene.environment;
  await apply({ shading: 'three' }, environment, scene);
  assert.equal(sunsIn(scene).length, 0);
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

test('the halves go with their source', async () => {
  const environment = sunTexture(true);
  const scene = await apply({ shading: 'fabric' }, environment);
  let disposed = 0;
  scene.environment.addEventListener('dispose', () => disposed++);
  environment.dispose();
  assert.equal(disposed, 1);
});
