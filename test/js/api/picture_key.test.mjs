import assert from 'node:assert/strict';
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { keyOfParts } from '../../../js/api/picture_key.mjs';
import { shotIdentity } from '../../../js/shot/identity.mjs';
import './support/real.mjs';
import { createRenderer, inspect, pictureKey } from '../../../js/index.mjs';
import { hdr } from '../../fixtures/environment.mjs';

// info.key: what changes it, what does not, and that it is known without drawing.

const root = mkdtempSync(path.join(tmpdir(), 'telar-key-'));
const at = (name) => path.join(root, name);
const SHOT = { size: { width: 16, height: 16 } };

/** A triangle with its corners in one file and a texture, which nothing draws, in another. */
const DOCUMENT = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  buffers: [{ byteLength: 36, uri: 'corners.bin' }],
  images: [{ uri: 'unused.png' }],
};
const CORNERS = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);

function writeModel(folder, { document = DOCUMENT, corners = CORNERS, texture = 'not looked at' } = {}) {
  mkdirSync(at(folder), { recursive: true });
  writeFileSync(at(`${folder}/model.gltf`), JSON.stringify(document));
  writeFileSync(at(`${folder}/corners.bin`), Buffer.from(corners.buffer));
  if (texture !== null) writeFileSync(at(`${folder}/unused.png`), texture);
  return at(`${folder}/model.gltf`);
}

let renderer, model;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  model = writeModel('plain');
});
after(async () => {
  await renderer.close();
  rmSync(root, { recursive: true });
});

/** The key of a picture: of info, which pictureKey() must know before. */
async function keyOf(source, shot = SHOT) {
  const { info } = await renderer.render(source, shot);
  assert.match(info.key, /^[\da-f]{64}$/);
  assert.equal(await pictureKey(source, shot), info.key);
  return info.key;
}

test('a key is the same for the same bytes, wherever they lie, and by every way to draw them', async () => {
  const key = await keyOf(model);
  assert.equal(await keyOf(model), key);
  cpSync(at('plain'), at('moved'), { recursive: true });
  copyFileSync(at('moved/model.gltf'), at('moved/renamed.gltf'));
  assert.equal(await keyOf(at('moved/renamed.gltf')), key);
  const loaded = await renderer.load(model);
  assert.equal((await renderer.render(loaded, SHOT)).info.key, key);
  assert.deepEqual(
    (await renderer.renderAll(model, [SHOT, SHOT])).map(({ info }) => info.key),
    [key, key],
  );
  assert.equal((await inspect(model)).sha256, loaded.facts.sha256);
});

test('every byte counts: of the document, of its parts, drawn or not', async () => {
  const moved = Float32Array.from(CORNERS);
  moved[0] = -1e-7;
  const keys = await Promise.all([
    keyOf(model),
    keyOf(writeModel('document', { document: { ...DOCUMENT, asset: { version: '2.0', generator: 'x' } } })),
    keyOf(writeModel('part', { corners: moved })),
    keyOf(writeModel('unused', { texture: 'not looked at!' })),
    keyOf(writeModel('absent', { texture: null })),
  ]);
  assert.equal(new Set(keys).size, keys.length, keys.join('\n'));
});

test('parts that are swapped make another model', async () => {
  const document = { ...DOCUMENT, images: [{ uri: 'a.png' }, { uri: 'b.png' }, { uri: 'a.png' }] };
  const keys = [];
  for (const [a, b] of [
    ['1', '2'],
    ['2', '1'],
    ['1', '1'],
  ]) {
    const file = writeModel('swapped', { document });
    writeFileSync(at('swapped/a.png'), a);
    writeFileSync(at('swapped/b.png'), b);
    keys.push(await keyOf(file));
  }
  assert.equal(new Set(keys).size, 3);
});

test('bytes of a model have the key of its file', async () => {
  const embedded = {
    ...DOCUMENT,
    images: [],
    buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${Buffer.from(CORNERS.buffer).toString('base64')}` }],
  };
  const file = writeModel('embedded', { document: embedded });
  assert.equal(await keyOf(readFileSync(file)), await keyOf(file));
});

test('the environment counts by its bytes, whatever it is called, and where nothing shows it too', async () => {
  const unlit = {
    ...DOCUMENT,
    extensionsUsed: ['KHR_materials_unlit'],
    materials: [{ extensions: { KHR_materials_unlit: {} } }],
    meshes: [{ primitives: [{ ...DOCUMENT.meshes[0].primitives[0], material: 0 }] }],
  };
  const [dim, bright] = [0.5, 0.75].map((grey) => hdr(8, () => [grey, grey, grey]));
  writeFileSync(at('dim.hdr'), dim);
  writeFileSync(at('copy.hdr'), dim);
  writeFileSync(at('bright.hdr'), bright);
  for (const source of [model, writeModel('unlit', { document: unlit })]) {
    const under = (environment) => keyOf(source, { ...SHOT, environment });
    const key = await under(at('dim.hdr'));
    assert.equal(await under(at('copy.hdr')), key);
    assert.equal(await under({ map: at('dim.hdr'), intensity: 1 }), key);
    assert.equal(await under(new Uint8Array(dim)), key);
    const others = [await under(at('bright.hdr')), await under('studio'), await under('none'), await under({ map: at('dim.hdr'), intensity: 2 })];
    assert.equal(new Set([key, ...others]).size, 5);
  }
});

test('a shot in other words has the same key, another shot another one', async () => {
  const key = await pictureKey(model, {});
  const same = [
    { size: { height: 512, width: 512 } },
    { camera: { view: 'front' } },
    { camera: { azimuth: 0, elevation: 0, fovY: 30 } },
    { environment: 'studio' },
    { environment: { map: 'studio', rotation: 0 } },
    { quality: { preset: 'standard' } },
    { variant: '' },
    { background: 'transparent' },
    { lights: [], pose: null },
    { output: { format: 'png', bitDepth: 8 } },
  ];
  for (const shot of same) assert.equal(await pictureKey(model, shot), key, JSON.stringify(shot));
  const others = [
    { size: { width: 511 } },
    { camera: { view: 'back' } },
    { camera: { fit: 0.8 } },
    { camera: { projection: 'orthographic' } },
    { camera: { gltf: 0 } },
    { lens: { aperture: 2 } },
    { environment: { rotation: 1 } },
    { lights: [{ type: 'ambient' }] },
    { lights: [{ type: 'directional' }] },
    { lights: [{ type: 'directional', castShadow: true }] },
    { lights: [{ type: 'directional', castShadow: true, shadow: { mapSize: 512 } }] },
    { modelLights: false },
    { background: 'white' },
    { ground: {} },
    { shading: 'fabric' },
    { toneMapping: 'agx' },
    { exposure: 1.0000001 },
    { quality: 'draft' },
    { quality: { textureSize: 512 } },
    { quality: { prefilterSamples: 512 } },
    { quality: { geometryError: 0.5 } },
    { variant: 'x' },
    { pose: { animation: 0 } },
    { output: { format: 'webp' } },
    { output: { bitDepth: 16 } },
    { output: { effort: 5 } },
    { scale: '1:5', output: { ppi: 150 } }, // the model decides its size
    { scale: '1:5', output: { ppi: 150 }, size: {} },
  ];
  const keys = await Promise.all(others.map((shot) => pictureKey(model, shot)));
  assert.equal(new Set([key, ...keys]).size, others.length + 1);
});

test('a shot that is refused has the key of no picture', async () => {
  const refused = { camera: { view: 'left', azimuth: 0 } };
  await assert.rejects(renderer.render(model, refused), { code: 'E_SHOT' });
  assert.notEqual(await pictureKey(model, refused), await pictureKey(model, { camera: { azimuth: 0 } }));
});

test('another version, and another default of the shot, make another key', () => {
  const parts = { version: '1.0.0', model: 'a', environment: 'studio', shot: shotIdentity({}) };
  const key = keyOfParts(parts);
  assert.equal(keyOfParts({ ...parts, shot: Object.fromEntries(Object.entries(parts.shot).reverse()) }), key);
  assert.notEqual(keyOfParts({ ...parts, version: '1.0.1' }), key);
  // Whatever a default is, it stands in what is hashed: every leaf of the identity counts.
  const leaves = (value, here = []) =>
    typeof value === 'object' && value !== null ? Object.entries(value).flatMap(([name, item]) => leaves(item, [...here, name])) : [here];
  const all = leaves(parts.shot).filter((leaf) => leaf.join('.') !== 'environment.map');
  assert.ok(all.length > 20, all.join(' '));
  for (const leaf of all) {
    const shot = structuredClone(parts.shot);
    const owner = leaf.slice(0, -1).reduce((node, name) => node[name], shot);
    owner[leaf.at(-1)] = 'changed';
    assert.notEqual(keyOfParts({ ...parts, shot }), key, leaf.join('.'));
  }
});

test('what cannot be hashed says why, and a signal ends it', async () => {
  await assert.rejects(pictureKey(at('none.glb')), { code: 'E_FILE' });
  writeFileSync(at('page.glb'), '<!doctype html>');
  await assert.rejects(pictureKey(at('page.glb')), { code: 'E_JSON' });
  await assert.rejects(pictureKey(model, { exposure: 'x' }), { code: 'E_SHOT' });
  await assert.rejects(pictureKey(model, {}, { backend: 'auto' }), { code: 'E_OPTION' });
  await assert.rejects(pictureKey(model, {}, { limits: { L_FILE_BYTES: 10 } }), { code: 'L_FILE_BYTES' });
  await assert.rejects(pictureKey(model, {}, { signal: AbortSignal.abort(new Error('enough')) }), /enough/);
});
