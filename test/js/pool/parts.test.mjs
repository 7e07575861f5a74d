import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { Duplex, PassThrough } from 'node:stream';
import { test } from 'node:test';
import { libraryBeside } from '../../../js/api/native.mjs';
import { awake } from '../../../js/pool/awake.mjs';
import { Breaker } from '../../../js/pool/breaker.mjs';
import { Channel } from '../../../js/pool/channel.mjs';
import { DEFAULTS, defaultSize, threadsOfEach, usableBytes } from '../../../js/pool/defaults.mjs';
import { workerEnvironment } from '../../../js/pool/environment.mjs';
import { HeldModels } from '../../../js/pool/held_models.mjs';
import { Quarantine } from '../../../js/pool/quarantine.mjs';
import { hasLongShot } from '../../../js/api/long_shot.mjs';
import { unpackPicture } from '../../../js/pool/pictures.mjs';
import { Recipe } from '../../../js/pool/recipe.mjs';
import { RunningJob } from '../../../js/pool/running_job.mjs';
import { Workers } from '../../../js/pool/workers.mjs';
import { poolOptions } from '../../../js/pool/options.mjs';
import { errorOf } from './support.mjs';

// What a pool is made of, each part alone and with a clock of the test.

const json = { encode: (message) => Buffer.from(JSON.stringify(message)), decode: JSON.parse };

/** What a channel reads of these bytes, given in pieces of so many. */
async function readIn(pieces, bytes, maxBytes = null) {
  const stream = new PassThrough();
  const [taken, refused] = [[], []];
  const channel = new Channel(stream, {
    ...json,
    take: (message, parts) => taken.push([message, parts.map(String)]),
    refuse: ({ bytes, name }) => refused.push(bytes ?? name),
  });
  channel.maxBytes = maxBytes;
  for (let at = 0; at < bytes.length; at += pieces) stream.write(bytes.subarray(at, at + pieces));
  await new Promise((resolve) => stream.end(resolve));
  await new Promise(setImmediate);
  return { taken, refused };
}

function written(...frames) {
  const chunks = [];
  const stream = new Duplex({ read() {}, write: (chunk, _, done) => done(chunks.push(chunk) && null) });
  const channel = new Channel(stream, { ...json, take: () => {}, refuse: assert.fail });
  for (const [message, parts] of frames)
    channel.send(
      message,
      parts?.map((text) => Buffer.from(text)),
    );
  return Buffer.concat(chunks);
}

test('frames arrive whole, however the stream cuts them', async () => {
  const frames = [
    [{ a: 1 }, []],
    [{ b: 'ü' }, ['one', '', 'three']],
    [{}, ['x'.repeat(300)]],
  ];
  const bytes = written(...frames);
  for (const pieces of [1, 2, 3, 7, 64, bytes.length]) assert.deepEqual((await readIn(pieces, bytes)).taken, frames, String(pieces));
  assert.deepEqual((await readIn(5, bytes.subarray(0, -1))).taken, frames.slice(0, 2), 'a frame that is cut is none');
});

test('a frame that is too large is refused before it is there', async () => {
  const bytes = written([{ a: 1 }, ['small']], [{}, ['x'.repeat(100)]]);
  assert.deepEqual(await readIn(4, bytes.subarray(0, 40), 50), { taken: [[{ a: 1 }, ['small']]], refused: [102] });
  assert.deepEqual(await readIn(4, Buffer.alloc(8, 255)), { taken: [], refused: [Infinity] });
});

test('what is no message is refused, and nothing is read after it', async () => {
  const bytes = Buffer.concat([Buffer.from([1, 0, 0, 0, 0, 0, 0, 0]), Buffer.from('{'), written([{ a: 1 }])]);
  assert.deepEqual(await readIn(3, bytes), { taken: [], refused: ['SyntaxError'] });
});

test('a worker that answers what nobody asked does no harm to its parent', async () => {
  const sent = [];
  const worker = { send: (message) => sent.push(Object.keys(message)[0]), kill: assert.fail };
  const request = {
    method: 'measure',
    recipe: new Recipe({ input: { path: '/a' }, loading: {} }),
    args: [{}],
    timeoutMs: null,
    unpack: ({ length }) => length,
  };
  const job = new RunningJob(1, request, worker, new HeldModels(0), undefined);
  for (const message of [{ ask: 0, uri: 'a' }, { progress: 'x' }, { beat: 7 }, { done: 2, value: 1 }, {}]) assert.equal(job.take(message, []), false);
  await new Promise(setImmediate);
  assert.deepEqual(sent, ['job', 'part'], 'what is asked is answered with an error');
  const outcome = errorOf(job.outcome);
  assert.equal(job.take({ done: 1, value: null }, []), true);
  assert.equal((await outcome)?.code, 'X_INTERNAL');
  assert.throws(() => unpackPicture({ info: { shot: {} } }, []), { code: 'X_INTERNAL' });
});

test('a worker that does not stop after the abort is ended, whatever of its messages was on the way', async () => {
  for (const late of [{ beat: 1 }, { progress: 0.5 }, { begun: 1 }]) {
    const recipe = new Recipe({ input: { path: '/a' }, loading: {} });
    const request = { method: 'renderAll', recipe, shots: [], timeoutMs: 3_600_000, unpack: assert.fail };
    const mine = new AbortController();
    const killed = new Promise((resolve) => {
      const worker = { send: () => {}, kill: resolve };
      const job = new RunningJob(1, request, worker, new HeldModels(0), mine.signal);
      job.outcome.catch(() => {});
      mine.abort(new Error('mine'));
      job.take(late, []);
    });
    assert.equal(await awake(killed), undefined, 'by no verdict of a clock');
  }
});

test('the quarantine: two crashes of the same bytes in a row, for so long', async (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-quarantine-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const [bad, good] = ['bad', 'god'].map((name) => path.join(folder, name));
  writeFileSync(bad, 'bad');
  writeFileSync(good, 'god');
  let now = 0;
  const quarantine = new Quarantine(1000, () => now);
  const refused = async (input) => (await errorOf(quarantine.check([input].flat())))?.code === 'X_QUARANTINE';
  const bytes = { bytes: Buffer.from('bad') };
  const digest = await quarantine.record([bytes]);
  assert.match(digest, /^[0-9a-f]{64}$/);
  assert.equal(await refused(bytes), false);
  now = 600;
  assert.equal(await quarantine.record([{ path: bad }]), digest);
  assert.deepEqual(await Promise.all([bytes, { path: bad }, { path: good }, { bytes: Buffer.from('god') }, { path: folder }].map(refused)), [
    true,
    true,
    false,
    false,
    false,
  ]);
  now = 1599;
  assert.equal(await refused(bytes), true);
  now = 1600;
  assert.equal(await refused(bytes), false);
  assert.equal(await quarantine.record([{ path: `${bad}.none` }]), undefined);
  await quarantine.record([bytes]);
  await quarantine.clear([{ path: good }]);
  await quarantine.clear([{ path: bad }]);
  await quarantine.record([bytes]);
  assert.equal(await refused(bytes), false, 'one that was drawn between has ended no two in a row');
  const both = [{ path: good }, bytes];
  for (let i = 0; i < 2; ++i) await quarantine.record(both);
  assert.deepEqual(
    await Promise.all([both, both.toReversed(), [{ path: good }], [{ path: good }, { path: good }], [...both, { path: `${bad}.none` }]].map(refused)),
    [true, false, false, false, false],
    'files that were there together are known together',
  );
  for (let i = 0; i < 2; ++i) await quarantine.record([{ path: good }]);
  assert.equal(await refused([{ path: good }, { path: good }]), true, 'what is known of one holds beside others');
  await quarantine.clear([{ path: good }, { path: good }]);
  assert.equal(await refused([{ path: good }]), false);
  const never = new Quarantine(0);
  for (let i = 0; i < 3; ++i) await never.record([bytes]);
  await never.check([bytes]);
});

test('starts that fail are tried more and more rarely, and five in a minute are too many', () => {
  let now = 0;
  const breaker = new Breaker(() => now);
  const pauses = [];
  for (let i = 0; i < 4; ++i) {
    pauses.push(breaker.pause);
    breaker.fail();
    assert.equal(breaker.isOpen, false);
  }
  assert.deepEqual(pauses, [0, 100, 200, 400]);
  breaker.fail();
  assert.equal(breaker.isOpen, true);
  for (let i = 0; i < 9; ++i) breaker.fail();
  assert.equal(breaker.pause, 5000);
  now = 60_001;
  assert.equal(breaker.isOpen, false, 'a minute later');
  breaker.fail();
  breaker.succeed();
  assert.deepEqual([breaker.isOpen, breaker.pause], [false, 0]);
});

/** A worker that starts as told. */
function fakeWorker(failure) {
  const ready = failure ? Promise.reject(failure) : Promise.resolve({});
  ready.catch(() => {});
  return { ready, ended: failure ? Promise.resolve() : new Promise(() => {}), jobs: 0, pid: 0, held: new HeldModels(0), close: async () => {} };
}

test('workers that do not start: jobs are refused by a typed error, until one starts', async () => {
  let failure = new Error('no GL');
  const fails = new Breaker();
  Object.defineProperty(fails, 'pause', { get: () => 1 });
  const workers = new Workers({ size: 1, recycle: { jobs: 1, bytes: 1 } }, { start: () => fakeWorker(failure), breaker: fails });
  assert.equal(await errorOf(awake(workers.open())), failure);
  const error = await errorOf(awake(workers.take(() => false)));
  assert.deepEqual(
    [error?.code, error?.retryable, error?.message],
    ['X_WORKERS', true, 'the workers of the pool do not start (no GL); it tries again by itself'],
  );
  assert.throws(() => workers.take(() => false), { code: 'X_WORKERS' });
  failure = undefined;
  while (fails.isOpen) await new Promise((resolve) => setTimeout(resolve, 1));
  assert.ok(await awake(workers.take(() => false)));
  await workers.close();
});

test('models that a worker holds: those that were used last', () => {
  const held = new HeldModels(10);
  held.use(1, 4);
  held.use(2, 4);
  assert.deepEqual(held.trim(), []);
  held.use(1);
  held.use(3, 4);
  assert.deepEqual(held.trim(), [2]);
  assert.deepEqual(
    [1, 2, 3].map((id) => held.has(id)),
    [true, false, true],
  );
  held.use(4, 40);
  assert.deepEqual(held.trim(), [1, 3, 4]);
});

test('a worker gets no secret of the environment, and its share of the cores', () => {
  const from = { PATH: '/bin', AWS_SECRET_ACCESS_KEY: 'x', DATABASE_URL: 'x', NODE_OPTIONS: 'x', MESA_DEBUG: '1', TELAR_BUILD_DIR: '/b', LC_ALL: 'C' };
  const secrets = { TELAR_SIGN_KEY: '00', TELAR_SIGN_SALT: '11' };
  const { GLIBC_TUNABLES, ...env } = workerEnvironment(1000, { from: { ...from, ...secrets }, library: '/guard.so' });
  const own = {
    LP_NUM_THREADS: '0',
    UV_USE_IO_URING: '0',
    MESA_SHADER_CACHE_DISABLE: 'true',
    LD_PRELOAD: '/guard.so',
    TELAR_IS_WORKER: '1',
    TELAR_WORKER_FOLDERS: '',
  };
  assert.deepEqual(env, { PATH: '/bin', MESA_DEBUG: '1', TELAR_BUILD_DIR: '/b', LC_ALL: 'C', ...own });
  assert.equal(workerEnvironment(1, { from: { LP_NUM_THREADS: '7' } }).LP_NUM_THREADS, '7', 'what the operator says counts');
  assert.deepEqual([threadsOfEach(1, 8), threadsOfEach(3, 8), threadsOfEach(8, 8), threadsOfEach(9, 8)], [8, 2, 0, 0]);
});

test('what counts failed allocations is preloaded before what the caller preloads, and not beside a sanitizer', () => {
  const preloaded = (LD_PRELOAD, library = '/guard.so') => workerEnvironment(1, { from: { LD_PRELOAD }, library }).LD_PRELOAD;
  assert.equal(preloaded('/lib/libjemalloc.so.2'), '/guard.so /lib/libjemalloc.so.2');
  for (const sanitizer of ['/lib/libasan.so.8', '/lib/libclang_rt.asan-x86_64.so']) assert.equal(preloaded(sanitizer), sanitizer);
  assert.equal(preloaded('/lib/other.so', null), '/lib/other.so');
});

test('where that library cannot be preloaded, the reason is told', (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-guard-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const addonIn = (name, has = true) => {
    mkdirSync(path.join(folder, name));
    if (has) writeFileSync(path.join(folder, name, 'libtelar_worker.so'), '');
    return path.join(folder, name, 'telar.node');
  };
  assert.deepEqual(libraryBeside(addonIn('good')), { file: path.join(folder, 'good/libtelar_worker.so'), failure: null });
  assert.match(libraryBeside(addonIn('without', false)).failure, /^libtelar_worker.so is not beside telar.node$/);
  for (const name of ['a b', 'a:b', 'a$LIB']) assert.match(libraryBeside(addonIn(name)).failure, /^LD_PRELOAD takes no path with a space/);
});

test('workers by default: one a core, as far as the memory goes', () => {
  const GIB = 2 ** 30;
  assert.equal(defaultSize(2 * GIB, { cores: 4, totalBytes: 64 * GIB }), 4);
  assert.equal(defaultSize(2 * GIB, { cores: 16, totalBytes: 16 * GIB }), 6);
  assert.equal(defaultSize(2 * GIB, { cores: 2, totalBytes: GIB }), 1);
  assert.equal(usableBytes(6 * GIB, 64 * GIB), 6 * GIB, 'a container');
  for (const none of [0, undefined, 2 ** 64]) assert.equal(usableBytes(none, 64 * GIB), 64 * GIB);
  const options = poolOptions({ memoryBytes: undefined }, []);
  assert.equal(options.bound.memoryBytes, DEFAULTS.memoryBytes);
});

test('which shots have no bound on their time', async () => {
  const long = (...shots) => hasLongShot(shots);
  assert.equal(await long({}, { quality: 'high' }), true);
  assert.equal(await long({ quality: 'reference' }), true);
  assert.equal(await long({ quality: { samples: 64 } }), true);
  assert.equal(await long({}, { quality: 'draft' }, { quality: 'none such' }, { quality: { samples: 4 } }), false);
  for (const goal of [{ maxError: 0.02 }, { budgetMs: 100 }]) assert.equal(await long({ quality: goal }), true);
  assert.equal(await long({ quality: null }, { look: 'none such' }), false);
  assert.equal(await hasLongShot([]), false);
});
