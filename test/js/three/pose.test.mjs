import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { inspect } from '../../../js/index.mjs';
import { resolvePose, resolveShot } from '../../../js/shot/index.mjs';
import { applyPose, factsOf } from '../../../js/three/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import '../api/support/real.mjs';

const bytesOf = (name) => MODELS[name]();

async function load(bytes) {
  return new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
}

/** Fixtures without textures: in Node three.js cannot decode those. */
const POSED = [
  ['skin-looks', null],
  ['skin-scaled', null],
  ['skin-bytes', null],
  ['skin-bare', null],
  ['animated-nodes', null],
  ['animated-nodes', { animation: 'act', time: 0.75 }],
  ['animated-nodes', { animation: 1, time: 0.3 }],
  ['morph-primitives', { animation: 'turn', time: 0.6 }],
  ['morph-colors', null],
  ['instances', null],
  ['instances-of-two', null],
];

const far = (a, b) => Math.max(...a.map((x, i) => Math.abs(x - b[i])));

for (const [name, pose] of POSED) {
  test(`browser and server measure and frame ${name} alike, ${JSON.stringify(pose)}`, async () => {
    const bytes = await bytesOf(name);
    const model = await load(bytes);
    const shot = { camera: { view: 'three-quarter' }, environment: 'none', pose };
    const browser = factsOf(model, { THREE, pose: resolvePose(shot, model) });
    const server = await inspect(bytes, { shot });
    assert.ok(
      far(server.bounds.min, browser.bounds.min) < 1e-5 && far(server.bounds.max, browser.bounds.max) < 1e-5,
      JSON.stringify([server.bounds, browser.bounds]),
    );
    assert.deepEqual(server.animations, browser.animations);
    const [here, there] = [browser, server].map((facts) => resolveShot(shot, facts));
    assert.deepEqual(here.pose, there.pose);
    assert.ok(far(here.camera.position, there.camera.position) < 1e-4, JSON.stringify([here.camera, there.camera]));
    assert.ok(far(here.camera.target, there.camera.target) < 1e-4);
  });
}

test('the pose moves what is measured, and the model goes back to where the file has it', async () => {
  const model = await load(await bytesOf('animated-nodes'));
  const rest = factsOf(model, { THREE });
  const posed = factsOf(model, { THREE, pose: { animation: 0, time: 1 } });
  assert.ok(far(rest.bounds.max, posed.bounds.max) > 0.01);
  assert.deepEqual(factsOf(model, { THREE }), rest);
});

test('one pose takes the place of another, whatever the animation', async () => {
  const model = await load(await bytesOf('animated-nodes'));
  const direct = factsOf(model, { THREE, pose: { animation: 1, time: 0.4 } });
  factsOf(model, { THREE, pose: { animation: 0, time: 0.9 } });
  assert.deepEqual(factsOf(model, { THREE, pose: { animation: 1, time: 0.4 } }), direct);
});

test('an animation that the model lacks is named', async () => {
  const model = await load(await bytesOf('animated-nodes'));
  assert.throws(() => applyPose(model, { animation: 2, time: 0 }, { THREE }), /the model has 2 animations, not one of index 2/);
  assert.throws(() => applyPose({ scene: new THREE.Group() }, { animation: 0, time: 0 }, { THREE }), /has 0 animations/);
});

test('many instances are measured by their boxes on both sides', async () => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array([0, 1, 0, 1, 0, 0, 0.4, 0.4, 0]), 3));
  const mesh = new THREE.InstancedMesh(geometry, new THREE.MeshBasicMaterial(), Math.floor(2 ** 20 / 3) + 1);
  mesh.setMatrixAt(0, new THREE.Matrix4().makeRotationZ(Math.PI / 4));
  const scene = new THREE.Group().add(mesh);
  assert.ok(Math.abs(factsOf({ scene }, { THREE }).bounds.max[1] - Math.SQRT2) < 1e-6);
  mesh.count = 2;
  assert.ok(Math.abs(factsOf({ scene }, { THREE }).bounds.max[1] - 1) < 1e-6);
});
