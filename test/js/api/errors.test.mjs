import assert from 'node:assert/strict';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { TelarError } from '../../../js/error/index.mjs';
import { inspectOn } from '../../../js/api/inspect.mjs';
import { cureIn } from '../../../js/api/native.mjs';
import { createRendererOn } from '../../../js/api/renderer.mjs';
import { runChild } from './support/child.mjs';
import { SHOT, model, native, openRenderer } from './support/double.mjs';

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

const EXPECTED = {
  error: {
    code: 'L_VERTICES',
    kind: 'limit',
    message: 'the double was told to fail',
    retryable: false,
    pointer: '/accessors/3',
    offset: 5_000_000_000,
    limit: { name: 'L_VERTICES', max: 10, actual: 11 },
  },
  memory: { code: 'X_MEMORY', kind: 'memory', message: 'there is not enough memory for this job', retryable: true },
  exception: { code: 'X_INTERNAL', kind: 'internal', message: 'the double was told to fail', retryable: false },
  number: { code: 'X_INTERNAL', kind: 'internal', message: 'an exception of an unknown type was thrown', retryable: false },
};

for (const stage of ['load', 'draw', 'encode']) {
  for (const [as, expected] of Object.entries(EXPECTED)) {
    test(`${as} thrown by ${stage}`, async () => {
      const error = await renderer.render(model({ fail: { stage, as } }), SHOT).catch((thrown) => thrown);
      assert.ok(error instanceof TelarError && error instanceof Error);
      assert.deepEqual(error.toJSON(), expected);
    });
  }
}

test('a backend that fails', async () => {
  await assert.rejects(createRendererOn(native, { backend: 'osmesa' }), { code: 'X_GL', message: 'the double has no OSMesa' });
});

const SOURCE = 'source: expected a path, a file: URL, bytes (Buffer, Uint8Array, ArrayBuffer) or a loaded model, got';
const CALLER_ERRORS = [
  [(r) => r.render(), `${SOURCE} nothing`],
  [(r) => r.render(''), `${SOURCE} ""`],
  [(r) => r.render('a\0b'), `${SOURCE} "a\\u0000b"`],
  [(r) => r.render(5, SHOT), `${SOURCE} 5`],
  [(r) => r.render(new URL('https://example.com/a.glb')), `${SOURCE} "https://example.com/a.glb"`],
  [(r) => r.render('file://host/a.glb'), `${SOURCE} "file://host/a.glb"`],
  [(r) => r.render({ scene: 1 }), `${SOURCE} {"scene"}`],
  [(r) => r.load(null), `${SOURCE} null`],
  [(r) => r.render(model(), SHOT, { signal: 1 }), 'options.signal: expected an AbortSignal, got 1'],
  [(r) => r.render(model(), SHOT, { sginal: 1 }), 'options.sginal: unknown key, did you mean signal?'],
  [(r) => r.render(model(), SHOT, null), 'options: expected an object, got null'],
  [(r) => r.renderAll(model(), SHOT), 'shots: expected an array of shots, got {"size"}'],
  [(r) => r.release('a.glb'), 'model: expected a loaded model, got "a.glb"'],
  [() => createRendererOn(native, { backend: 'vulkan' }), 'options.backend: expected "auto", "egl-device", "egl-surfaceless", "osmesa", got "vulkan"'],
  [() => createRendererOn(native, { limits: { L_FILE_BYTE: 1 } }), 'options.limits.L_FILE_BYTE: unknown key, did you mean L_FILE_BYTES?'],
  [
    () => createRendererOn(native, { limits: { L_FILE_SIZE_MAX: 1 } }),
    /^options\.limits\.L_FILE_SIZE_MAX: unknown key, the nearest of \d+ is L_FILE_BYTES; js\/docs\/errors\.md has them all$/,
  ],
  [() => createRendererOn(native, { limits: { L_NODES: -1 } }), 'options.limits.L_NODES: expected a whole number of at least 0, got -1'],
  [() => createRendererOn(native, { limits: { L_NODES: NaN } }), 'options.limits.L_NODES: expected a whole number of at least 0, got NaN'],
  [() => createRendererOn(native, { limits: 3 }), 'options.limits: expected an object, got 3'],
  [() => createRendererOn(native, { cacheDirectory: '' }), 'options.cacheDirectory: expected a path, or null for none, got ""'],
  [() => createRendererOn(native, { maxWaiting: 0.5 }), 'options.maxWaiting: expected a whole number of at least 0, got 0.5'],
  [() => createRendererOn(native, { allFeatures: 1 }), 'options.allFeatures: expected true or false, got 1'],
  [
    () => createRendererOn(native, { zzz: 1 }),
    'options.zzz: unknown key, expected one of backend, cacheDirectory, cacheBytes, limits, maxWaiting, timeoutMs, failOn, resolve, ambientVisibility, allFeatures, signal',
  ],
  [() => createRendererOn(native, { cacheBytes: -1 }), 'options.cacheBytes: expected a whole number of at least 0, got -1'],
  [() => createRendererOn(native, { failOn: 'warn' }), 'options.failOn: expected "error", "warning", "none", got "warn"'],
  [() => createRendererOn(native, { resolve: {} }), 'options.resolve: expected a function, got {}'],
  [(r) => r.load(model(), { failOn: true }), 'options.failOn: expected "error", "warning", "none", got true'],
  [(r) => r.render(model(), SHOT, { resolve: 'a' }), 'options.resolve: expected a function, got "a"'],
  [(r) => r.renderAll(model(), [], { settled: 1 }), 'options.settled: expected true or false, got 1'],
  [
    (r) => r.render(model(), SHOT, { settled: true }),
    'options.settled: unknown key, expected one of signal, timeoutMs, onProgress, failOn, resolve, ambientVisibility, onPreview, reached',
  ],
  [() => inspectOn(native, model(), { failOn: 0 }), 'options.failOn: expected "error", "warning", "none", got 0'],
  [() => inspectOn(native, model(), { limits: [] }), 'options.limits: expected an object, got []'],
];

for (const [call, message] of CALLER_ERRORS) {
  test(`caller error: ${String(message).slice(0, 90)}`, async () => {
    let promise;
    assert.doesNotThrow(() => {
      promise = call(renderer);
    }, 'a promise rejects, nothing throws');
    await assert.rejects(promise, { code: 'E_OPTION', kind: 'usage', message });
  });
}

test('a wrong shot', async () => {
  await assert.rejects(renderer.render(model(), { size: { width: 0 } }), { code: 'E_SHOT', pointer: '/size/width' });
  await assert.rejects(renderer.render(model(), null), { code: 'E_SHOT', message: 'shot: expected an object' });
  await assert.rejects(renderer.render(model(), { size: () => 1 }), { code: 'E_SHOT' });
});

test('bytes over the limit are refused before they are copied', async () => {
  const small = await createRendererOn(native, { limits: { L_FILE_BYTES: 10 }, cacheDirectory: null });
  await assert.rejects(small.render(new Uint8Array(11)), { code: 'L_FILE_BYTES', limit: { name: 'L_FILE_BYTES', max: 10, actual: 11 } });
  await small.close();
});

test('too many waiting jobs are refused, the others done', async () => {
  const small = await createRendererOn(native, { maxWaiting: 2, cacheDirectory: null });
  const outcomes = await Promise.allSettled(Array.from({ length: 8 }, () => small.render(model({ drawMs: 10 }), SHOT)));
  const refused = outcomes.filter(({ status }) => status === 'rejected').map(({ reason }) => reason);
  assert.deepEqual(
    refused.map(({ code, retryable }) => [code, retryable]),
    [
      ['X_BUSY', true],
      ['X_BUSY', true],
    ],
  );
  await small.close();
});

test('close() finishes what was asked for, may be called again, and refuses what comes after', async () => {
  const one = await openRenderer();
  const jobs = Array.from({ length: 6 }, () => one.render(model({ drawMs: 15 }), SHOT));
  const loaded = one.load(model());
  const closed = one.close();
  assert.equal(one.close(), closed);
  await closed;
  const sizes = (await Promise.all(jobs)).map(({ data }) => data.length);
  assert.equal(new Set(sizes).size, 1);
  const scene = await loaded;
  for (const call of [
    () => one.render(model(), SHOT),
    () => one.load(model()),
    () => one.renderAll(scene, [SHOT]),
    () => one.release(scene),
    () => one.liveObjects(),
  ]) {
    await assert.rejects(call(), { code: 'X_CLOSED', message: 'the renderer was closed; make a new one with createRenderer()' });
  }
  assert.equal((await renderer.render(scene, SHOT)).info.backend, 'double', 'its models are drawn by others');
});

test('Symbol.asyncDispose closes', async () => {
  const one = await openRenderer();
  await one[Symbol.asyncDispose]();
  await assert.rejects(one.load(model()), { code: 'X_CLOSED' });
});

test('a missing or damaged addon names the cure', async () => {
  const text = `
    const { createRenderer, doctor } = await import('${new URL('../../../js/index.mjs', import.meta.url)}');
    const { code, message } = await createRenderer().catch((error) => error);
    const { ok, native } = await doctor();
    console.log(JSON.stringify({ code, message, ok, native: native.error.code }));`;
  const { stdout, stderr } = await runChild(`process.env.TELAR_BUILD_DIR = '/nowhere'; ${text}`);
  assert.deepEqual(JSON.parse(stdout || stderr), {
    code: 'X_NATIVE_MISSING',
    ok: false,
    native: 'X_NATIVE_MISSING',
    message:
      'the native part of telar is not built (tried telar.node): run `npm run build` in the folder of telar ' +
      '(it needs the Debian packages that `npm run setup` installs)',
  });
});

test('the cure of a missing addon is one that the package has', async () => {
  const root = await mkdtemp(path.join(tmpdir(), 'telar-cure-'));
  try {
    assert.match(cureIn(root), /^install telar with its optional dependencies/);
    await writeFile(path.join(root, 'CMakeLists.txt'), '');
    assert.match(cureIn(root), /^run `npm run build` .* \(it names the Debian packages that are missing; js\/machine\/debian_packages\.txt lists them all\)$/);
    await mkdir(path.join(root, 'js/setup'), { recursive: true });
    assert.match(cureIn(root), /`npm run setup` installs/);
  } finally {
    await rm(root, { recursive: true });
  }
});

test('native code takes no handle for another', () => {
  const token = new native.CancelToken();
  assert.throws(() => native.load(token, {}, {}, token), TypeError);
  assert.throws(() => native.plan(new native.Bytes(new Uint8Array(1), 1), '{}', {}, token), TypeError);
  assert.throws(() => native.load('x', {}, {}, {}), TypeError);
});

test('native code frees the bytes of a model with their last use', async () => {
  const token = new native.CancelToken();
  const bytes = new native.Bytes(model(), 100);
  const loading = native.load(bytes, {}, {}, token);
  assert.throws(() => native.load(bytes, {}, {}, token), /for the last time/);
  assert.ok((await loading).scene, 'what runs has them still');
});

test('native code frees a scene with its last use', async () => {
  const { scene } = await native.load(new native.Bytes(model(), 100), {}, {}, new native.CancelToken());
  const { info } = await renderer.render(model(), SHOT);
  await native.plan(scene, JSON.stringify(info.shot), {}, new native.CancelToken());
  assert.throws(() => native.plan(scene, JSON.stringify(info.shot), {}, new native.CancelToken()), TypeError);
});
