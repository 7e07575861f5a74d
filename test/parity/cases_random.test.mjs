// What random cases are made of, and that a seed is the same case everywhere.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { LAYERS } from '../../js/material/table.mjs';
import { randomScene } from '../fixtures/random_scene.mjs';
import { randomCase, randomCases } from './cases_random.mjs';

const COUNT = 60;
const seeds = Array.from({ length: COUNT }, (_, seed) => seed);

const documentOf = (glb) => JSON.parse(Buffer.from(glb.buffer, glb.byteOffset + 20, new DataView(glb.buffer, glb.byteOffset).getUint32(12, true)).toString());

test('a seed is the same scene and the same shot each time, and another seed is another', async () => {
  assert.deepEqual(await randomScene(7, true), await randomScene(7, true));
  assert.deepEqual(await randomCase(7, 'fabric'), await randomCase(7, 'fabric'));
  assert.notDeepEqual(await randomScene(7, true), await randomScene(8, true));
  assert.notDeepEqual((await randomCase(7)).shot, (await randomCase(8)).shot);
});

test('scenes are valid glTF, with every layer and every kind of opacity among them', async () => {
  const materials = [];
  for (const seed of seeds) {
    const glb = await randomScene(seed, true);
    const { issues } = await validator.validateBytes(glb);
    const errors = issues.messages.filter(({ severity, code }) => severity === 0 && code !== 'MESH_PRIMITIVE_NO_TANGENT_SPACE');
    assert.deepEqual(errors, [], `seed ${seed}`);
    materials.push(...documentOf(glb).materials);
  }
  const used = new Set(materials.flatMap(({ extensions = {} }) => Object.keys(extensions)));
  for (const { extension } of LAYERS) assert.ok(used.has(extension), extension);
  for (const mode of ['MASK', 'BLEND']) assert.ok(materials.some(({ alphaMode }) => alphaMode === mode));
});

test('shots have every kind of light, with shadows and without, every kind of background, and both projections', async () => {
  const shots = (await randomCases(String(COUNT), '0', 'three')).map(({ shot }) => shot);
  const lights = shots.flatMap((shot) => shot.lights);
  for (const type of ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rect']) assert.ok(lights.some((light) => light.type === type));
  for (const casts of [true, false]) assert.ok(lights.some(({ castShadow = false }) => castShadow === casts));
  for (const projection of ['perspective', 'orthographic']) assert.ok(shots.some(({ camera }) => camera.projection === projection));
  for (const background of ['transparent', 'environment']) assert.ok(shots.some((shot) => shot.background === background));
  for (const has of [({ background }) => Array.isArray(background), ({ background }) => background.blur > 0, ({ ground }) => ground !== 'none'])
    assert.ok(shots.some(has));
});

test('what is no number of scenes is told', () => {
  assert.throws(() => randomCases('ten', '0', 'three'), { message: '--random ten --seed 0: expected whole numbers' });
});
