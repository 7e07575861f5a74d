import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { TelarError, createRenderer, evaluateShading } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { errorOf, open, SHOT } from './support.mjs';

// A pool gives what a renderer in this process gives: pictures byte for byte, facts, and errors word for word.

let renderer, pool, glb, folder, file;
before(async () => {
  [renderer, pool, glb] = await Promise.all([createRenderer({ cacheDirectory: null }), open({ size: 2 }), MODELS.cloth()]);
  folder = mkdtempSync(path.join(tmpdir(), 'telar-pool-'));
  file = path.join(folder, 'cloth.glb');
  writeFileSync(file, glb);
});
after(async () => {
  await Promise.all([renderer.close(), pool.close()]);
  rmSync(folder, { recursive: true });
});

/** What does not depend on when and where it was drawn, as JSON has it. */
const lasting = ({ milliseconds, peakBytes, environmentSource, programsCompiled, glObjects, ...info }) => JSON.parse(JSON.stringify(info));
const both = (use) => Promise.all([use(renderer), use(pool)]);

const SHOTS = {
  plain: SHOT,
  'by another view': { ...SHOT, camera: { view: 'back' }, background: '#345' },
  'in layers': { ...SHOT, layers: ['beauty', 'normal', 'partId'] },
  'metered, by a look': { ...SHOT, look: 'catalogue' },
  'by the path tracer': { size: { width: 12, height: 12 }, quality: { preset: 'reference', samples: 2 } },
};
for (const [name, shot] of Object.entries(SHOTS)) {
  test(`render: ${name}`, async () => {
    const [own, far] = await both((to) => to.render(glb, shot));
    assert.ok(far.data.equals(own.data) && far.data.length > 100);
    assert.deepEqual(far.layers, own.layers);
    assert.deepEqual(lasting(far.info), lasting(own.info));
  });
}

test('render: by path, URL, ArrayBuffer and shared memory; the caller may write to the bytes at once', async () => {
  const expected = (await renderer.render(glb, SHOT)).data;
  const other = (await renderer.render(glb, { ...SHOT, camera: { view: 'back' } })).data;
  assert.ok(!other.equals(expected), 'a difference would be seen');
  const shared = new Uint8Array(new SharedArrayBuffer(glb.length));
  shared.set(glb);
  for (const source of [file, pathToFileURL(file), new Uint8Array(glb).buffer, shared]) {
    assert.ok((await pool.render(source, SHOT)).data.equals(expected), String(source));
  }
  const mine = Buffer.from(glb);
  const drawn = pool.render(mine, SHOT);
  mine.fill(0);
  assert.ok((await drawn).data.equals(expected));
});

test('render: an environment of bytes, which info gives back', async () => {
  const hdr = Buffer.concat([
    Buffer.from('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n'),
    Buffer.from(Array.from({ length: 8 }, (_, i) => [200, 90 + 9 * i, 60, 129]).flat()),
  ]);
  const shot = { ...SHOT, environment: { map: hdr, rotation: 30 } };
  const [own, far] = await both((to) => to.render(glb, shot));
  assert.ok(far.data.equals(own.data));
  assert.ok(!far.data.equals((await renderer.render(glb, SHOT)).data), 'the light is another');
  assert.deepEqual(Buffer.from(far.info.shot.environment.map), hdr);
  assert.equal(far.info.key, own.info.key);
});

test('a relative path of a shot starts at the current folder of the call', async () => {
  const before = process.cwd();
  process.chdir(folder);
  try {
    writeFileSync(path.join(folder, 'light.hdr'), '#?RADIANCE\nno\n');
    const [own, far] = (await Promise.allSettled([renderer, pool].map((to) => to.render(glb, { ...SHOT, environment: 'light.hdr' })))).map(
      ({ reason }) => reason,
    );
    assert.equal(far.code, 'E_ENVIRONMENT_CORRUPT');
    assert.deepEqual(far.toJSON(), own.toJSON());
  } finally {
    process.chdir(before);
  }
});

test('load, then render in each worker; facts, measure, flat, swatch and explode', async () => {
  const [own, far] = await both((to) => to.load(glb));
  assert.deepEqual(far.facts, JSON.parse(JSON.stringify(own.facts)));
  const expected = (await renderer.render(own, SHOT)).data;
  for (const { data } of await Promise.all([1, 2, 3, 4].map(() => pool.render(far, SHOT)))) assert.ok(data.equals(expected));
  assert.ok(
    pool.workers.every(({ jobs }) => jobs > 0),
    'both have drawn',
  );
  const ask = {
    points: [
      [0, 0, 0],
      [0.1, 0, 0],
    ],
    along: 'surface',
  };
  assert.deepEqual(await far.measure(ask), JSON.parse(JSON.stringify(await own.measure(ask))));
  assert.deepEqual(await far.flat(SHOT), JSON.parse(JSON.stringify(await own.flat(SHOT))));
  for (const derive of [(model) => model.swatch({ part: { material: 0 }, size: 0.05 }), (model) => model.explode(0.1)]) {
    const [ownSquare, farSquare] = await Promise.all([derive(own), derive(far)]);
    assert.equal(farSquare.facts.sha256, ownSquare.facts.sha256);
    const square = (await renderer.render(ownSquare, SHOT)).data;
    for (const { data } of await Promise.all([1, 2, 3].map(() => pool.render(farSquare, SHOT)))) assert.ok(data.equals(square));
  }
});

test('a model is loaded again after release(), and refused where its file has changed', async () => {
  const model = await pool.load(file);
  const expected = (await pool.render(model, SHOT)).data;
  await pool.release(model);
  assert.ok((await pool.render(model, SHOT)).data.equals(expected));
  await pool.release(model);
  writeFileSync(file, await MODELS.ball());
  assert.equal((await errorOf(pool.render(model, SHOT)))?.code, 'E_FILE');
  writeFileSync(file, glb);
  assert.ok((await pool.render(model, SHOT)).data.equals(expected));
});

test('renderAll, and settled where some shots are wrong', async () => {
  const shots = [SHOT, { ...SHOT, camera: { view: 'left' } }, { size: { width: 20, height: 40 } }];
  const [own, far] = await both((to) => to.renderAll(glb, shots));
  assert.deepEqual(
    far.map(({ data }) => data),
    own.map(({ data }) => data),
  );
  const wrong = [SHOT, { size: { width: 0 } }, null, SHOT, { size: () => 1 }, { nothing: 1 }];
  const [ownSettled, farSettled] = await both((to) => to.renderAll(glb, wrong, { settled: true }));
  const told = (outcomes) => outcomes.map(({ status, value, reason }) => [status, value?.data, reason?.toJSON()]);
  assert.deepEqual(told(farSettled), told(ownSettled));
  assert.deepEqual(
    farSettled.filter(({ reason }) => reason).map(({ reason }) => reason.index),
    [1, 2, 4, 5],
  );
});

test('renderQuantity and factsOf', async () => {
  const [own, far] = await both((to) => to.renderQuantity(glb, SHOT, 'baseColor'));
  assert.deepEqual(far, own);
  assert.ok(far.data.some((value) => value > 0));
  const [ownFacts, farFacts] = await both((to) => to.factsOf(glb, { frame: { node: 0 } }));
  assert.deepEqual(farFacts, JSON.parse(JSON.stringify(ownFacts)));
});

test('progress never falls and ends with 1; what it throws is what the call rejects with', async () => {
  const told = [];
  await pool.renderAll(glb, [SHOT, SHOT, SHOT], { onProgress: (part) => told.push(part) });
  assert.ok(told.length > 0 && told.at(-1) === 1 && told.every((part, i) => i === 0 || part > told[i - 1]), String(told));
  const mine = new Error('enough');
  const thrown = await errorOf(
    pool.render(glb, SHOT, {
      onProgress: () => {
        throw mine;
      },
    }),
  );
  assert.equal(thrown, mine);
});

/** Of each method, what is wrong with its call, or with its file. */
const WRONG = [
  (to) => to.render(),
  (to) => to.render('a\0b'),
  (to) => to.render('/no/such/file.glb'),
  (to) => to.render(Buffer.from('plain text')),
  (to) => to.render(Buffer.alloc(0)),
  (to) => to.render(glb.subarray(0, 300)),
  (to) => to.render(glb, null),
  (to) => to.render(glb, { size: { width: Number.NaN } }),
  (to) => to.render(glb, { nothing: 1 }),
  (to) => to.render(glb, { camera: { view: 'bakc' } }),
  (to) => to.render(glb, { size: () => 1 }),
  (to) => to.render(glb, { variant: 'none such' }),
  (to) => to.render(glb, SHOT, { timeout: 5 }),
  (to) => to.render(glb, SHOT, { timeoutMs: 0 }),
  (to) => to.render(glb, SHOT, { signal: 5 }),
  (to) => to.render(glb, SHOT, { failOn: 'no' }),
  (to) => to.render(glb, { ...SHOT, lens: { focusDistance: 1 } }, { failOn: 'warning' }),
  (to) => to.render(glb, { ...SHOT, quality: { preset: 'reference', samples: 65_536 } }, { timeoutMs: 500 }),
  (to) => to.renderAll(glb, 5),
  (to) => to.renderAll(glb, [SHOT, { size: { width: 0 } }]),
  (to) => to.renderAll(glb, [SHOT, { size: () => 1 }]),
  (to) => to.renderQuantity(glb, SHOT, 'none such'),
  (to) => to.renderQuantity(glb, { nothing: 1 }, 'baseColor'),
  (to) => to.factsOf(glb, { pose: { animation: 'none such' } }),
  (to) => to.load(5),
  (to) => to.load(glb, { nothing: 1 }),
  (to) => to.release({}),
  async (to) => (await to.load(glb)).measure({ points: [] }),
  async (to) => (await to.load(glb)).measure(),
  async (to) => (await to.load(glb)).flat({ nothing: 1 }),
  async (to) => (await to.load(glb)).flat({}, { color: '<' }),
  async (to) => (await to.load(glb)).swatch({}),
  async (to) => (await to.load(glb)).swatch({ part: { material: 'none such' } }),
  async (to) => (await to.load(glb)).explode(-1),
];
for (const [i, use] of WRONG.entries()) {
  test(`the same error: ${String(use).replace(/^.*?\bto\b[).]*/, '')} (${i})`, async () => {
    const [own, far] = await Promise.all([errorOf(use(renderer)), errorOf(use(pool))]);
    assert.ok(own instanceof TelarError && far instanceof TelarError, String([own, far]));
    assert.deepEqual(far.toJSON(), own.toJSON());
  });
}

test('models of a renderer and of a pool are not taken for one another', async () => {
  const [own, far] = await both((to) => to.load(glb));
  assert.equal((await errorOf(pool.render(own, SHOT))).code, 'E_OPTION');
  assert.equal((await errorOf(renderer.render(far, SHOT))).code, 'E_OPTION');
  assert.equal((await errorOf(evaluateShading({ model: far, material: 0 }))).code, 'E_OPTION');
});

test('options of createPool', async () => {
  for (const [options, message] of [
    [{ sizes: 2 }, 'options.sizes: unknown key, did you mean size?'],
    [{ size: 0 }, 'options.size: expected a whole number of at least 1, got 0'],
    [{ memoryBytes: 0.5 }, 'options.memoryBytes: expected a whole number of at least 1, got 0.5'],
    [{ backend: 'x' }, 'options.backend: expected "auto", "egl-device", "egl-surfaceless", "osmesa", got "x"'],
  ]) {
    const error = await errorOf(open(options));
    assert.deepEqual([error?.code, error?.message], ['E_OPTION', message]);
  }
});
