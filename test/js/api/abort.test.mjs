import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { createRendererOn } from '../../../js/api/renderer.mjs';
import { SHOT, model, native, openRenderer } from './support/double.mjs';

let renderer;
before(async () => { renderer = await openRenderer(); });
after(() => renderer.close());

/** Milliseconds from an abort, `after` ms into the job, to the rejection, which must carry the very reason. */
async function abortAfter(ms, start) {
  const controller = new AbortController();
  const reason = new Error('enough');
  const job = start(controller.signal);
  let aborted;
  setTimeout(() => {
    aborted = performance.now();
    controller.abort(reason);
  }, ms);
  await assert.rejects(job, (error) => error === reason);
  return performance.now() - aborted;
}

for (const stage of ['load', 'draw', 'encode']) {
  test(`an abort during ${stage} rejects at once, and the work stops`, async () => {
    const late = await abortAfter(40, (signal) => renderer.render(model({ [`${stage}Ms`]: 2000 }), SHOT, { signal }));
    assert.ok(late < 25, `${late} ms after the abort`);
    const start = performance.now();
    await renderer.render(model(), SHOT);
    assert.ok(performance.now() - start < 100, 'the thread is free again');
  });
}

test('an abort of load()', async () => {
  assert.ok((await abortAfter(30, (signal) => renderer.load(model({ loadMs: 2000 }), { signal }))) < 25);
});

test('an abort of a job that waits behind others leaves those alone', async () => {
  const others = Array.from({ length: 8 }, () => renderer.render(model({ drawMs: 30 }), SHOT));
  assert.ok((await abortAfter(20, (signal) => renderer.render(model({ drawMs: 2000 }), SHOT, { signal }))) < 25);
  assert.equal((await Promise.all(others)).length, 8);
});

test('an abort of a drawn job in the renderer\'s own queue', async () => {
  const busy = renderer.render(model({ drawMs: 120 }), SHOT);
  const start = performance.now();
  const late = await abortAfter(30, (signal) => renderer.render(model({ drawMs: 2000 }), SHOT, { signal }));
  assert.ok(late < 25, `${late} ms`);
  await busy;
  assert.ok(performance.now() - start < 400);
});

test('an abort of renderAll() stops all of its frames', async () => {
  const shots = Array.from({ length: 20 }, () => SHOT);
  assert.ok((await abortAfter(60, (signal) => renderer.renderAll(model({ drawMs: 30 }), shots, { signal }))) < 25);
  const start = performance.now();
  await renderer.render(model(), SHOT);
  assert.ok(performance.now() - start < 120);
});

test('a frame that fails stops the others of renderAll()', async () => {
  const fail = { stage: 'draw', as: 'error' };
  const start = performance.now();
  await assert.rejects(renderer.renderAll(model({ drawMs: 40, fail }), Array.from({ length: 20 }, () => SHOT)), { code: 'L_VERTICES' });
  assert.ok(performance.now() - start < 300);
});

test('an abort while the context is made', async () => {
  const start = performance.now();
  await abortAfter(30, (signal) => createRendererOn(native, { cacheDirectory: '/tmp/slow', signal }));
  assert.ok(performance.now() - start < 120);
  await sleep(250); // the late renderer closes itself
});

test('an aborted signal starts nothing', async () => {
  const reason = new Error('before');
  const signal = AbortSignal.abort(reason);
  const same = (error) => error === reason;
  await assert.rejects(renderer.render(model({ loadMs: 500 }), SHOT, { signal }), same);
  await assert.rejects(renderer.load(model({ loadMs: 500 }), { signal }), same);
  await assert.rejects(renderer.renderAll(model({ loadMs: 500 }), [SHOT], { signal }), same);
  await assert.rejects(createRendererOn(native, { signal }), same);
});

test('reasons of the platform pass through', async () => {
  await assert.rejects(renderer.render(model({ drawMs: 2000 }), SHOT, { signal: AbortSignal.timeout(30) }), { name: 'TimeoutError' });
  const controller = new AbortController();
  setTimeout(() => controller.abort(), 20);
  await assert.rejects(renderer.render(model({ drawMs: 2000 }), SHOT, { signal: controller.signal }), { name: 'AbortError' });
});

test('a signal that never fires keeps no listener, and an abort after the end changes nothing', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  let listeners = 0;
  for (const [method, step] of [['addEventListener', 1], ['removeEventListener', -1]]) {
    const original = signal[method].bind(signal);
    signal[method] = (...args) => { listeners += step; original(...args); };
  }
  const { data } = await renderer.render(model(), SHOT, { signal });
  await renderer.renderAll(model(), [SHOT, SHOT], { signal });
  await sleep(0);
  assert.equal(listeners, 0);
  controller.abort();
  assert.ok(data.length > 0);
});

test('random aborts, 100 times, leave a renderer that draws', async () => {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const jobs = Array.from({ length: 100 }, () => {
    const controller = new AbortController();
    setTimeout(() => controller.abort(), random() * 400);
    return renderer.render(model({ loadMs: 3, drawMs: 5, encodeMs: 3 }), SHOT, { signal: controller.signal });
  });
  const outcomes = await Promise.allSettled(jobs);
  for (const { status, reason } of outcomes) assert.ok(status === 'fulfilled' || reason.name === 'AbortError', reason?.stack);
  assert.ok(outcomes.some(({ status }) => status === 'rejected') && outcomes.some(({ status }) => status === 'fulfilled'));
  await renderer.render(model(), SHOT);
  assert.equal(await renderer.liveObjects(), 0);
});

test('one signal for many jobs: no leak warning, all reject', async () => {
  const warnings = [];
  const onWarning = (warning) => warnings.push(warning.name);
  process.on('warning', onWarning);
  const controller = new AbortController();
  const jobs = Array.from({ length: 30 }, () => renderer.render(model({ drawMs: 50 }), SHOT, { signal: controller.signal }));
  setTimeout(() => controller.abort(), 20);
  const outcomes = await Promise.allSettled(jobs);
  assert.ok(outcomes.every(({ reason }) => reason?.name === 'AbortError'));
  await sleep(5);
  process.off('warning', onWarning);
  assert.deepEqual(warnings, []);
});
