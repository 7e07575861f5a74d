import assert from 'node:assert/strict';
import { mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import v8 from 'node:v8';
import vm from 'node:vm';
import { createRenderer, inspect, pictureKey, TelarError } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

// The option `resolve`: the files that a model names, from a caller's store.

const SHOT = { size: { width: 48, height: 48 } };
const HEADER = 12;

/** A GLB as a .gltf and its parts: the buffer, and each image by a name of its own. */
function taken(glb) {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const jsonEnd = HEADER + 8 + view.getUint32(HEADER, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(HEADER + 8, jsonEnd)));
  const bin = glb.subarray(jsonEnd + 8, jsonEnd + 8 + view.getUint32(jsonEnd, true));
  const parts = { 'geometry data.bin': bin };
  json.buffers[0].uri = 'geometry%20data.bin';
  json.images = json.images.map(({ bufferView }, i) => {
    const { byteOffset = 0, byteLength } = json.bufferViews[bufferView];
    parts[`maps/${i}.png`] = bin.subarray(byteOffset, byteOffset + byteLength);
    return { uri: `./maps/${i}.png` };
  });
  return { gltf: Buffer.from(JSON.stringify(json)), json, parts: Object.fromEntries(Object.entries(parts).map(([name, bytes]) => [name, Buffer.from(bytes)])) };
}

const plain = (uri) => uri.replace(/^\.\//, '');

let renderer, glb, model;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  glb = await MODELS.cloth();
  model = taken(glb);
});
after(() => renderer.close());

const fromStore = (uri) => model.parts[plain(uri)];

test('bytes of a .gltf with its parts from a store draw what the GLB draws', async () => {
  const expected = (await renderer.render(glb, SHOT)).data;
  const asked = [];
  const note = (uri, options) => {
    asked.push([uri, Object.keys(options)]);
    return fromStore(uri);
  };
  assert.deepEqual((await renderer.render(model.gltf, SHOT, { resolve: note })).data, expected);
  assert.deepEqual(
    asked,
    ['geometry data.bin', ...model.json.images.map(({ uri }) => uri)].map((uri) => [uri, ['signal']]),
    'each part once, by its decoded name',
  );
  const kinds = [
    async (uri) => fromStore(uri),
    (uri) => new Uint8Array(fromStore(uri)),
    (uri) => new Uint8Array(fromStore(uri)).buffer,
    async (uri) => {
      await sleep(5);
      return fromStore(uri);
    },
  ];
  for (const resolve of kinds) assert.deepEqual((await renderer.render(model.gltf, SHOT, { resolve })).data, expected);
  const [first] = await renderer.renderAll(model.gltf, [SHOT], { resolve: fromStore });
  assert.deepEqual(first.data, expected);
  const loaded = await renderer.load(model.gltf, { resolve: fromStore });
  assert.deepEqual((await renderer.render(loaded, SHOT)).data, expected);
  assert.equal(loaded.facts.fileBytes, model.gltf.length + Object.values(model.parts).reduce((sum, { length }) => sum + length, 0));
  assert.equal((await inspect(model.gltf, { resolve: fromStore })).images.length, model.json.images.length);
});

test('the key of a picture is of the parts that are given', async () => {
  const { info } = await renderer.render(model.gltf, SHOT, { resolve: fromStore });
  assert.equal(await pictureKey(model.gltf, SHOT, { resolve: fromStore }), info.key);
  const other = (uri) => (plain(uri) === 'maps/0.png' ? model.parts['maps/1.png'] : fromStore(uri));
  assert.notEqual(await pictureKey(model.gltf, SHOT, { resolve: other }), info.key);
});

test("the renderer's own resolve is the default of its calls", async () => {
  const own = await createRenderer({ cacheDirectory: null, resolve: fromStore });
  await own.render(model.gltf, SHOT);
  await assert.rejects(own.render(model.gltf, SHOT, { resolve: () => null }), { code: 'E_URI_MISSING' });
  await own.close();
});

test('by path, no file beside the model is opened', async () => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'telar-'));
  try {
    const file = path.join(folder, 'model.gltf');
    await writeFile(file, model.gltf);
    await writeFile(path.join(folder, 'geometry data.bin'), 'not the geometry');
    assert.deepEqual(await readdir(folder), ['geometry data.bin', 'model.gltf']);
    assert.deepEqual((await renderer.render(file, SHOT, { resolve: fromStore })).data, (await renderer.render(glb, SHOT)).data);
    await assert.rejects(renderer.render(file, SHOT, { resolve: () => undefined }), { code: 'E_URI_MISSING', pointer: '/buffers/0/uri' });
  } finally {
    await rm(folder, { recursive: true });
  }
});

test('what leads out of the model is never asked for', async () => {
  for (const uri of ['../secret.bin', '/etc/passwd', 'https://example.com/a.bin', 'a/%2e%2e/%2e%2e/b', 'file:///etc/passwd', '..\\secret']) {
    const json = structuredClone(model.json);
    json.buffers[0].uri = uri;
    const asked = [];
    const resolve = (name) => void asked.push(name);
    await assert.rejects(renderer.render(Buffer.from(JSON.stringify(json)), SHOT, { resolve }), { code: 'E_URI_DENIED' });
    assert.deepEqual(asked, []);
  }
  await assert.rejects(renderer.render(model.gltf, SHOT), { code: 'E_URI_DENIED' }, 'without resolve, bytes open nothing');
});

test('what the resolver throws is the cause of a typed error', async () => {
  const cause = new Error('store at /srv/parts is down');
  for (const resolve of [
    () => {
      throw cause;
    },
    () => Promise.reject(cause),
  ]) {
    const error = await renderer.render(model.gltf, SHOT, { resolve }).catch((thrown) => thrown);
    assert.ok(error instanceof TelarError);
    assert.deepEqual([error.code, error.kind, error.retryable, error.pointer], ['X_RESOLVE', 'machine', true, '/buffers/0/uri']);
    assert.equal(error.cause, cause);
    assert.equal(error.message, 'options.resolve failed for "geometry data.bin"; its error is the cause of this one');
  }
  for (const wrong of [5, 'text', {}, [1]]) {
    await assert.rejects(renderer.render(model.gltf, SHOT, { resolve: () => wrong }), {
      code: 'E_OPTION',
      message: /^options\.resolve: expected bytes \(Buffer, Uint8Array, ArrayBuffer\) or null for "geometry data\.bin", got /,
    });
  }
  await assert.rejects(renderer.render(model.gltf, SHOT, { resolve: () => Buffer.alloc(3) }), { code: 'E_BUFFER' });
});

test('limits apply to what it gives', async () => {
  const limited = async (limits, check) => {
    const own = await createRenderer({ cacheDirectory: null, limits, resolve: fromStore });
    await assert.rejects(own.render(model.gltf, SHOT), check);
    await own.close();
  };
  const sizes = Object.values(model.parts).map(({ length }) => length);
  const [bin, first] = sizes;
  await limited({ L_FILE_BYTES: bin - 1 }, { code: 'L_FILE_BYTES', limit: { name: 'L_FILE_BYTES', max: bin - 1, actual: bin } });
  await limited(
    { L_EXTERNAL_BYTES: bin + first - 1 },
    { code: 'L_EXTERNAL_BYTES', pointer: '/images/0/uri', limit: { name: 'L_EXTERNAL_BYTES', max: bin + first - 1, actual: bin + first } },
  );
  await limited({ L_EXTERNAL_FILES: 1 }, { code: 'L_EXTERNAL_FILES', pointer: '/images/0/uri' });
});

test('an abort ends the wait, and the resolver hears of it', async () => {
  const controller = new AbortController();
  let heard;
  const resolve = (_, { signal }) =>
    new Promise((_resolve, reject) =>
      signal.addEventListener('abort', () => {
        heard = signal.reason;
        reject(signal.reason);
      }),
    );
  const job = renderer.render(model.gltf, SHOT, { resolve, signal: controller.signal });
  setTimeout(() => controller.abort(new Error('enough')), 50);
  await assert.rejects(job, { message: 'enough' });
  assert.equal(heard.message, 'enough');
  // One that never answers holds up nothing once it is aborted: more of them than there are threads.
  const stuck = Array.from({ length: 8 }, () =>
    renderer.load(model.gltf, { resolve: () => new Promise(() => {}), signal: AbortSignal.timeout(50) }).catch(({ name }) => name),
  );
  assert.deepEqual(await Promise.all(stuck), Array(8).fill('TimeoutError'));
  await renderer.render(model.gltf, SHOT, { resolve: fromStore });
});

test('slow stores hold up no other model', async () => {
  let open;
  const gate = new Promise((resolve) => {
    open = resolve;
  });
  const slow = Array.from({ length: 3 }, () =>
    renderer.load(model.gltf, {
      resolve: async (uri) => {
        await gate;
        return fromStore(uri);
      },
    }),
  );
  await renderer.render(glb, SHOT);
  open();
  assert.equal((await Promise.all(slow)).length, 3);
});

test('nothing holds a resolver, nor what it holds, behind its load', async () => {
  v8.setFlagsFromString('--expose-gc');
  const collect = vm.runInNewContext('gc');
  const load = async (options) => {
    const resolve = (uri) => fromStore(uri);
    await renderer.load(model.gltf, { resolve, ...options }).catch(() => {});
    return new WeakRef(resolve);
  };
  const held = [await load(), await load({ signal: AbortSignal.abort() }), await load({ failOn: 'none' })];
  for (let i = 0; i < 20 && held.some((ref) => ref.deref()); ++i) {
    await sleep(10);
    collect();
  }
  assert.deepEqual(
    held.map((ref) => ref.deref()),
    [undefined, undefined, undefined],
  );
});
