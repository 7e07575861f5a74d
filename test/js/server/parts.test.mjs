import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { Readable } from 'node:stream';
import { mock, test } from 'node:test';
import { digestOf } from '../../../js/api/digest.mjs';
import { isHandedOver, knownDigest } from '../../../js/api/handed_over.mjs';
import * as receiving from '../../../js/server/receive.mjs';
import { Admission } from '../../../js/server/admission.mjs';
import { jobHandlers } from '../../../js/server/job_handlers.mjs';
import { negotiate } from '../../../js/server/negotiate.mjs';
import { waitOf } from '../../../js/server/scope.mjs';
import { importMutant } from './mutants.mjs';

const OFFERED = ['image/png', 'image/webp', 'image/jpeg', 'application/json'];

/** Header and what it gets; RFC 9110, 12.5.1. */
const NEGOTIATED = [
  [undefined, 'image/png'],
  ['', 'image/png'],
  ['*/*', 'image/png'],
  ['image/*', 'image/png'],
  ['application/json', 'application/json'],
  ['IMAGE/WEBP', 'image/webp'],
  ['image/webp, image/jpeg', 'image/webp'],
  ['image/jpeg, image/webp;q=0.9', 'image/jpeg'],
  ['image/*;q=0.5, image/jpeg;q=0.9', 'image/jpeg'],
  ['image/png;q=0, */*', 'image/webp'],
  ['image/png;q=0.1, image/*;q=0.2', 'image/webp'],
  ['image/avif,image/webp,*/*;q=0.8', 'image/webp'],
  ['text/html, */*;q=0.1', 'image/png'],
  ['nonsense, image/jpeg', 'image/jpeg'],
  ['image/jpeg;q=2, image/webp;q=0.1', 'image/webp'],
];
for (const [accept, type] of NEGOTIATED) {
  test(`accept: ${accept} gets ${type}`, () => assert.equal(negotiate(accept, OFFERED), type));
}

for (const accept of ['text/html', 'image/png;q=0, image/avif', '*/*;q=0', 'nonsense']) {
  test(`accept: ${accept} gets nothing`, () => assert.throws(() => negotiate(accept, OFFERED), { code: 'E_ACCEPT' }));
}

const WAITS = { 'wait=2': 2000, 'respond-async, wait=3': 3000, 'WAIT=1;x': 1000, 'wait=100': 5000, 'await=1': 5000, 'wait=-1': 5000, '': 5000 };
for (const [prefer, ms] of Object.entries(WAITS)) {
  test(`prefer: ${prefer} waits ${ms} ms of at most 5000`, () => assert.equal(waitOf({ headers: { prefer } }, 5000), ms));
}

/** A job, and what ends it. */
function job() {
  let end;
  const done = new Promise((resolve) => {
    end = resolve;
  });
  return { task: () => done, end };
}

const alive = () => new AbortController().signal;
const errorOf = (promise) =>
  promise.then(
    () => undefined,
    ({ code }) => code,
  );

test('admission: as many run as there are places, the rest in order, one more is refused', async () => {
  const admission = new Admission({ places: 2, waiting: 2, uploads: 1, uploadBytes: 100 });
  const order = [];
  const jobs = Array.from({ length: 4 }, job);
  const ended = jobs.map(({ task }, i) =>
    admission.run(() => {
      order.push(i);
      return task();
    }, alive()),
  );
  await Promise.resolve();
  assert.deepEqual([admission.running, admission.waiting, order], [2, 2, [0, 1]]);
  assert.equal(await errorOf(admission.run(() => {}, alive())), 'X_BUSY');
  assert.throws(() => admission.check(), { code: 'X_BUSY' });
  jobs[1].end();
  await ended[1];
  assert.deepEqual([admission.running, admission.waiting, order], [2, 1, [0, 1, 2]]);
  for (const { end } of jobs) end();
  await Promise.all(ended);
  assert.deepEqual([admission.running, admission.waiting, order], [0, 0, [0, 1, 2, 3]]);
});

test('admission: a job that fails gives its place back, one that is called off while it waits leaves the queue', async () => {
  const admission = new Admission({ places: 1, waiting: 1, uploads: 1, uploadBytes: 100 });
  const first = job();
  const running = admission.run(first.task, alive());
  const controller = new AbortController();
  const waiting = admission.run(() => assert.fail('it was called off'), controller.signal);
  controller.abort(new Error('gone'));
  await assert.rejects(waiting, /gone/);
  assert.equal(admission.waiting, 0);
  const next = admission.run(() => Promise.reject(new Error('no')), alive());
  first.end();
  await running;
  await assert.rejects(next, /no/);
  assert.equal(admission.running, 0);
  assert.equal(await admission.run(async () => 5, alive()), 5);
});

test('admission: closed, no body is received, and what waits or was received still gets its turn', async () => {
  const admission = new Admission({ places: 1, waiting: 2, uploads: 1, uploadBytes: 100 });
  const first = job();
  const all = [admission.run(first.task, alive()), admission.run(async () => 'second', alive())];
  admission.close();
  all.push(admission.run(async () => 'received before', alive()));
  assert.equal(await errorOf(admission.receive(() => {})), 'X_SHUTDOWN');
  first.end('first');
  assert.deepEqual(await Promise.all(all), ['first', 'second', 'received before']);
});

test('admission: bytes of all requests together, until their answers are there; one alone may take more', () => {
  const admission = new Admission({ places: 1, waiting: 1, uploads: 1, uploadBytes: 100 });
  const [first, second, third] = [admission.hold(), admission.hold(), admission.hold()];
  first.grow(60);
  first.grow(30);
  second.grow(40);
  assert.equal(admission.heldBytes, 100);
  assert.throws(() => second.grow(41), { code: 'X_BUSY', message: 'the requests of this service have all the memory that they may' });
  assert.throws(() => third.grow(1), { code: 'X_BUSY' });
  first.release();
  first.release();
  third.grow(60);
  assert.equal(admission.heldBytes, 100);
  for (const held of [second, third]) held.release();
  first.grow(1000);
  assert.equal(admission.heldBytes, 1000, 'nobody else has any');
  assert.throws(() => second.grow(1), { code: 'X_BUSY' });
  first.release();
  assert.equal(admission.heldBytes, 0);
});

test('admission: retry-after grows with what waits and what jobs take, within 1 and 60 s', async () => {
  const admission = new Admission({ places: 1, waiting: 100, uploads: 1, uploadBytes: 100 });
  assert.equal(admission.retryAfter, 1);
  const first = job();
  const all = [admission.run(first.task, alive()), ...Array.from({ length: 99 }, () => admission.run(() => {}, alive()))];
  assert.equal(admission.retryAfter, 60);
  first.end();
  await Promise.all(all);
  assert.equal(admission.retryAfter, 1);
});

/** Events of one job for a client that reads, or does not; what was written, and how the job changes. */
async function events(handlers, facts = {}) {
  const written = [];
  const closing = [];
  const raw = { writableNeedDrain: false, writeHead: () => {}, write: (text) => written.push(text), end: () => written.push('end'), ...facts };
  raw.once = (name, then) => closing.push(then);
  let tell;
  const state = { id: 'a', kind: 'thumbnail', state: 'running', progress: 0.1, created: 0 };
  const watched = { get: async () => state, watch: (id, listener) => [(tell = listener), () => (tell = undefined)][1] };
  await handlers(watched, '', () => {}).jobEvents({ method: 'GET', params: { id: 'a' } }, { getHeaders: () => ({}), hijack: () => {}, raw });
  const change = (facts) => tell?.({ ...state, ...facts });
  return { raw, written, change, isWatched: () => tell !== undefined, leave: () => closing.forEach((then) => then()) };
}

const EVENTS = {
  async 'events: a client that does not read misses progress, and no end'(handlers) {
    const { raw, written, change, isWatched } = await events(handlers);
    written.length = 0;
    raw.writableNeedDrain = true;
    change({ progress: 0.5 });
    assert.deepEqual(written, []);
    change({ state: 'done', progress: 1 });
    assert.match(written[0], /^event: done\n/);
    assert.deepEqual([written[1], written.length, isWatched()], ['end', 2, false]);
  },
  async 'events: a sign of life each 15 s until the job is over'(handlers) {
    const { written, change } = await events(handlers);
    written.length = 0;
    mock.timers.tick(15_000);
    assert.deepEqual(written, [':\n\n']);
    change({ state: 'done' });
    mock.timers.tick(60_000);
    assert.equal(written.at(-1), 'end');
  },
  async 'events: nothing is told of a job whose client is gone'(handlers) {
    const { leave, isWatched } = await events(handlers);
    assert.ok(isWatched());
    leave();
    assert.ok(!isWatched());
  },
  async 'events: nor of one whose client went away before'(handlers) {
    const { written, isWatched } = await events(handlers, { destroyed: true });
    assert.deepEqual([written, isWatched()], [[], false]);
  },
};
const EVENT_FAULTS = [
  ['if (!isOver(state) && raw.writableNeedDrain) return;', ''],
  ['clearInterval(beat);', ''],
  ["raw.once('close', stop);", ''],
  ['if (raw.destroyed) return;', ''],
];
for (const [i, [name, check]] of Object.entries(EVENTS).entries()) {
  test(name, async (t) => {
    const planted = await importMutant([['job_handlers.mjs', ...EVENT_FAULTS[i]]], 'job_handlers.mjs');
    // A planted fault leaves its signs of life behind, for which this process would wait.
    mock.timers.enable({ apis: ['setInterval'] });
    t.after(() => mock.timers.reset());
    await check(jobHandlers);
    await assert.rejects(check(planted.jobHandlers), { name: 'AssertionError' });
  });
}

/** A request of these pieces. */
const messageOf = (pieces, headers = {}) => Object.assign(Readable.from(pieces.map((text) => Buffer.from(text))), { headers });
const BOUNDS = { maxBytes: 100, ms: 60_000, signal: new AbortController().signal, held: { grow: () => {}, release: () => {} } };
const sha256 = (text) => createHash('sha256').update(text).digest('hex');

async function checkHashed({ receiveHashed }) {
  for (const headers of [{}, { 'content-length': '6' }]) {
    const bytes = await receiveHashed(messageOf(['glT', 'F', '..'], headers), BOUNDS);
    assert.deepEqual([String(bytes), knownDigest(bytes), await digestOf(bytes)], ['glTF..', sha256('glTF..'), sha256('glTF..')]);
    assert.equal(knownDigest(new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength)), sha256('glTF..'), 'any view of them');
    for (const part of [bytes.subarray(1), bytes.subarray(0, 5), Buffer.from(bytes)]) {
      assert.deepEqual([isHandedOver(part), await digestOf(part)], [false, sha256(part)]);
    }
  }
}

test('the SHA-256 of a body is found as it comes, and known by its memory', () => checkHashed(receiving));

for (const [right, wrong] of [
  ['(chunk) => hash.update(chunk)', '(chunk) => hash.update(chunk.subarray(1))'],
  ["return handOver(bytes, hash.digest('hex'));", 'return bytes;'],
]) {
  test(`planted: ${wrong}`, async () => {
    await assert.rejects(checkHashed(await importMutant([['receive.mjs', right, wrong]], 'receive.mjs')));
  });
}
