import assert from 'node:assert/strict';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { WebIO } from '@gltf-transform/core';
import { KHRONOS_EXTENSIONS } from '@gltf-transform/extensions';
import { bake, createRenderer, inspect, pictureKey } from '../../../js/index.mjs';
import { drape } from '../../fixtures/drape.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

const RAYS = 256;
const SHOT = { size: { width: 64, height: 64 }, shading: 'fabric' };

/** A floor that faces up, with vertices at these distances from a long wall of 1 m; a wall in a mesh of its own. */
const DISTANCES = [0.2, 0.5, 1, 2];

async function corner({ material = {} } = {}) {
  const builder = new GlbBuilder();
  const cloth = builder.material({ doubleSided: true, ...material });
  const positions = DISTANCES.flatMap((x) => [x, 0, 0.01, x, 0, -0.01]);
  const indices = DISTANCES.slice(1).flatMap((_, i) => [2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3]);
  builder.add({ positions, normals: DISTANCES.flatMap(() => [0, 1, 0, 0, 1, 0]), indices }, cloth, { name: 'floor' });
  const half = Math.SQRT1_2;
  builder.add(plane(200, 1), cloth, { name: 'wall', translation: [0, 0.5, 0], rotation: [0, half, 0, half] });
  return builder.bytes();
}

async function draped() {
  const builder = new GlbBuilder();
  builder.add(drape({ cells: 24 }), builder.material({ doubleSided: true, baseColor: [0.5, 0.4, 0.3, 1], roughness: 0.7 }));
  return builder.bytes();
}

/** Configuration factor of a strip: Siegel and Howell. */
const openBeside = (x) => 1 - (1 - x / Math.hypot(x, 1)) / 2;

async function readAttributes(bytes, mesh = 0) {
  const document = await new WebIO().registerExtensions(KHRONOS_EXTENSIONS).readBinary(new Uint8Array(bytes));
  const [primitive] = document.getRoot().listMeshes()[mesh].listPrimitives();
  const list = (name) => {
    const accessor = primitive.getAttribute(name);
    return accessor && Array.from({ length: accessor.getCount() }, (_, i) => accessor.getElement(i, []));
  };
  return { front: list('_TELAR_VISIBILITY'), back: list('_TELAR_VISIBILITY_BACK') };
}

let renderer;
let model;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  model = await corner();
});
after(() => renderer.close());

test('the file has what its vertices see, as glTF stores it', async () => {
  const { data, info } = await bake(model, { rays: 4096, cacheDirectory: null });
  const { front, back } = await readAttributes(data);
  DISTANCES.forEach((x, i) => {
    const [bx, by, bz, open] = front[2 * i];
    // 4096 rays are within 0.004 of the integral (test/cpp/reference/visibility_test.cpp).
    assert.ok(Math.abs(open - openBeside(x)) < 0.004, `${x}: ${open}, expected ${openBeside(x)}`);
    assert.ok(Math.abs(Math.hypot(bx, by, bz) - 1) < 1e-3 && bx > 0, 'leans away from the wall');
  });
  assert.ok(Math.abs(front[2][3] - openBeside(DISTANCES[1] + 0.05)) > 0.004, 'a wall 5 cm farther is told from it');
  assert.ok(back.every(([, y, , open]) => open === 1 && y < -0.99));
  assert.deepEqual({ ...info, warnings: [] }, { format: 'glb', parts: [], primitives: 2, vertices: 12, rays: 4096, warnings: [] });
});

test('a baked file is drawn as the model that is loaded with the option', async () => {
  const cloth = await draped();
  const { data } = await bake(cloth, { rays: RAYS, cacheDirectory: null });
  const baked = await renderer.render(data, SHOT);
  const loaded = await renderer.render(cloth, SHOT, { ambientVisibility: { rays: RAYS } });
  const plain = await renderer.render(cloth, SHOT);
  assert.ok(baked.info.features.includes('ambient-visibility') && loaded.info.features.includes('ambient-visibility'));
  assert.ok(!plain.info.features.includes('ambient-visibility'));
  assert.ok((await worst(plain, loaded)) > 20, 'folds are darker');
  assert.ok((await worst(baked, loaded)) <= 1, 'shorts round the floats of the option: at most 1 of 255 apart');
});

async function worst(...images) {
  const { default: sharp } = await import('sharp');
  const [a, b] = await Promise.all(images.map(({ data }) => sharp(data).raw().toBuffer()));
  return a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
}

test('the shading three does not read it, and its program has no trace of it', async () => {
  const { data } = await bake(model, { rays: 16, cacheDirectory: null });
  const [with_, without] = await Promise.all([data, model].map((bytes) => renderer.render(bytes, { ...SHOT, shading: 'three' })));
  assert.ok(with_.data.equals(without.data));
  assert.deepEqual(with_.info.features, without.info.features);
});

test('the picture of it has a key of its own, which is known before it is drawn', async () => {
  const options = { ambientVisibility: { rays: 32 } };
  const { info } = await renderer.render(model, SHOT, options);
  assert.equal(info.key, await pictureKey(model, SHOT, options));
  assert.notEqual(info.key, await pictureKey(model, SHOT));
  assert.notEqual(info.key, await pictureKey(model, SHOT, { ambientVisibility: true }));
  const facts = await inspect(model, { shot: SHOT, ...options });
  assert.ok(facts.plan.features.includes('ambient-visibility'));
});

test('a baked file may be baked again, and everything else in it stays', async () => {
  const builder = new GlbBuilder();
  const mesh = drape({ cells: 8 });
  builder.add(mesh, builder.material({ doubleSided: true, name: 'cloth' }), { name: 'drape' });
  const bytes = editedGlb(await builder.bytes(), (json) => {
    json.extras = { ours: [1, 2] };
  });
  const once = await bake(bytes, { rays: 16, cacheDirectory: null });
  const twice = await bake(once.data, { rays: 16, cacheDirectory: null });
  assert.ok(twice.data.equals(once.data));
  const finer = { rays: 64, cacheDirectory: null };
  assert.ok((await bake(once.data, finer)).data.equals((await bake(bytes, finer)).data), 'nothing of the earlier bake is left, and the file does not grow');
  const jsonOf = (data) => JSON.parse(data.subarray(20, 20 + data.readUInt32LE(12)).toString());
  assert.deepEqual(jsonOf(twice.data).extras, { ours: [1, 2] });
  const { front } = await readAttributes(once.data);
  assert.ok(Math.min(...front.map((v) => v[3])) < 0.8 && Math.max(...front.map((v) => v[3])) > 0.95, 'folds hide, the top does not');
});

test('a .gltf file keeps its parts beside it and gets its bytes within', async () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'telar-bake-'));
  try {
    const glb = Buffer.from(model);
    const length = glb.readUInt32LE(12);
    const json = JSON.parse(glb.subarray(20, 20 + length).toString());
    json.buffers[0].uri = 'shirt.bin';
    writeFileSync(path.join(folder, 'shirt.bin'), glb.subarray(28 + length));
    writeFileSync(path.join(folder, 'shirt.gltf'), JSON.stringify(json));
    const { data, info } = await bake(path.join(folder, 'shirt.gltf'), { rays: 16, cacheDirectory: null });
    assert.deepEqual([info.format, info.parts], ['gltf', ['shirt.bin']]);
    writeFileSync(path.join(folder, 'baked.gltf'), data);
    const facts = await inspect(path.join(folder, 'baked.gltf'), { shot: SHOT });
    assert.ok(facts.plan.features.includes('ambient-visibility'));
    const finer = { rays: 64, cacheDirectory: null };
    const again = [path.join(folder, 'baked.gltf'), path.join(folder, 'shirt.gltf')].map((file) => bake(file, finer));
    const [first, second] = (await Promise.all(again)).map((baked) => baked.data);
    assert.ok(first.equals(second), 'baked again it is the same');
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('a GLB keeps the chunks that glTF does not name', async () => {
  const chunk = Buffer.from('\x04\0\0\0NOTEours');
  const noted = Buffer.concat([model, chunk]);
  noted.writeUInt32LE(noted.length, 8);
  const { data, info } = await bake(noted, { rays: 16, cacheDirectory: null });
  assert.ok(data.subarray(-chunk.length).equals(chunk) && data.readUInt32LE(8) === data.length);
  assert.deepEqual(
    info.warnings.map(({ code }) => code),
    ['W_GLB_CHUNK'],
  );
  assert.deepEqual(await readAttributes(data), await readAttributes((await bake(model, { rays: 16, cacheDirectory: null })).data));
});

test('vertices that share what an earlier bake found get their own', async () => {
  const once = await bake(model, { rays: 16, cacheDirectory: null });
  const shared = editedGlb(once.data, ({ meshes }) => {
    const [floor, wall] = meshes.map(({ primitives }) => primitives[0].attributes);
    floor._TELAR_VISIBILITY_BACK = floor._TELAR_VISIBILITY;
    wall._TELAR_VISIBILITY_BACK = wall._TELAR_VISIBILITY;
  });
  const again = await bake(shared, { rays: 16, cacheDirectory: null });
  for (const mesh of [0, 1]) assert.deepEqual(await readAttributes(again.data, mesh), await readAttributes(once.data, mesh));
});

/** Runs `use` with an empty folder. */
async function inFolder(use) {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'telar-visibility-'));
  try {
    return await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Pictures with what a folder keeps. */
async function drawnWith(cacheDirectory, source, rays, cacheBytes) {
  const own = await createRenderer({ cacheDirectory, ...(cacheBytes !== undefined && { cacheBytes }) });
  const { data } = await own.render(source, SHOT, { ambientVisibility: { rays } });
  await own.close();
  return data;
}

test('what rays have found is kept by content, and read in place of them', () =>
  inFolder(async (folder) => {
    const kept = () => readdirSync(folder).filter((name) => name.endsWith('.visibility'));
    const cloth = await draped();
    const first = await drawnWith(folder, cloth, 64);
    const [name] = kept();
    assert.match(name, /^[0-9a-f]{64}\.visibility$/);
    const file = path.join(folder, name);
    utimesSync(file, 1, 1);
    assert.ok((await drawnWith(folder, cloth, 64)).equals(first), 'the same bytes');
    assert.ok(statSync(file).mtimeMs > 1e6, 'the time of its last use is now');
    assert.equal(kept().length, 1);
    const whole = readFileSync(file);
    const broken = Buffer.from(whole);
    broken[broken.length - 3] ^= 0x40;
    for (const bytes of [broken, whole.subarray(0, 100), Buffer.alloc(0)]) {
      writeFileSync(file, bytes);
      assert.ok((await drawnWith(folder, cloth, 64)).equals(first), `${bytes.length} bytes that are not its own`);
      assert.ok(readFileSync(file).equals(whole), 'and are replaced');
    }
    await drawnWith(folder, cloth, 32);
    await drawnWith(folder, model, 64);
    assert.equal(kept().length, 3, 'other rays and another model are others');
    await bake(cloth, { rays: 16, cacheDirectory: folder });
    assert.equal(kept().length, 4, 'baking keeps it too');
    await bake(cloth, { rays: 17, cacheDirectory: folder, cacheBytes: whole.length + 10 });
    assert.equal(kept().length, 1, 'no more than there is room for');
  }));

test('a folder that cannot be written to is as none', () =>
  inFolder(async (folder) => {
    const file = path.join(folder, 'file');
    writeFileSync(file, '');
    const none = await drawnWith(null, model, 32);
    assert.ok((await drawnWith(path.join(file, 'beneath'), model, 32)).equals(none));
    assert.equal(
      await bake(model, { rays: 16, cacheDirectory: '' }).catch(({ message }) => message),
      'options.cacheDirectory: expected a path, or null for none, got ""',
    );
  }));

test('what is wrong is told: rays out of range, too many of them, another option', async () => {
  const refused = (promise) =>
    promise.then(
      () => 'no error',
      ({ code, message }) => `${code} ${message}`,
    );
  assert.equal(await refused(bake(model, { rays: 8, cacheDirectory: null })), 'E_OPTION options.rays: expected a whole number from 16 to 4096, got 8');
  assert.equal(await refused(bake(model, { rays: 16.5 })), 'E_OPTION options.rays: expected a whole number from 16 to 4096, got 16.5');
  assert.match(await refused(bake(model, { limits: { L_VISIBILITY_RAYS: 100 } })), /^L_VISIBILITY_RAYS /);
  assert.equal(
    await refused(renderer.load(model, { ambientVisibility: 'yes' })),
    'E_OPTION options.ambientVisibility: expected true, false or an object with rays, got "yes"',
  );
  assert.match(await refused(renderer.load(model, { ambientVisibility: { rays: 5000 } })), /^E_OPTION options\.ambientVisibility\.rays: /);
  const stopped = AbortSignal.abort(new Error('enough'));
  assert.match(await refused(bake(model, { signal: stopped })), /enough/);
});
