// What random cases are made of, and that a seed is the same case everywhere.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { LAYERS } from '../../js/material/table.mjs';
import { BASES, SLOTS } from '../../js/shot/shading_terms.mjs';
import { randomScene } from '../fixtures/random_scene.mjs';
import { randomCase, randomCases } from './cases_random.mjs';

const SCENES = 60;
const SHOTS = 90;

const documentOf = (glb) => JSON.parse(Buffer.from(glb.buffer, glb.byteOffset + 20, new DataView(glb.buffer, glb.byteOffset).getUint32(12, true)).toString());

test('a seed is the same scene and the same shot each time, and another seed is another', async () => {
  assert.deepEqual(await randomScene(7, true), await randomScene(7, true));
  assert.deepEqual(await randomCase(7, 'fabric'), await randomCase(7, 'fabric'));
  assert.notDeepEqual(await randomScene(7, true), await randomScene(8, true));
  assert.notDeepEqual((await randomCase(7)).shot, (await randomCase(8)).shot);
});

test('scenes are valid glTF, with every layer and every kind of opacity among them', async () => {
  const [materials, documents] = [[], []];
  for (let seed = 0; seed < SCENES; seed++) {
    const glb = await randomScene(seed, true);
    const { issues } = await validator.validateBytes(glb);
    const errors = issues.messages.filter(({ severity, code }) => severity === 0 && code !== 'MESH_PRIMITIVE_NO_TANGENT_SPACE');
    assert.deepEqual(errors, [], `seed ${seed}`);
    documents.push(documentOf(glb));
    materials.push(...(documents.at(-1).materials ?? []));
  }
  const used = new Set(materials.flatMap(({ extensions = {} }) => Object.keys(extensions)));
  for (const { extension } of LAYERS) assert.ok(used.has(extension), extension);
  for (const mode of ['MASK', 'BLEND']) assert.ok(materials.some(({ alphaMode }) => alphaMode === mode));
  for (const extension of ['EXT_mesh_gpu_instancing', 'KHR_mesh_quantization', 'KHR_lights_punctual', 'KHR_materials_variants'])
    assert.ok(documents.some(({ extensionsUsed = [] }) => extensionsUsed.includes(extension)));
  const primitives = documents.flatMap(({ meshes }) => meshes.flatMap((mesh) => mesh.primitives));
  assert.ok(primitives.some(({ targets }) => targets));
  assert.ok(documents.some(({ meshes }) => meshes.some((mesh) => mesh.primitives.length > 1)));
  const drawnOf = ({ nodes }) => nodes.flatMap(({ mesh }) => mesh ?? []);
  assert.ok(documents.some((document) => new Set(drawnOf(document)).size < drawnOf(document).length));
  for (const mode of [0, 1, 2, 3, 5, 6])
    assert.ok(
      primitives.some((primitive) => primitive.mode === mode),
      `mode ${mode}`,
    );
  assert.ok(primitives.some(({ material }) => material === undefined));
  const areShared = ({ primitives: [first, second] }) => second && first.attributes.POSITION === second.attributes.POSITION;
  assert.ok(documents.some(({ meshes }) => meshes.some(areShared)));
  const lightsOf = ({ nodes }) => nodes.flatMap(({ extensions }) => extensions?.KHR_lights_punctual?.light ?? []);
  assert.ok(documents.some((document) => new Set(lightsOf(document)).size < lightsOf(document).length));
  assert.ok(documents.some(({ scenes, scene }) => scenes.length > 1 && scene === 1));
  assert.ok(documents.some(({ nodes }) => nodes.some(({ mesh, children = [] }) => mesh !== undefined && children.length > 0)));
  for (const type of ['image/png', 'image/jpeg']) assert.ok(documents.some(({ images = [] }) => images.some(({ mimeType }) => mimeType === type)));
  for (const extension of ['KHR_draco_mesh_compression', 'EXT_meshopt_compression', 'KHR_texture_basisu'])
    assert.ok(
      documents.some(({ extensionsRequired = [] }) => extensionsRequired.includes(extension)),
      extension,
    );
  assert.ok(documents.some(({ accessors }) => accessors.some(({ sparse }) => sparse)));
  assert.ok(documents.some(({ skins }) => skins));
  const paths = new Set(documents.flatMap(({ animations = [] }) => animations.flatMap(({ channels }) => channels.map(({ target }) => target.path))));
  assert.deepEqual([...paths].sort(), ['rotation', 'scale', 'translation', 'weights']);
});

test('shots have every kind of light, with shadows and without, every kind of background, and both projections', async () => {
  const shots = (await randomCases(String(SHOTS), '0', 'three')).map(({ shot }) => shot);
  const lights = shots.flatMap((shot) => shot.lights);
  for (const type of ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rect']) assert.ok(lights.some((light) => light.type === type));
  for (const casts of [true, false]) assert.ok(lights.some(({ castShadow = false }) => castShadow === casts));
  for (const projection of ['perspective', 'orthographic']) assert.ok(shots.some(({ camera }) => camera.projection === projection));
  for (const background of ['transparent', 'environment']) assert.ok(shots.some((shot) => shot.background === background));
  for (const has of [({ background }) => Array.isArray(background), ({ background }) => background.blur > 0, ({ ground }) => ground !== 'none'])
    assert.ok(shots.some(has));
  for (const has of [({ materials }) => Object.keys(materials).length > 0, ({ metering }) => metering, ({ lens }) => lens, ({ pose }) => pose])
    assert.ok(shots.some(has));
  assert.ok(shots.some(({ look }) => look !== 'none'));
  assert.ok(lights.some(({ shadow }) => shadow?.right !== undefined && shadow.left !== -shadow.right));
});

test('"terms" is any term of every slot, on either base', async () => {
  const shadings = (await randomCases(String(SHOTS), '0', 'terms')).map(({ shot }) => shot.shading);
  for (const [slot, terms] of Object.entries({ ...SLOTS, base: BASES }))
    for (const term of terms)
      assert.ok(
        shadings.some((shading) => shading[slot] === term),
        `${slot} ${term}`,
      );
});

test('what is no number of scenes is told', () => {
  assert.throws(() => randomCases('ten', '0', 'three'), { message: '--random ten --seed 0: expected whole numbers' });
});
