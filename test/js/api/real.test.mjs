import assert from 'node:assert/strict';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import * as THREE from 'three';
import { createRenderer, doctor, inspect } from '../../../js/index.mjs';
import { applyShot } from '../../../js/three/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { runChild } from './support/child.mjs';
import { fixturesUrl, indexUrl } from './support/real.mjs';

const WORKER = new URL('./support/real_worker.mjs', import.meta.url);
const SHOT = { size: { width: 96, height: 64 } };
const BIG = { size: { width: 1024, height: 1024 } };

let renderer, cloth;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  cloth = await MODELS.cloth();
  await renderer.render(cloth, SHOT);
});
after(() => renderer.close());

test('one frame: a PNG of the size asked for, and its facts', async () => {
  const { data, info } = await renderer.render(cloth, SHOT);
  assert.equal(data.subarray(1, 4).toString('latin1'), 'PNG');
  assert.deepEqual([data.readUInt32BE(16), data.readUInt32BE(20)], [96, 64]);
  assert.deepEqual([info.width, info.height, info.format], [96, 64, 'png']);
  assert.ok(info.features.includes('normal-map') && info.passes.includes('opaque'));
  assert.match(info.gl.version, /OpenGL ES 3|^4\./);
  const { load, resolve, queue, draw, encode, total } = info.milliseconds;
  for (const ms of [load, resolve, queue, draw, encode]) assert.ok(ms >= 0 && ms <= total);
});

test('every output format', async () => {
  const magic = { png: '89504e47', jpeg: 'ffd8ff', webp: '52494646', tiff: '49492a00', exr: '762f3101' };
  for (const [format, start] of Object.entries(magic)) {
    const { data } = await renderer.render(cloth, { ...SHOT, output: { format } });
    assert.equal(data.subarray(0, start.length / 2).toString('hex'), start, format);
  }
  assert.equal((await renderer.render(cloth, { ...SHOT, output: { format: 'raw' } })).data.length, 96 * 64 * 4);
  assert.equal((await renderer.render(cloth, { ...SHOT, output: { format: 'raw', bitDepth: 32 } })).data.length, 96 * 64 * 16);
});

test('the same bytes from a loaded model, from renderAll, and from another thread', async () => {
  const [once] = await renderer.renderAll(cloth, [SHOT]);
  const loaded = await renderer.load(cloth);
  assert.deepEqual((await renderer.render(loaded, SHOT)).data, once.data);
  const worker = new Worker(WORKER, { workerData: { model: cloth, shot: SHOT, frames: 1 } });
  const data = await new Promise((resolve, reject) => {
    worker.on('message', (message) => {
      if (message !== 'open') resolve(message);
    });
    worker.on('error', reject);
  });
  assert.deepEqual(Buffer.from(data), once.data);
});

for (const camera of [
  { view: 'three-quarter' },
  { azimuth: 30, elevation: -20, projection: 'orthographic' },
  { view: 'top' },
  { position: [1, 2, 3], target: [0.2, 0.1, -0.3], up: [0.1, 1, 0], fovY: 50, near: 0.1, far: 20 },
]) {
  test(`worldToPixel agrees with three.js: ${JSON.stringify(camera)}`, async () => {
    const { info } = await renderer.render(cloth, { ...SHOT, camera });
    const stub = { shadowMap: {}, setPixelRatio() {}, setSize() {}, setClearColor() {} };
    const shot = { ...info.shot, environment: { map: 'none', intensity: 1, rotation: 0 } };
    const view = await applyShot(shot, { THREE, renderer: stub, scene: new THREE.Scene() });
    const matrix = new THREE.Matrix4().fromArray(info.worldToPixel);
    for (const point of [
      [0, 0, 0],
      [0.5, -1, 0.25],
      [-1, 1, -0.5],
    ]) {
      const ndc = new THREE.Vector3(...point).project(view);
      const expected = [(ndc.x + 1) * 48, (1 - ndc.y) * 32, (ndc.z + 1) / 2];
      new THREE.Vector3(...point)
        .applyMatrix4(matrix)
        .toArray()
        .forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-7, `${value} ${expected[i]}`));
    }
  });
}

test('the event loop runs on while a large frame is drawn and encoded', async () => {
  const delay = monitorEventLoopDelay({ resolution: 1 });
  delay.enable();
  const { info } = await renderer.render(cloth, BIG);
  delay.disable();
  assert.ok(info.milliseconds.total > 30);
  assert.ok(delay.percentile(99) / 1e6 < 50, `p99 ${delay.percentile(99) / 1e6} ms`);
});

test('random aborts leave a renderer that draws the same', async () => {
  const expected = (await renderer.render(cloth, SHOT)).data;
  let seed = 3;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const outcomes = [];
  for (let i = 0; i < 30; ++i) {
    const signal = AbortSignal.timeout(Math.round(random() * 120));
    outcomes.push(
      await renderer.render(cloth, { size: { width: 400, height: 400 } }, { signal }).then(
        () => 'drawn',
        ({ name }) => name,
      ),
    );
  }
  assert.deepEqual(
    outcomes.filter((outcome) => outcome !== 'drawn' && outcome !== 'TimeoutError'),
    [],
  );
  assert.deepEqual((await renderer.render(cloth, SHOT)).data, expected);
});

test('errors of a file reach the caller with their place', async () => {
  await assert.rejects(renderer.render(new Uint8Array(0)), { name: 'TelarError', code: 'E_EMPTY' });
  await assert.rejects(renderer.render(cloth.subarray(0, cloth.length / 2)), { kind: 'input' });
  const missing = await renderer.render('no/such/file.glb').catch((error) => error);
  assert.equal(missing.kind, 'input');
  assert.ok(!missing.message.includes(process.cwd()));
});

test('inspect plans what a render reports', async () => {
  const flat = { ...SHOT, style: 'flat' };
  for (const shot of [SHOT, flat, { ...flat, layers: ['line'] }, { ...flat, layers: ['beauty', 'depth'] }]) {
    const { plan, bounds } = await inspect(cloth, { shot });
    const { info } = await renderer.render(cloth, shot);
    assert.deepEqual([plan.features, plan.passes], [info.features, info.passes]);
    assert.equal(bounds.min.length, 3);
  }
});

test('doctor names what createRenderer takes', async () => {
  const report = await doctor();
  assert.equal(report.ok, true);
  assert.equal(report.chosen, renderer.backend);
});

test('six workers draw at once, the same bytes', async () => {
  const expected = (await renderer.render(cloth, SHOT)).data;
  const all = await Promise.all(
    Array.from(
      { length: 6 },
      () =>
        new Promise((resolve, reject) => {
          const worker = new Worker(WORKER, { workerData: { model: cloth, shot: SHOT, frames: 2 } });
          const frames = [];
          worker.on('message', (message) => {
            if (message !== 'open') frames.push(message);
          });
          worker.on('error', reject);
          worker.on('exit', () => resolve(frames));
        }),
    ),
  );
  for (const frames of all)
    assert.deepEqual(
      frames.map((data) => Buffer.from(data).equals(expected)),
      [true, true],
    );
});

test('a worker may be terminated at any moment, 20 times', async () => {
  let seed = 11;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const workerData = { model: cloth, shot: { size: { width: 300, height: 300 } }, frames: 1000 };
  for (let i = 0; i < 20; ++i) {
    const worker = new Worker(WORKER, { workerData });
    worker.on('error', (error) => assert.fail(error));
    // Every fourth dies while it makes its context.
    if (i % 4 !== 0) await new Promise((resolve) => worker.once('message', resolve));
    await sleep(random() * 150);
    await worker.terminate();
  }
});

test('process.exit() at any moment of a real frame keeps its code, 6 times', async () => {
  for (let i = 0; i < 6; ++i) {
    const { code, signal, stderr } = await runChild(
      `
      import { createRenderer } from '${indexUrl}';
      import { MODELS } from '${fixturesUrl}';
      const cloth = await MODELS.cloth();
      setTimeout(() => process.exit(7), ${80 * i});
      const renderer = await createRenderer({ cacheDirectory: null });
      for (;;) await renderer.render(cloth, { size: { width: 512, height: 512 } });`,
      { support: false },
    );
    assert.deepEqual([code, signal, stderr], [7, null, ''], `after ${80 * i} ms`);
  }
});

test('the process ends by itself with a renderer open', async () => {
  const { code, signal, stderr } = await runChild(
    `
    import { createRenderer } from '${indexUrl}';
    await createRenderer({ cacheDirectory: null });`,
    { support: false },
  );
  assert.deepEqual([code, signal, stderr], [0, null, '']);
});
